// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's decimaters on the root of a tree: by the module, and by the mesh that hides its operations.
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "adapters/openmesh/mod_multimesh.hpp"
#include "adapters/openmesh/root_mesh.hpp"
#include "multimesh/algorithms/surface_report.hpp"
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

/// Forbids nothing in advance: every opinion is stale.
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
