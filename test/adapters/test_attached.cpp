// SPDX-License-Identifier: BSD-3-Clause
// A mesh of an existing pipeline, with children from what it knows: texture coordinates of halfedges, feature
// bits, tags of faces, boundary.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <map>
#include <random>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;
using Problems = std::vector<std::string>;

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = Vec3d;
  using Normal = Vec3d;
  using TexCoord2D = Vec2d;
  using Color = OpenMesh::Vec3uc;
  VertexAttributes(OpenMesh::Attributes::Color | OpenMesh::Attributes::Normal |
                   OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
  FaceAttributes(OpenMesh::Attributes::Color);
};
struct FloatTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::TexCoord2D);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
};

/// A torus of n x n squares in the plane's coordinates (i, j); the texture is cut open where they wrap.
template <class UserMesh>
class AttachedMesh : public testing::Test {
 protected:
  static constexpr int n = 6;
  using Real = typename UserMesh::Point::value_type;
  using TexReal = typename UserMesh::TexCoord2D::value_type;

  AttachedMesh() {
    const Shape s = torus(n, n);
    for (const auto& p : s.points) mesh_.add_vertex({Real(p[0]), Real(p[1]), Real(p[2])});
    mesh_.add_property(tag_, "tag");
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}}), add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    mesh_.request_edge_status();
    for (const auto e : mesh_.edges())
      mesh_.status(e).set_feature(e.v0().idx() % n == 3 && e.v1().idx() % n == 3);
  }
  void add(std::array<std::array<int, 2>, 3> corners) {
    std::vector<OpenMesh::VertexHandle> v;
    for (const auto& [i, j] : corners) v.emplace_back(i % n * n + j % n);
    const auto f = mesh_.add_face(v);
    mesh_.property(tag_, f) = corners[0][0] < 2 ? "left" : "right";
    for (const auto h : mesh_.fh_range(f))
      for (const auto& [i, j] : corners)
        if (mesh_.to_vertex_handle(h).idx() == i % n * n + j % n)
          mesh_.set_texcoord2D(h, {TexReal(i), TexReal(j)});
  }
  OpenMesh::HalfedgeHandle halfedge(int i, int j, int k, int l) {
    return mesh_.find_halfedge(OpenMesh::VertexHandle(i * n + j), OpenMesh::VertexHandle(k * n + l));
  }
  /// The texture coordinates of all corners are those of the vertices of the texture; returns how many.
  std::size_t check_corners(openmesh::Attached<UserMesh>& attached, NodeId texture) {
    std::vector<openmesh::Corner> corners;
    openmesh::all_corners(attached.tree(), texture, corners);
    for (const auto& c : corners) {
      const OpenMesh::HalfedgeHandle h(static_cast<int>(c.halfedge));
      EXPECT_FALSE(mesh_.status(mesh_.edge_handle(h)).deleted());
      EXPECT_EQ(mesh_.texcoord2D(h), attached.texcoords()[c.child_vertex]) << "halfedge " << h.idx();
    }
    return corners.size();
  }
  std::size_t live_faces() const {
    std::size_t live = 0;
    for (const auto f : mesh_.all_faces()) live += !mesh_.has_face_status() || !mesh_.status(f).deleted();
    return live;
  }

  UserMesh mesh_;
  OpenMesh::FPropHandleT<std::string> tag_;
};

using Meshes =
    testing::Types<OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>, OpenMesh::TriMesh_ArrayKernelT<FloatTraits>,
                   OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>,
                   OpenMesh::PolyMesh_ArrayKernelT<FloatTraits>>;
TYPED_TEST_SUITE(AttachedMesh, Meshes);

TYPED_TEST(AttachedMesh, HasChildrenFromWhatTheMeshKnows) {
  openmesh::Attached attached(this->mesh_);
  const NodeId texture = attached.add_texture();
  const NodeId features = attached.add_features();
  const NodeId borders = attached.add_borders(this->tag_);
  const NodeId left = attached.add_region(this->tag_, std::string("left"));
  const MultiMesh& tree = attached.tree();
  EXPECT_EQ(validate(tree), Problems{});
  constexpr int n = 6;
  EXPECT_EQ(tree.mesh(texture).capacity(0), Index{(n + 1) * (n + 1)});
  EXPECT_EQ(report(tree.mesh(texture)).components, 1U);
  EXPECT_EQ(report(tree.mesh(features)).edges, std::size_t{n});
  EXPECT_EQ(report(tree.mesh(borders)).edges, std::size_t{2 * n});
  EXPECT_EQ(report(tree.mesh(borders)).components, 2U);
  EXPECT_EQ(report(tree.mesh(left)).faces, std::size_t{4 * n});
  EXPECT_THROW(attached.add_boundary(), InputError);  // a torus has none
  EXPECT_THROW(attached.add_texture(), UsageError);
  EXPECT_THROW(attached.add_faces([](auto) { return false; }), InputError);
  EXPECT_EQ(tree.children(NodeId::root).size(), 4U);
}

TYPED_TEST(AttachedMesh, KeepsChosenVerticesAsPoints) {
  openmesh::Attached attached(this->mesh_);
  const auto chosen = [](OpenMesh::VertexHandle v) { return v.idx() % 5 == 0; };
  const NodeId points = attached.add_points(chosen);
  const auto count = attached.tree().mesh(points).capacity(0);
  std::map<OpenMesh::VertexHandle, typename TypeParam::Point> places;
  for (const auto v : this->mesh_.vertices())
    if (chosen(v)) places[v] = this->mesh_.point(v);
  ASSERT_EQ(places.size(), count);
  EXPECT_EQ(report(attached.tree().mesh(points)).vertices, count);
  EXPECT_EQ(report(attached.tree().mesh(points)).components, count);
  std::size_t done = 0;
  for (const auto e : this->mesh_.edges())
    if (!this->mesh_.status(e).deleted())
      done += bool(attached.collapse(this->mesh_.halfedge_handle(e, 0), Placement::at(0.5)));
  EXPECT_GT(done, 5U);
  EXPECT_EQ(validate(attached.tree()), Problems{});
  for (const auto& [v, place] : places) {
    EXPECT_FALSE(this->mesh_.status(v).deleted());
    EXPECT_EQ(this->mesh_.point(v), place);
  }
  attached.garbage_collection();
  EXPECT_EQ(validate(attached.tree()), Problems{});
  EXPECT_EQ(attached.tree().mesh(points).capacity(0), count);
  EXPECT_THROW(attached.add_points([](auto) { return false; }), InputError);
}

TYPED_TEST(AttachedMesh, TakesPropertyManagersWhereverPropertyHandles) {
  auto heat = OpenMesh::getOrMakeProperty<OpenMesh::VertexHandle, double>(this->mesh_, "heat");
  auto part = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, std::string>(this->mesh_, "tag");
  for (const auto v : this->mesh_.vertices()) heat[v] = v.idx();
  openmesh::Attached attached(this->mesh_);
  VertexAttribute<double>& follows = attached.follow(heat);
  const NodeId borders = attached.add_borders(part);
  const NodeId left = attached.add_region(part, "left");
  EXPECT_EQ(report(attached.tree().mesh(borders)).edges, std::size_t{2 * this->n});
  EXPECT_EQ(report(attached.tree().mesh(left)).faces, std::size_t{4 * this->n});
  const auto h = this->halfedge(2, 2, 2, 3);
  const double from = heat[this->mesh_.from_vertex_handle(h)], to = heat[this->mesh_.to_vertex_handle(h)];
  const Outcome o = attached.split(this->mesh_.edge_handle(h), 0.5);
  ASSERT_TRUE(o);
  EXPECT_EQ(heat[OpenMesh::VertexHandle(int(this->mesh_.n_vertices()) - 1)], (from + to) / 2);
  EXPECT_EQ(follows.node(), NodeId::root);
}

TYPED_TEST(AttachedMesh, RefusesTextureCallsWithoutATexture) {
  openmesh::Attached attached(this->mesh_);
  EXPECT_THROW(attached.forbid_flips(), UsageError);
  EXPECT_THROW(attached.write_back(), UsageError);
  EXPECT_THROW(attached.texcoords(), UsageError);
  const NodeId texture = attached.add_texture();
  attached.forbid_flips();
  attached.tree().detach(texture);
  EXPECT_THROW(attached.forbid_flips(), UsageError);
}

TYPED_TEST(AttachedMesh, KeepsTheTextureCoordinatesOfHalfedges) {
  openmesh::Attached attached(this->mesh_);
  const NodeId texture = attached.add_texture();
  (void)attached.add_features();
  std::mt19937 random(7);
  for (int done = 0; done < 600;) {
    const OpenMesh::EdgeHandle e(static_cast<int>(random() % this->mesh_.n_edges()));
    if (this->mesh_.status(e).deleted()) continue;
    const auto what = random() % 3;
    const Outcome o = what == 0   ? attached.split(e, 0.25)
                      : what == 1 ? attached.collapse(this->mesh_.halfedge_handle(e, 0))
                                  : attached.swap(e);
    if (!o) continue;
    if (++done % 20 == 0) {
      ASSERT_EQ(this->check_corners(attached, texture), 3 * this->live_faces());
    }
  }
  EXPECT_EQ(validate(attached.tree()), Problems{});
  attached.tree().require_in_step();
  attached.garbage_collection();
  EXPECT_EQ(this->check_corners(attached, texture), 3 * this->mesh_.n_faces());
  EXPECT_EQ(validate(attached.tree()), Problems{});
}

TYPED_TEST(AttachedMesh, HasBothTextureCoordinatesOfASeam) {
  openmesh::Attached attached(this->mesh_);
  (void)attached.add_texture();
  const auto h = this->halfedge(0, 1, 0, 2);  // where i wraps
  const Outcome cut = attached.operations().split(NodeId::root, attached.dart(h), 0.5);
  ASSERT_TRUE(cut);
  const auto to_middle = attached.halfedge(cut.dart);
  const auto from_middle = this->mesh_.opposite_halfedge_handle(to_middle);
  ASSERT_EQ(this->mesh_.from_vertex_handle(to_middle).idx(), 1);
  const auto at_middle = [&](auto towards) { return this->mesh_.texcoord2D(towards); };
  // One side has i = 0, the other i = 6; both j = 1.5.
  const auto other_side = this->mesh_.prev_halfedge_handle(from_middle);
  const double u = double(at_middle(to_middle)[0]), w = double(at_middle(other_side)[0]);
  EXPECT_EQ(std::minmax(u, w), std::minmax(0.0, 6.0));
  EXPECT_EQ(double(at_middle(to_middle)[1]), 1.5);
  EXPECT_EQ(double(at_middle(other_side)[1]), 1.5);
}

TYPED_TEST(AttachedMesh, WritesBackOnDemandOnly) {
  openmesh::Attached attached(this->mesh_);
  (void)attached.add_texture({}, openmesh::WriteBack::on_demand);
  const auto e = this->mesh_.edge_handle(this->halfedge(2, 2, 3, 2));
  ASSERT_TRUE(attached.split(e, 0.5));
  const auto is_new = [](auto x) { return double(x[0]) == 2.5 && double(x[1]) == 2; };
  const auto at_new_vertex = [&] {
    std::size_t corners = 0;
    for (const auto h : this->mesh_.all_halfedges()) corners += is_new(this->mesh_.texcoord2D(h));
    return corners;
  };
  EXPECT_EQ(at_new_vertex(), 0U);
  attached.write_back();
  EXPECT_EQ(at_new_vertex(), 4U);
}

TYPED_TEST(AttachedMesh, CanHaveATextureAgain) {
  openmesh::Attached attached(this->mesh_);
  const NodeId first = attached.add_texture();
  attached.forbid_flips();
  attached.forbid_flips();
  (void)attached.tree().detach(first);
  attached.write_back();  // there is nothing to write
  ASSERT_TRUE(attached.split(this->mesh_.edge_handle(this->halfedge(2, 2, 3, 2))));
  const NodeId second = attached.add_texture();
  attached.forbid_flips();
  ASSERT_TRUE(attached.collapse(this->halfedge(4, 4, 4, 5)));
  ASSERT_TRUE(attached.split(this->mesh_.edge_handle(this->halfedge(1, 3, 1, 4))));
  EXPECT_EQ(this->check_corners(attached, second), 3 * this->live_faces());
  EXPECT_EQ(validate(attached.tree()), Problems{});
}

TYPED_TEST(AttachedMesh, LeavesAnOrdinaryMesh) {
  auto& mesh = this->mesh_;
  const auto before = mesh;
  OpenMesh::VertexHandle watched(20), gone(8);
  OpenMesh::HalfedgeHandle to_watched = this->halfedge(3, 1, 3, 2);
  OpenMesh::FaceHandle face(40);
  const std::string tag = mesh.property(this->tag_, face);
  auto weight = OpenMesh::getOrMakeProperty<OpenMesh::VertexHandle, double>(mesh, "weight");
  for (const auto v : mesh.vertices()) weight[v] = v.idx();
  {
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    (void)attached.add_features();
    attached.follow(weight.getRawProperty());
    ASSERT_TRUE(attached.collapse(this->halfedge(1, 2, 1, 1)));  // 8 goes to 7
    ASSERT_TRUE(attached.split(mesh.edge_handle(this->halfedge(4, 4, 5, 4)), 0.5));
    EXPECT_EQ(weight[OpenMesh::VertexHandle(36)], 0.5 * (28 + 34));
    attached.garbage_collection({{&watched, &gone}, {&to_watched}, {}, {&face}});
    EXPECT_EQ(mesh.to_vertex_handle(to_watched), watched);
    EXPECT_EQ(weight[watched], 20);
    EXPECT_FALSE(gone.is_valid());
    EXPECT_EQ(mesh.property(this->tag_, face), tag);
  }
  EXPECT_EQ(mesh.n_faces(), before.n_faces());  // two less, two more
  EXPECT_EQ(mesh.has_vertex_status(), before.has_vertex_status());
  EXPECT_EQ(mesh.has_face_status(), before.has_face_status());
  const auto ours = [](auto begin, auto end) {
    return std::count_if(begin, end, [](const auto* p) { return p && p->name().rfind("mm:", 0) == 0; });
  };
  EXPECT_EQ(ours(mesh.vprops_begin(), mesh.vprops_end()), 0);
  EXPECT_EQ(ours(mesh.hprops_begin(), mesh.hprops_end()), 0);
  EXPECT_EQ(ours(mesh.eprops_begin(), mesh.eprops_end()), 0);
  EXPECT_EQ(ours(mesh.fprops_begin(), mesh.fprops_end()), 0);
}

TYPED_TEST(AttachedMesh, MovesAVertexWithAWrite) {
  openmesh::Attached attached(this->mesh_);
  const typename TypeParam::Point p(1, 2, 3);
  ASSERT_TRUE(attached.relocate(OpenMesh::VertexHandle(5), p));
  EXPECT_EQ(this->mesh_.point(OpenMesh::VertexHandle(5)), p);
  {
    const Transaction undone = attached.operations().transaction();
    ASSERT_TRUE(attached.relocate(OpenMesh::VertexHandle(5), typename TypeParam::Point(0, 0, 0)));
  }
  EXPECT_EQ(this->mesh_.point(OpenMesh::VertexHandle(5)), p);
}

TYPED_TEST(AttachedMesh, RefusesWhatItCannotUse) {
  auto& mesh = this->mesh_;
  {
    openmesh::Attached attached(mesh);
    EXPECT_THROW((void)attached.dart(OpenMesh::HalfedgeHandle(-1)), UsageError);
    EXPECT_THROW((void)attached.dart(OpenMesh::HalfedgeHandle(1 << 20)), UsageError);
    EXPECT_THROW((void)attached.dart(OpenMesh::VertexHandle(1 << 20)), UsageError);
    EXPECT_THROW(openmesh::Attached<TypeParam>{mesh}, UsageError);  // twice
    const OpenMesh::HalfedgeHandle h(3);
    mesh.set_texcoord2D(h, {std::numeric_limits<typename TestFixture::TexReal>::quiet_NaN(), 0});
    try {
      (void)attached.add_texture();
      ADD_FAILURE();
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("halfedge 3"), std::string::npos) << e.what();
    }
    const auto bad = mesh.face_handle(h);
    (void)attached.add_texture([&](OpenMesh::FaceHandle f) { return f != bad; });
  }
  mesh.release_halfedge_texcoords2D();
  openmesh::Attached attached(mesh);
  EXPECT_THROW((void)attached.add_texture(), UsageError);
}

TEST(AttachedColors, AreRoundedAndNormalsAreUnitVectors) {
  using UserMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
  UserMesh mesh;
  const std::array v{mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1, 0, 0}), mesh.add_vertex({0, 1, 0})};
  const auto f = mesh.add_face(v[0], v[1], v[2]);
  mesh.set_color(f, {9, 8, 7});
  mesh.set_color(v[0], {255, 0, 255});
  mesh.set_color(v[1], {255, 1, 100});
  mesh.set_normal(v[0], {1, 0, 0});
  mesh.set_normal(v[1], {0, 0, 1});
  mesh.set_texcoord2D(v[0], {0, 0});
  mesh.set_texcoord2D(v[1], {4, 2});
  openmesh::Attached attached(mesh);
  ASSERT_TRUE(attached.split(mesh.edge_handle(mesh.find_halfedge(v[0], v[1])), 0.5));
  const OpenMesh::VertexHandle c(3);
  EXPECT_EQ(mesh.color(c), OpenMesh::Vec3uc(255, 1, 178));
  EXPECT_NEAR((mesh.normal(c) - Vec3d(1, 0, 1).normalized()).norm(), 0, 1e-15);
  EXPECT_EQ(mesh.texcoord2D(c), Vec2d(2, 1));
  EXPECT_EQ(mesh.color(OpenMesh::FaceHandle(1)), OpenMesh::Vec3uc(9, 8, 7));
}

}  // namespace
}  // namespace multimesh::test
