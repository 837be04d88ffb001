// SPDX-License-Identifier: BSD-3-Clause
// Subdivision by propagated splits and swaps, beside OpenMesh's own on a mesh alone.
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "multimesh/algorithms/subdivide.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/validate.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

template <class Mesh>
class Subdivide : public testing::Test {};
using Meshes = testing::Types<DoubleMesh, FloatMesh>;
TYPED_TEST_SUITE(Subdivide, Meshes);

/// Triangles by the places of their corners, in an order of their own.
template <class Mesh>
std::vector<std::array<std::array<long, 3>, 3>> triangles(const Mesh& mesh, double unit) {
  std::vector<std::array<std::array<long, 3>, 3>> all;
  for (const auto f : mesh.faces()) {
    auto& t = all.emplace_back();
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(f)) {
      for (std::size_t k = 0; k < 3; ++k)
        t[i][k] = std::lround(double(mesh.point(v)[static_cast<int>(k)]) / unit);
      ++i;
    }
    std::sort(t.begin(), t.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// How far the triangles of one mesh are from those of another, pair by pair, by their corners in any order.
template <class Mesh>
double farthest_triangle(const Mesh& x, const Mesh& y) {
  const auto corners = [](const Mesh& mesh, OpenMesh::FaceHandle f) {
    std::array<typename Mesh::Point, 3> p;
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(f)) p[i++] = mesh.point(v);
    return p;
  };
  std::vector<bool> used(y.n_faces(), false);
  double farthest = 0;
  for (const auto f : x.faces()) {
    const auto p = corners(x, f);
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto g : y.faces()) {
      const auto q = corners(y, g);
      for (std::size_t turn = 0; turn < 3; ++turn) {
        double d = 0;
        for (std::size_t i = 0; i < 3; ++i) d = std::max(d, double((p[i] - q[(i + turn) % 3]).norm()));
        if (d < least) least = d, nearest = static_cast<std::size_t>(g.idx());
      }
    }
    if (used[nearest]) return std::numeric_limits<double>::infinity();
    used[nearest] = true;
    farthest = std::max(farthest, least);
  }
  return farthest;
}

TYPED_TEST(Subdivide, IsThatOfOpenMeshOnAMeshAlone) {
  for (const bool open : {false, true}) {
    TypeParam ours, theirs;
    make_torus(ours, 9, 7, 1, open), make_torus(theirs, 9, 7, 1, open);
    openmesh::Attached attached(ours);
    for (int step = 0; step < 2; ++step) (void)subdivide(embedding(attached), NodeId::root);
    OpenMesh::Subdivider::Uniform::LoopT<TypeParam> loop;
    loop.attach(theirs), loop(2), loop.detach();
    EXPECT_EQ(ours.n_vertices(), theirs.n_vertices());
    ASSERT_EQ(ours.n_faces(), theirs.n_faces());
    EXPECT_LT(farthest_triangle(ours, theirs), 1e-5);
    EXPECT_EQ(validate(attached.tree()), Problems{});
  }
}

TYPED_TEST(Subdivide, DividesAllMeshes) {
  for (const Subdivision scheme : {Subdivision::midpoint, Subdivision::loop}) {
    TypeParam mesh;
    make_torus(mesh, 12, 10, 2, true);
    openmesh::Attached attached(mesh);
    const NodeId texture = attached.add_texture();
    const NodeId curve = attached.add_edges([&](OpenMesh::EdgeHandle e) {
      const auto h = mesh.halfedge_handle(e, 0);
      return mesh.from_vertex_handle(h).idx() % 11 == 3 && mesh.to_vertex_handle(h).idx() % 11 == 3;
    });
    const MeshReport before = report(attached.tree().mesh(texture));
    const std::size_t curve_edges = report(attached.tree().mesh(curve)).edges, faces = mesh.n_faces();
    const SubdivideResult r = subdivide(embedding(attached), NodeId::root, {scheme});
    EXPECT_EQ(r.refused_splits + r.refused_swaps + r.shortened_moves + r.refused_moves, 0U);
    EXPECT_EQ(validate(attached.tree()), Problems{});
    EXPECT_EQ(mesh.n_faces(), 4 * faces);
    const MeshReport after = report(attached.tree().mesh(texture));
    EXPECT_EQ(after.faces, 4 * before.faces);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    EXPECT_EQ(report(attached.tree().mesh(curve)).edges, 2 * curve_edges);
    EXPECT_EQ(mirrored_triangles(mesh), 0U);
  }
}

// Midpoints change no shape, and what is affine stays affine.
TYPED_TEST(Subdivide, ByMidpointsKeepsPlacesInTheTexture) {
  TypeParam mesh;
  make_torus(mesh, 6, 6, 1, true);
  for (const auto v : mesh.vertices())
    mesh.set_point(v, {typename TypeParam::Scalar(v.idx() / 7), typename TypeParam::Scalar(v.idx() % 7), 0});
  for (const auto h : mesh.halfedges()) {
    const auto p = mesh.point(mesh.to_vertex_handle(h));
    mesh.set_texcoord2D(h, {2.0 * double(p[0]) + double(p[1]), double(p[1]) - 3});
  }
  openmesh::Attached attached(mesh);
  (void)attached.add_texture();
  (void)subdivide(embedding(attached), NodeId::root, {Subdivision::midpoint});
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(mesh.to_vertex_handle(h));
      EXPECT_NEAR(mesh.texcoord2D(h)[0], 2.0 * double(p[0]) + double(p[1]), 1e-9);
      EXPECT_NEAR(mesh.texcoord2D(h)[1], double(p[1]) - 3, 1e-9);
    }
}

TYPED_TEST(Subdivide, IsUndoneAsAWhole) {
  TypeParam mesh;
  make_torus(mesh, 8, 6, 2, false);
  openmesh::Attached attached(mesh);
  (void)attached.add_texture();
  const auto before = triangles(mesh, 1e-6);
  int left = 20;
  FunctionInvariant enough("enough", [&](const Event&) {
    if (--left == 0) throw std::runtime_error("enough");
    return true;
  });
  attached.operations().add(enough);
  EXPECT_THROW((void)subdivide(embedding(attached), NodeId::root), std::runtime_error);
  EXPECT_TRUE(triangles(mesh, 1e-6) == before);
  EXPECT_EQ(mesh.n_faces(), before.size());
  EXPECT_EQ(validate(attached.tree()), Problems{});
  attached.tree().require_in_step();
}

TYPED_TEST(Subdivide, SaysWhatIsRefused) {
  TypeParam mesh;
  make_torus(mesh, 8, 6, 2, false);
  openmesh::Attached attached(mesh);
  const std::size_t faces = mesh.n_faces();
  FunctionInvariant no_moves("no moves", [](const Event& e) { return e.operation != Operation::relocate; });
  FunctionInvariant few("few", [&](const Event&) { return mesh.n_vertices() < 60; });
  attached.operations().add(no_moves).add(few);
  const SubdivideResult r = subdivide(embedding(attached), NodeId::root);
  EXPECT_EQ(r.splits + r.refused_splits, 3 * faces / 2);
  EXPECT_GT(r.refused_splits, 0U);
  EXPECT_EQ(r.moves, 0U);
  EXPECT_GT(r.refused_moves, 0U);
  EXPECT_EQ(mesh.n_faces(), faces + 2 * r.splits);
  EXPECT_EQ(validate(attached.tree()), Problems{});
}

}  // namespace
}  // namespace multimesh::test
