// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's decimaters on the root of a tree: with the module, and with the mesh that hides its operations.
#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "adapters/openmesh/root_mesh.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/openmesh/mod_multimesh.hpp"
#include "multimesh/validate.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

using namespace OpenMesh::Decimater;
using openmesh::ModMultimeshT;
using Problems = std::vector<std::string>;

/// What a decimation may not change.
struct Kept {
  std::vector<std::array<std::size_t, 2>> meshes;  // components, boundaries
  std::size_t flipped = 0;
  friend bool operator==(const Kept&, const Kept&) = default;
};

template <class Mesh>
Kept kept(Mesh& mesh, const MultiMesh& tree) {
  Kept kept;
  for (const NodeId n : tree.nodes()) {
    const MeshReport r = report(tree.mesh(n));
    kept.meshes.push_back({r.components, r.boundary});
  }
  kept.flipped = mirrored_triangles(mesh);
  return kept;
}

template <class Mesh>
NodeId add_curves(openmesh::Attached<Mesh>& attached, Mesh& mesh, int rows) {
  // Every fifth line in both directions: curves with many junctions.
  return attached.add_edges([&mesh, rows](OpenMesh::EdgeHandle e) {
    const auto h = mesh.halfedge_handle(e, 0);
    const int v = mesh.from_vertex_handle(h).idx(), w = mesh.to_vertex_handle(h).idx();
    return (v % rows == w % rows && v % rows % 5 == 0) || (v / rows == w / rows && v / rows % 5 == 0);
  });
}

template <class Mesh>
class DecimaterOfOpenMesh : public testing::Test {};
using Meshes = testing::Types<DoubleMesh, FloatMesh>;
TYPED_TEST_SUITE(DecimaterOfOpenMesh, Meshes);

TYPED_TEST(DecimaterOfOpenMesh, DecimatesAllMeshesByTheModule) {
  for (const bool open : {false, true}) {
    TypeParam mesh;
    make_torus(mesh, 60, 30, 3, open);
    const std::size_t faces = mesh.n_faces();
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    (void)add_curves(attached, mesh, 30 + open);
    attached.forbid_flips();
    const Kept before = kept(mesh, attached.tree());
    EXPECT_EQ(before.flipped, 0U);

    DecimaterT<TypeParam> decimater(mesh);
    typename ModMultimeshT<TypeParam>::Handle tree;
    typename ModQuadricT<TypeParam>::Handle quadric;
    decimater.add(tree);
    decimater.add(quadric);
    decimater.module(tree).drive(attached);
    decimater.module(quadric).unset_max_err();
    ASSERT_TRUE(decimater.initialize());
    const std::size_t collapses = decimater.decimate();
    const auto& operations = attached.operations().statistics();
    EXPECT_EQ(operations.done + decimater.module(tree).stale(), collapses);
    attached.tree().require_in_step();
    EXPECT_EQ(validate(attached.tree()), Problems{});
    EXPECT_EQ(kept(mesh, attached.tree()), before);
    attached.garbage_collection();
    EXPECT_LT(mesh.n_faces(), faces / 3);
    EXPECT_EQ(kept(mesh, attached.tree()), before);
  }
}

/// Decimates to a fifth of the faces by the module. The edges of `curves` carry the feature bit, and
/// `number`; no others.
template <class Mesh>
void expect_features_kept(Mesh& mesh, openmesh::Attached<Mesh>& attached, NodeId curves,
                          OpenMesh::EPropHandleT<int> number) {
  DecimaterT<Mesh> decimater(mesh);
  typename ModMultimeshT<Mesh>::Handle tree;
  typename ModQuadricT<Mesh>::Handle quadric;
  decimater.add(tree);
  decimater.add(quadric);
  decimater.module(tree).drive(attached);
  decimater.module(quadric).unset_max_err();
  ASSERT_TRUE(decimater.initialize());
  (void)decimater.decimate_to_faces(0, mesh.n_faces() / 5);
  attached.garbage_collection();
  const auto& m = attached.tree();
  std::vector<bool> in_curve(mesh.n_edges());
  for (Index e = 0; e < m.mesh(curves).capacity(1); ++e)
    in_curve[m.mesh(NodeId::root).simplex(m.to_parent(curves, m.mesh(curves).dart_of(1, e)), 1)] = true;
  std::size_t on_curves = 0;
  for (const auto e : mesh.edges()) {
    const bool wanted = in_curve[static_cast<std::size_t>(e.idx())];
    on_curves += wanted;
    EXPECT_EQ(mesh.status(e).feature(), wanted) << "edge " << e.idx();
    EXPECT_EQ(mesh.property(number, e) != 0, wanted) << "edge " << e.idx();
  }
  EXPECT_GT(on_curves, 10U);
}

/// How many vertices have one edge with the feature bit.
template <class Mesh>
std::size_t ends_of_features(const Mesh& mesh) {
  std::size_t ends = 0;
  for (const auto v : mesh.vertices()) {
    std::size_t at = 0;
    for (const auto e : mesh.ve_range(v)) at += mesh.status(e).feature();
    ends += at == 1;
  }
  return ends;
}

template <class Mesh, class IsFeature>
void decimate_with_features(Mesh& mesh, const IsFeature& is_feature) {
  mesh.request_edge_status(), mesh.request_vertex_status(), mesh.request_face_status();
  OpenMesh::EPropHandleT<int> number;
  mesh.add_property(number, "number");
  for (const auto e : mesh.edges()) {
    if (!is_feature(e)) continue;
    mesh.status(e).set_feature(true);
    mesh.property(number, e) = 1 + e.idx();
  }
  const std::size_t ends = ends_of_features(mesh);
  {
    openmesh::Attached attached(mesh);
    const NodeId curves = attached.add_features();
    expect_features_kept(mesh, attached, curves, number);
  }
  EXPECT_EQ(ends_of_features(mesh), ends);
}

TYPED_TEST(DecimaterOfOpenMesh, KeepsFeatureBitsOnTheCurves) {
  for (const bool open : {false, true}) {
    TypeParam mesh;
    make_torus(mesh, 60, 30, 3, open);
    const int rows = 30 + open;
    // Zigzags, so that triangles have two of their sides on a curve.
    decimate_with_features(mesh, [&](OpenMesh::EdgeHandle e) {
      const auto h = mesh.halfedge_handle(e, 0);
      const int v = mesh.from_vertex_handle(h).idx(), w = mesh.to_vertex_handle(h).idx();
      const bool along = v / rows == w / rows, across = v % rows == w % rows;
      return (along && v / rows % 7 == 0) || (across && v % rows % 6 == v / rows % 2);
    });
  }
}

TEST(FeatureBits, StayOnTheCurvesOfModels) {
  const std::string shared = MULTIMESH_SHARED_DATA;
  for (const char* name : {"fandisk.off", "turbine.off", "couplingdown.off"}) {
    DoubleMesh mesh;
    if (shared.empty() || !OpenMesh::IO::read_mesh(mesh, shared + "/surface_closed/" + name))
      GTEST_SKIP() << "no " << name;
    SCOPED_TRACE(name);
    mesh.request_face_normals();
    mesh.update_face_normals();
    decimate_with_features(mesh, [&](OpenMesh::EdgeHandle e) {
      return std::abs(mesh.calc_dihedral_angle_fast(e)) > 40 * 3.14159265 / 180;
    });
  }
}

TYPED_TEST(DecimaterOfOpenMesh, HasOtherModulesBesideIt) {
  TypeParam mesh;
  make_torus(mesh, 40, 20, 2, true);
  const std::size_t faces = mesh.n_faces();
  mesh.request_face_normals();
  mesh.update_face_normals();
  openmesh::Attached attached(mesh);
  (void)attached.add_texture();
  DecimaterT<TypeParam> decimater(mesh);
  typename ModMultimeshT<TypeParam>::Handle tree;
  typename ModQuadricT<TypeParam>::Handle quadric;
  typename ModNormalFlippingT<TypeParam>::Handle flipping;
  typename ModAspectRatioT<TypeParam>::Handle ratio;
  typename ModHausdorffT<TypeParam>::Handle hausdorff;
  decimater.add(flipping), decimater.add(ratio), decimater.add(tree);
  decimater.add(hausdorff), decimater.add(quadric);
  decimater.module(tree).drive(attached);
  decimater.module(hausdorff).set_tolerance(typename TypeParam::Scalar(0.2));
  decimater.module(ratio).set_aspect_ratio(10);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to_faces(0, faces / 2), 0U);
  EXPECT_EQ(validate(attached.tree()), Problems{});
  attached.garbage_collection();
  EXPECT_LE(mesh.n_faces(), faces / 2 + 10);
}

TYPED_TEST(DecimaterOfOpenMesh, OfOtherKindsDo) {
  TypeParam mesh;
  make_torus(mesh, 40, 20, 2, false);
  openmesh::Attached attached(mesh);
  (void)attached.add_texture();
  const auto run = [&](auto decimater, const auto& decimate) {
    typename ModMultimeshT<TypeParam>::Handle tree;
    typename ModQuadricT<TypeParam>::Handle quadric;
    decimater->add(tree), decimater->add(quadric);
    decimater->module(tree).drive(attached);
    EXPECT_TRUE(decimater->initialize());
    EXPECT_GT(decimate(*decimater), 0U);
    EXPECT_EQ(validate(attached.tree()), Problems{});
    attached.garbage_collection();  // ModQuadric cannot begin on a mesh with dead faces
  };
  run(std::make_unique<McDecimaterT<TypeParam>>(mesh), [](auto& d) { return d.decimate(200); });
  run(std::make_unique<MixedDecimaterT<TypeParam>>(mesh), [](auto& d) { return d.decimate(200, 0.5F); });
}

TYPED_TEST(DecimaterOfOpenMesh, NeedsItsTree) {
  TypeParam mesh;
  make_torus(mesh, 10, 10, 1, false);
  DecimaterT<TypeParam> decimater(mesh);
  typename ModMultimeshT<TypeParam>::Handle tree;
  typename ModQuadricT<TypeParam>::Handle quadric;
  decimater.add(tree), decimater.add(quadric);
  EXPECT_THROW(decimater.initialize(), UsageError);
}

/// Rejects nothing in advance: every decision is stale.
template <class MeshT>
class Blind : public ModMultimeshT<MeshT> {
 public:
  DECIMATING_MODULE(Blind, MeshT, Blind);
  using ModMultimeshT<MeshT>::ModMultimeshT;
  float collapse_priority(const CollapseInfo&) override { return 0; }
};

TYPED_TEST(DecimaterOfOpenMesh, WithStaleOpinionsLeavesTheTreeValid) {
  for (const bool open : {false, true}) {
    TypeParam mesh;
    make_torus(mesh, 30, 30, 5, open);
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    (void)add_curves(attached, mesh, 30 + open);
    const Kept before = kept(mesh, attached.tree());
    DecimaterT<TypeParam> decimater(mesh);
    typename Blind<TypeParam>::Handle tree;
    typename ModQuadricT<TypeParam>::Handle quadric;
    decimater.add(tree), decimater.add(quadric);
    decimater.module(tree).drive(attached);
    ASSERT_TRUE(decimater.initialize());
    for (int i = 0; i < 10; ++i) {
      (void)decimater.decimate(100);
      attached.tree().require_in_step();
      ASSERT_EQ(validate(attached.tree()), Problems{});
    }
    EXPECT_GT(decimater.module(tree).stale(), 10U);
    EXPECT_EQ(kept(mesh, attached.tree()).meshes, before.meshes);
  }
}

template <class Mesh>
class RootMeshOfOpenMesh : public testing::Test {};
TYPED_TEST_SUITE(RootMeshOfOpenMesh, Meshes);

TYPED_TEST(RootMeshOfOpenMesh, IsDecimatedWithItsTree) {
  using Mesh = openmesh::RootMesh<TypeParam>;
  for (const bool open : {false, true}) {
    Mesh mesh;
    make_torus(mesh, 60, 30, 3, open);
    const std::size_t faces = mesh.n_faces();
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    (void)add_curves(attached, mesh, 30 + open);
    attached.forbid_flips();
    mesh.drive(attached);
    const Kept before = kept(mesh, attached.tree());
    DecimaterT<Mesh> decimater(mesh);
    typename ModQuadricT<Mesh>::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    ASSERT_TRUE(decimater.initialize());
    const std::size_t collapses = decimater.decimate();
    EXPECT_EQ(attached.operations().statistics().done, collapses);
    EXPECT_EQ(mesh.refused(), 0U);  // it asked before
    EXPECT_EQ(validate(attached.tree()), Problems{});
    mesh.garbage_collection();
    EXPECT_LT(mesh.n_faces(), faces / 3);
    EXPECT_EQ(kept(mesh, attached.tree()), before);
    mesh.drive_no_more();
  }
}

TYPED_TEST(RootMeshOfOpenMesh, IsAnOrdinaryMeshOtherwise) {
  openmesh::RootMesh<TypeParam> mesh;
  make_torus(mesh, 10, 10, 1, false);
  TypeParam plain;
  make_torus(plain, 10, 10, 1, false);
  for (auto* m : std::initializer_list<TypeParam*>{&plain, &mesh})
    m->request_vertex_status(), m->request_edge_status(), m->request_face_status();
  const OpenMesh::HalfedgeHandle h(4);
  EXPECT_EQ(mesh.is_collapse_ok(h), plain.is_collapse_ok(h));
  mesh.collapse(h), plain.collapse(h);
  const OpenMesh::EdgeHandle e(50);
  EXPECT_EQ(mesh.is_flip_ok(e), plain.is_flip_ok(e));
  mesh.flip(e), plain.flip(e);
  mesh.split(e, mesh.add_vertex({0, 0, 0})), plain.split(e, plain.add_vertex({0, 0, 0}));
  mesh.garbage_collection(), plain.garbage_collection();
  ASSERT_EQ(mesh.n_halfedges(), plain.n_halfedges());
  for (const auto x : mesh.halfedges()) EXPECT_EQ(mesh.to_vertex_handle(x), plain.to_vertex_handle(x));
}

}  // namespace
}  // namespace multimesh::test
