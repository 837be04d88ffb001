// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's subdividers and smoothers on the root of a tree.
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LongestEdgeT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include "adapters/openmesh/root_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

template <class Mesh>
class ToolsOfOpenMesh : public testing::Test {};
using Meshes = testing::Types<DoubleMesh, FloatMesh>;
TYPED_TEST_SUITE(ToolsOfOpenMesh, Meshes);

TYPED_TEST(ToolsOfOpenMesh, LongestEdgeSplitsAllMeshes) {
  using Mesh = openmesh::RootMesh<TypeParam>;
  Mesh mesh;
  TypeParam plain;
  for (auto* m : std::initializer_list<TypeParam*>{&plain, &mesh}) make_torus(*m, 12, 8, 2, true);
  openmesh::Attached attached(mesh);
  const NodeId texture = attached.add_texture();
  const NodeId rim = attached.add_boundary();
  mesh.drive(attached);
  OpenMesh::Subdivider::Uniform::LongestEdgeT<Mesh> ours;
  OpenMesh::Subdivider::Uniform::LongestEdgeT<TypeParam> theirs;
  ours.set_max_edge_length(0.5), theirs.set_max_edge_length(0.5);
  ours.attach(mesh), theirs.attach(plain);
  ours(1), theirs(1);
  ours.detach(), theirs.detach();
  EXPECT_EQ(validate(attached.tree()), Problems{});
  EXPECT_EQ(attached.tree().mesh(texture).capacity(2), mesh.n_faces());
  EXPECT_GT(attached.tree().mesh(rim).capacity(1), Index{40});
  // As without a tree, but for the order of edges of the same length.
  EXPECT_EQ(mesh.n_faces(), plain.n_faces());
  for (const auto e : mesh.edges()) EXPECT_LE(double(mesh.calc_edge_length(e)), 0.5 + 1e-6);
}

TYPED_TEST(ToolsOfOpenMesh, ThatLinkHalfedgesThemselvesAreNoticed) {
  TypeParam mesh;
  make_torus(mesh, 10, 10, 1, false);
  openmesh::Attached attached(mesh);
  const NodeId texture = attached.add_texture();
  OpenMesh::Subdivider::Uniform::LoopT<TypeParam> loop;
  loop.attach(mesh);
  loop(1);
  loop.detach();
  EXPECT_THROW((void)attached.split(OpenMesh::EdgeHandle(3)), OutOfStepError);
  EXPECT_THROW(attached.resync(), OutOfStepError);
  (void)attached.tree().detach(texture);
  attached.resync();
  EXPECT_TRUE(attached.split(OpenMesh::EdgeHandle(3)));
  EXPECT_EQ(validate(attached.tree()), Problems{});
}

TYPED_TEST(ToolsOfOpenMesh, SmoothersMovePointsOnly) {
  TypeParam mesh;
  make_torus(mesh, 20, 10, 2, true);
  openmesh::Attached attached(mesh);
  const NodeId texture = attached.add_texture();
  const auto before = mesh.point(OpenMesh::VertexHandle(57));
  OpenMesh::Smoother::JacobiLaplaceSmootherT<TypeParam> smoother(mesh);
  smoother.initialize(OpenMesh::Smoother::SmootherT<TypeParam>::Tangential_and_Normal,
                      OpenMesh::Smoother::SmootherT<TypeParam>::C0);
  smoother.smooth(3);
  EXPECT_GT((mesh.point(OpenMesh::VertexHandle(57)) - before).norm(), 1e-4);
  attached.tree().require_in_step();
  EXPECT_EQ(validate(attached.tree()), Problems{});
  const auto e = mesh.edge_handle(mesh.find_halfedge(OpenMesh::VertexHandle(57), OpenMesh::VertexHandle(58)));
  const auto middle = mesh.calc_edge_midpoint(e);
  const Outcome o = attached.split(e);
  ASSERT_TRUE(o);
  EXPECT_NEAR(double((mesh.point(mesh.to_vertex_handle(attached.halfedge(o.dart))) - middle).norm()), 0,
              1e-6);
  EXPECT_EQ(attached.tree().mesh(texture).capacity(2), mesh.n_faces());
}

TEST(RootMesh, SplitsAFace) {
  openmesh::RootMesh<DoubleMesh> mesh;
  make_torus(mesh, 10, 10, 1, false);
  openmesh::Attached attached(mesh);
  (void)attached.add_texture();
  mesh.drive(attached);
  const OpenMesh::FaceHandle f(17);
  const auto p = mesh.calc_face_centroid(f);
  const auto v = mesh.split(f, p);
  EXPECT_EQ(mesh.valence(v), 3U);
  EXPECT_EQ(mesh.point(v), p);
  EXPECT_THROW(mesh.split(OpenMesh::EdgeHandle(2), OpenMesh::VertexHandle(3)), UsageError);
  EXPECT_EQ(validate(attached.tree()), Problems{});
}

}  // namespace
}  // namespace multimesh::test
