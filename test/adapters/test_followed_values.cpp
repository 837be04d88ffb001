// SPDX-License-Identifier: BSD-3-Clause
// A user's properties on edges, faces and halfedges of an attached mesh: their values after each operation.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "multimesh/openmesh/attach.hpp"

namespace multimesh::test {
namespace {

using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using OpenMesh::EdgeHandle;
using OpenMesh::VertexHandle;

//      6---7---8      Two triangles per square: (i, i+1, i+4), (i, i+4, i+3). The curve 3-4-5.
//      | / | / |
//      3===4===5
//      | / | / |
//      0---1---2
class FollowedValues : public testing::Test {
 protected:
  FollowedValues() {
    for (int i = 0; i < 9; ++i) mesh_.add_vertex({double(i % 3), double(i / 3), 0});
    for (const int i : {0, 1, 3, 4}) {
      mesh_.add_face(VertexHandle(i), VertexHandle(i + 1), VertexHandle(i + 4));
      mesh_.add_face(VertexHandle(i), VertexHandle(i + 4), VertexHandle(i + 3));
    }
    mesh_.request_edge_status();
    mesh_.add_property(number_, "number");
    mesh_.add_property(face_number_, "number");
    mesh_.add_property(corner_number_, "number");
    for (const auto e : mesh_.edges()) mesh_.property(number_, e) = 10 * e.v0().idx() + e.v1().idx();
    for (const auto f : mesh_.faces()) mesh_.property(face_number_, f) = f.idx();
    for (const auto h : mesh_.halfedges()) mesh_.property(corner_number_, h) = h.to().idx();
    for (const EdgeHandle e : {edge(3, 4), edge(4, 5)}) mesh_.status(e).set_feature(true);
  }
  OpenMesh::HalfedgeHandle half(int v, int w) {
    return mesh_.find_halfedge(VertexHandle(v), VertexHandle(w));
  }
  EdgeHandle edge(int v, int w) { return mesh_.edge_handle(half(v, w)); }
  int& number(int v, int w) { return mesh_.property(number_, edge(v, w)); }
  std::size_t features() {
    std::size_t n = 0;
    for (const auto e : mesh_.edges()) n += mesh_.status(e).feature();
    return n;
  }

  UserMesh mesh_;
  OpenMesh::EPropHandleT<int> number_;
  OpenMesh::FPropHandleT<int> face_number_;
  OpenMesh::HPropHandleT<double> corner_number_;
};

// 0-4 and 3-4 become one. 3-4 is in the curve, and it is at the vertex that dies.
TEST_F(FollowedValues, OfTheEdgeInACurveWin) {
  mesh_.status(edge(0, 3)).set_feature(true);
  openmesh::Attached attached(mesh_);
  (void)attached.add_features();
  const int in_curve = number(3, 4), other = number(0, 4);
  {
    const Transaction undone = attached.operations().transaction();
    ASSERT_TRUE(attached.collapse(half(3, 0)));
    EXPECT_EQ(number(0, 4), in_curve);
    EXPECT_TRUE(mesh_.status(edge(0, 4)).feature());
    EXPECT_EQ(features(), 2U);
  }
  EXPECT_EQ(number(3, 4), in_curve);
  EXPECT_EQ(number(0, 4), other);
  EXPECT_EQ(features(), 3U);
}

TEST_F(FollowedValues, OfTheSurvivingEdgeElse) {
  openmesh::Attached attached(mesh_);
  const int kept = number(4, 8);
  ASSERT_TRUE(attached.collapse(half(7, 8)));
  EXPECT_EQ(number(4, 8), kept);
}

TEST_F(FollowedValues, FlagsOfEdgesUnite) {
  openmesh::Attached attached(mesh_);
  mesh_.status(edge(4, 7)).set_feature(true);
  mesh_.status(edge(4, 7)).set_tagged(true);
  mesh_.status(edge(4, 8)).set_selected(true);
  {
    const Transaction undone = attached.operations().transaction();
    ASSERT_TRUE(attached.collapse(half(7, 8)));
    const auto& merged = mesh_.status(edge(4, 8));
    EXPECT_TRUE(merged.feature() && merged.tagged() && merged.selected());
    EXPECT_FALSE(merged.deleted() || merged.locked());
  }
  EXPECT_FALSE(mesh_.status(edge(4, 8)).feature() || mesh_.status(edge(4, 8)).tagged());
  EXPECT_FALSE(mesh_.status(edge(4, 7)).deleted());
}

TEST_F(FollowedValues, HalvesHaveTheWholeAndNewEdgesNothing) {
  openmesh::Attached attached(mesh_);
  const int whole = number(3, 4);
  ASSERT_TRUE(attached.split(edge(3, 4)));
  EXPECT_EQ(number(3, 9), whole);
  EXPECT_EQ(number(9, 4), whole);
  EXPECT_TRUE(mesh_.status(edge(3, 9)).feature() && mesh_.status(edge(9, 4)).feature());
  for (const int x : {0, 7}) {
    EXPECT_EQ(number(9, x), 0);
    EXPECT_EQ(mesh_.status(edge(9, x)).bits(), 0U);
  }
  EXPECT_EQ(features(), 3U);
}

TEST_F(FollowedValues, ASwappedEdgeHasNothing) {
  openmesh::Attached attached(mesh_);
  mesh_.status(edge(0, 4)).set_feature(true);
  const auto before = std::tuple(number(0, 4), mesh_.status(edge(0, 4)).bits());
  const auto counts = std::tuple(mesh_.n_edges(), mesh_.n_vertices());
  {
    const Transaction undone = attached.operations().transaction();
    ASSERT_TRUE(attached.swap(edge(0, 4)));
    EXPECT_EQ(number(1, 3), 0);
    EXPECT_EQ(mesh_.status(edge(1, 3)).bits(), 0U);
    EXPECT_EQ(mesh_.property(corner_number_, half(1, 3)), 3);
    EXPECT_EQ(mesh_.property(corner_number_, half(3, 1)), 1);
  }
  EXPECT_EQ(before, std::tuple(number(0, 4), mesh_.status(edge(0, 4)).bits()));
  EXPECT_EQ(counts, std::tuple(mesh_.n_edges(), mesh_.n_vertices()));
  EXPECT_EQ(mesh_.property(corner_number_, half(0, 4)), 4);
}

TEST_F(FollowedValues, OfCornersStayWithTheirFaces) {
  openmesh::Attached attached(mesh_);
  ASSERT_TRUE(attached.collapse(half(7, 4)));
  for (const auto f : mesh_.faces())
    for (const auto h : mesh_.fh_range(f)) {
      const double v = mesh_.property(corner_number_, h);
      EXPECT_TRUE(v == h.to().idx() || (v == 7 && h.to().idx() == 4)) << v << " at " << h.to().idx();
    }
}

TEST_F(FollowedValues, ByRulesOfTheUser) {
  openmesh::Attached attached(mesh_);
  auto& numbers = attached.follow(number_, ColumnRules<int>::larger());
  attached.follow(face_number_, {.halve = [](const int& whole, double) { return whole + 100; }});
  attached.follow(corner_number_, ColumnRules<double>::interpolate());
  ASSERT_TRUE(attached.collapse(half(7, 8)));
  EXPECT_EQ(number(4, 8), 84);
  ASSERT_TRUE(attached.split(edge(3, 4), 0.25));
  const auto h = half(3, 9);
  EXPECT_GE(mesh_.property(face_number_, mesh_.face_handle(h)), 100);
  const double at_new = mesh_.property(corner_number_, h);
  EXPECT_TRUE(at_new == 3.25 || at_new == 3.75) << at_new;
  EXPECT_EQ(numbers.dimension(), 1);
}

TEST_F(FollowedValues, TakeOneRuleOnly) {
  openmesh::Attached attached(mesh_);
  attached.follow(number_);
  EXPECT_THROW(attached.follow(number_, ColumnRules<int>::smaller()), UsageError);
  const Transaction scope = attached.operations().transaction();
  EXPECT_THROW(attached.follow(face_number_), UsageError);
  EXPECT_THROW(attached.follow(corner_number_), UsageError);
}

TEST_F(FollowedValues, DeadAndUnknownNamesAreRefused) {
  openmesh::Attached attached(mesh_);
  const Dart dying = attached.dart(half(7, 8));
  const auto dead_face = mesh_.face_handle(half(7, 8)).is_valid() ? mesh_.face_handle(half(7, 8))
                                                                  : mesh_.face_handle(half(8, 7));
  EXPECT_THROW((void)attached.halfedge(no_dart), UsageError);
  EXPECT_THROW((void)attached.dart(OpenMesh::FaceHandle()), UsageError);
  EXPECT_THROW((void)attached.dart(OpenMesh::FaceHandle(100)), UsageError);
  EXPECT_THROW((void)attached.dart(EdgeHandle()), UsageError);
  EXPECT_THROW((void)attached.dart(EdgeHandle(100)), UsageError);
  EXPECT_THROW((void)attached.dart(VertexHandle(-3)), UsageError);
  ASSERT_TRUE(attached.collapse(half(7, 8)));
  EXPECT_THROW((void)attached.halfedge(dying), UsageError);
  EXPECT_THROW((void)attached.dart(dead_face), UsageError);
}

}  // namespace
}  // namespace multimesh::test
