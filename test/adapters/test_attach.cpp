// SPDX-License-Identifier: BSD-3-Clause
// A user's own mesh, with traits and properties, becomes part of a tree in place, and is released again.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Color = OpenMesh::Vec4f;
  VertexTraits { std::string name; };
  FaceAttributes(OpenMesh::Attributes::Color);
};
struct FloatTraits : OpenMesh::DefaultTraits {
  using Color = OpenMesh::Vec4f;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
};

template <class UserMesh>
class AttachInPlace : public testing::Test {
 protected:
  using Points = std::vector<typename UserMesh::Point>;
  using Scalar = typename UserMesh::Scalar;

  AttachInPlace() {
    const Shape s = grid(4, 4);
    for (const auto& p : s.points)
      user_.add_vertex(typename UserMesh::Point(Scalar(p[0]), Scalar(p[1]), Scalar(p[2])));
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
      std::vector<typename UserMesh::VertexHandle> corners;
      for (const Index v : s.facets.facet(f)) corners.emplace_back(static_cast<int>(v));
      const auto face = user_.add_face(corners);
      user_.set_color(face, {static_cast<float>(f), 2, 3, 1});
    }
    user_.add_property(label_, "label");
    for (const auto f : user_.faces()) user_.property(label_, f) = "face " + std::to_string(f.idx());
  }
  Points& points() { return user_.property(user_.points_pph()).data_vector(); }
  Dart edge(const Mesh& mesh, int a, int b) {
    const auto h = user_.find_halfedge(user_.vertex_handle(static_cast<unsigned>(a)),
                                       user_.vertex_handle(static_cast<unsigned>(b)));
    return dynamic_cast<const openmesh::TriangleMesh&>(mesh).edge_dart(h);
  }
  std::size_t our_properties() const {
    std::size_t n = 0;
    const auto count = [&](auto begin, auto end) {
      for (auto p = begin; p != end; ++p) n += *p && (*p)->name().rfind("mm:", 0) == 0;
    };
    count(user_.vprops_begin(), user_.vprops_end());
    count(user_.eprops_begin(), user_.eprops_end());
    count(user_.hprops_begin(), user_.hprops_end());
    count(user_.fprops_begin(), user_.fprops_end());
    return n;
  }

  UserMesh user_;
  OpenMesh::FPropHandleT<std::string> label_;
};

using UserMeshes =
    testing::Types<OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>, OpenMesh::TriMesh_ArrayKernelT<FloatTraits>,
                   OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>,
                   OpenMesh::PolyMesh_ArrayKernelT<FloatTraits>>;
TYPED_TEST_SUITE(AttachInPlace, UserMeshes);

TYPED_TEST(AttachInPlace, MovesTheUsersPointsAndKeepsTheUsersProperties) {
  auto& user = this->user_;
  MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(user));
  const NodeId rim = add_child_from_boundary(tree, NodeId::root, openmesh::make_mesh);
  using Point = typename TypeParam::Point;
  VertexAttribute<Point> positions(NodeId::root, this->points());
  Propagation ops(tree);
  ops.add(positions);

  const Dart e = this->edge(tree.mesh(NodeId::root), 6, 12);  // (1,1) - (2,2), interior
  const Index left = tree.mesh(NodeId::root).facet(e);
  const auto colour = user.color(OpenMesh::FaceHandle(static_cast<int>(left)));
  const Outcome cut = ops.split(NodeId::root, e, 0.25);
  ASSERT_TRUE(cut);
  const auto c = openmesh::TriangleMesh::halfedge(cut.dart);
  const Point middle = user.point(user.to_vertex_handle(c)) + user.point(user.from_vertex_handle(c));
  EXPECT_NEAR(
      (middle - Point(1, 1, 0) - Point(typename TypeParam::Scalar(1.25), typename TypeParam::Scalar(1.25), 0))
          .norm(),
      0, 1e-6);
  const auto half = user.face_handle(c);
  EXPECT_EQ(user.color(half), colour);
  EXPECT_EQ(user.property(this->label_, half), "face " + std::to_string(left));

  EXPECT_TRUE(ops.split(rim, tree.mesh(rim).dart_of(1, 0)));
  EXPECT_TRUE(ops.collapse(NodeId::root, this->edge(tree.mesh(NodeId::root), 7, 8), Placement::keep_a()));
  EXPECT_EQ(validate(tree), std::vector<std::string>{});
  tree.compact();
  EXPECT_EQ(validate(tree), std::vector<std::string>{});
  EXPECT_EQ(user.n_vertices(), this->points().size());
  for (const auto f : user.faces()) EXPECT_EQ(user.valence(f), 3U);
}

TYPED_TEST(AttachInPlace, GivesTheMeshBackAsItWas) {
  auto& user = this->user_;
  const bool had[] = {user.has_vertex_status(), user.has_edge_status(), user.has_face_status(),
                      user.has_halfedge_status()};
  const std::vector<typename TypeParam::Point> before = this->points();
  for (int round = 0; round < 3; ++round) {
    MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(user));
    (void)add_child_from_boundary(tree, NodeId::root, openmesh::make_mesh);
    EXPECT_GT(this->our_properties(), 0U);
  }
  EXPECT_EQ(this->our_properties(), 0U);
  EXPECT_EQ(this->points(), before);
  EXPECT_EQ(user.has_vertex_status(), had[0]);
  EXPECT_EQ(user.has_edge_status(), had[1]);
  EXPECT_EQ(user.has_face_status(), had[2]);
  EXPECT_EQ(user.has_halfedge_status(), had[3]);
  if (had[0]) {  // the user's one request is still there, and no more
    user.release_vertex_status();
    EXPECT_FALSE(user.has_vertex_status());
  }
}

// The user did not request status, so elements that died must be removed: nothing marks them as deleted.
TYPED_TEST(AttachInPlace, LeavesNothingDeadWithoutAMark) {
  auto& user = this->user_;
  const std::size_t faces = user.n_faces();
  {
    MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(user));
    Propagation ops(tree);
    ASSERT_TRUE(ops.collapse(NodeId::root, this->edge(tree.mesh(NodeId::root), 6, 12)));
  }
  EXPECT_TRUE(user.has_face_status() || user.n_faces() == faces - 2);
  std::size_t live = 0;
  for (const auto f : user.faces()) live += f.is_valid();  // skips what is marked as deleted
  EXPECT_EQ(live, faces - 2);
}

TYPED_TEST(AttachInPlace, IsUndoneWithTheUsersPropertiesAndCounts) {
  auto& user = this->user_;
  MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(user));
  VertexAttribute<typename TypeParam::Point> positions(NodeId::root, this->points());
  FunctionInvariant never("never", {}, [](const Event&) { return false; });
  Propagation ops(tree);
  ops.add(positions).add(never);
  const std::vector<typename TypeParam::Point> before = this->points();
  const std::size_t faces = user.n_faces();
  for (const auto h : user.all_halfedges()) {
    const Dart e = dynamic_cast<const openmesh::TriangleMesh&>(tree.mesh(NodeId::root)).edge_dart(h);
    EXPECT_FALSE(ops.split(NodeId::root, e));
    EXPECT_FALSE(ops.collapse(NodeId::root, e));
    ASSERT_EQ(this->points(), before);
    ASSERT_EQ(user.n_faces(), faces);
    for (const auto f : user.all_faces())
      ASSERT_EQ(user.property(this->label_, f), "face " + std::to_string(f.idx()));
    for (const auto g : user.all_halfedges())
      ASSERT_TRUE(!user.has_halfedge_status() || user.status(g).bits() == 0);
  }
}

}  // namespace
}  // namespace multimesh::test
