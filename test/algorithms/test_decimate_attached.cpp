// SPDX-License-Identifier: BSD-3-Clause
// The same algorithm on a user's own OpenMesh mesh: its properties of all kinds follow, whatever its traits.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <cmath>
#include <string>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

struct FloatTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Color);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
};
struct DoubleTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
};
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<FloatTraits>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using FloatPolyMesh = OpenMesh::PolyMesh_ArrayKernelT<FloatTraits>;

enum class Children { none, texture, texture_and_borders };

/// A square of n x n in the plane z = 0, or bent. What it carries is known at each place: faces have their
/// side of the line x = n / 2, where the texture is cut open and edges have a value.
template <class Mesh>
class DecimateAttached : public testing::Test {
 protected:
  static constexpr int n = 20;
  using Real = typename Mesh::Point::value_type;

  void make(double height) {
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        mesh.add_vertex({Real(i), Real(j), Real(height * std::sin(0.3 * i) * std::cos(0.2 * j))});
    const auto at = [](int i, int j) { return OpenMesh::VertexHandle(i * (n + 1) + j); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        mesh.add_face(std::vector{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        mesh.add_face(std::vector{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    for (const auto f : mesh.faces()) {
      side[f] = mesh.calc_face_centroid(f)[0] < Real(n) / 2 ? "left" : "right";
      number[f] = f.idx();
      for (const auto h : mesh.fh_range(f)) {
        const auto p = mesh.point(mesh.to_vertex_handle(h));
        using UV = typename Mesh::TexCoord2D;
        using UVReal = typename UV::value_type;
        mesh.set_texcoord2D(h, UV(UVReal(p[0] / n + (side[f] == "left" ? 0 : 3)), UVReal(p[1] / n)));
        of_face[h] = f.idx();
      }
    }
    for (const auto e : mesh.edges()) crease[e] = is_border(e) ? 7.5F : 0.F;
    for (const auto v : mesh.vertices()) {
      heat[v] = double(mesh.point(v)[0]) < n / 2.0 - 0.5 ? 1 : 2;
      one[v] = 1;
    }
  }
  bool is_border(OpenMesh::EdgeHandle e) const {
    const auto x = mesh.face_handle(mesh.halfedge_handle(e, 0)),
               y = mesh.face_handle(mesh.halfedge_handle(e, 1));
    return x.is_valid() && y.is_valid() && side[x] != side[y];
  }

  Mesh mesh;
  OpenMesh::FProp<std::string> side{mesh, "side"};
  OpenMesh::FProp<int> number{mesh, "number"};
  OpenMesh::HProp<int> of_face{mesh, "of face"};
  OpenMesh::EProp<float> crease{mesh, "crease"};
  OpenMesh::VProp<double> heat{mesh, "heat"}, one{mesh, "one"};
};
using Meshes = testing::Types<FloatMesh, DoubleMesh, FloatPolyMesh>;
TYPED_TEST_SUITE(DecimateAttached, Meshes);

DecimateOptions to_faces(std::size_t faces) {
  DecimateOptions o;
  o.faces = faces;
  return o;
}

TYPED_TEST(DecimateAttached, PropertiesOfAllKindsFollow) {
  constexpr int n = 20;
  this->make(0);
  auto& mesh = this->mesh;
  openmesh::Attached attached(mesh);
  const NodeId borders = attached.add_borders(this->side);
  attached.follow(this->heat);
  attached.follow(this->one);
  const DecimateResult r = decimate(embedding(attached), NodeId::root, to_faces(60));
  EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
  EXPECT_EQ(validate(attached.tree()), Problems{});
  attached.garbage_collection();
  EXPECT_EQ(mesh.n_faces(), r.faces_after);
  for (const auto v : mesh.vertices()) {
    EXPECT_NEAR(this->one[v], 1, 1e-12) << "means of equals are equal";
    EXPECT_TRUE(this->heat[v] >= 1 && this->heat[v] <= 2);
  }
  std::size_t border_edges = 0;
  for (const auto e : mesh.edges()) {
    EXPECT_EQ(this->crease[e], this->is_border(e) ? 7.5F : 0.F) << "edge " << e.idx();
    border_edges += this->is_border(e);
  }
  EXPECT_EQ(border_edges, attached.tree().mesh(borders).capacity(1));
  EXPECT_LT(border_edges, 20U);
  for (const auto f : mesh.faces()) {
    const double x = double(mesh.calc_face_centroid(f)[0]);
    EXPECT_EQ(this->side[f], x < n / 2.0 ? "left" : "right");
    for (const auto h : mesh.fh_range(f)) EXPECT_EQ(this->of_face[h], this->number[f]);
  }
}

// In a plane whose texture is affine nothing need deviate.
TYPED_TEST(DecimateAttached, TheTextureStaysWhereItIsPainted) {
  constexpr double n = 20;
  this->make(0);
  auto& mesh = this->mesh;
  {
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    const DecimateResult r = decimate(embedding(attached), NodeId::root, to_faces(40));
    EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
    EXPECT_EQ(r.charts, 2U);
    EXPECT_EQ(validate(attached.tree()), Problems{});
    attached.garbage_collection();
  }
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(mesh.to_vertex_handle(h));
      EXPECT_NEAR(mesh.texcoord2D(h)[0], p[0] / n + (this->side[f] == "left" ? 0 : 3), 1e-4);
      EXPECT_NEAR(mesh.texcoord2D(h)[1], p[1] / n, 1e-4);
    }
}

TYPED_TEST(DecimateAttached, KeepsTheTopologyOfAllMeshes) {
  this->make(2);
  for (const Children children : {Children::none, Children::texture, Children::texture_and_borders}) {
    SCOPED_TRACE(static_cast<int>(children));
    TypeParam mesh = this->mesh;
    OpenMesh::FProp<std::string> side(mesh, "side");
    openmesh::Attached attached(mesh);
    if (children != Children::none) (void)attached.add_texture();
    if (children == Children::texture_and_borders) (void)attached.add_borders(side);
    std::vector<MeshReport> before;
    for (const NodeId n : attached.tree().nodes()) before.push_back(report(attached.tree().mesh(n)));
    DecimateOptions options = to_faces(80);
    options.max_error = 0.05;
    const DecimateResult r = decimate(embedding(attached), NodeId::root, options);
    EXPECT_GT(r.collapsed, 200U);
    EXPECT_EQ(validate(attached.tree()), Problems{});
    std::size_t i = 0;
    for (const NodeId n : attached.tree().nodes()) {
      const MeshReport now = report(attached.tree().mesh(n));
      EXPECT_EQ(now.components, before[i].components);
      EXPECT_EQ(now.euler_characteristic, before[i].euler_characteristic);
      EXPECT_EQ(now.boundary, before[i++].boundary);
    }
  }
}

TYPED_TEST(DecimateAttached, LockedVerticesAndTheBoundaryStay) {
  this->make(1);
  auto& mesh = this->mesh;
  mesh.request_vertex_status();
  const OpenMesh::VertexHandle middle(10 * 21 + 10);
  mesh.status(middle).set_locked(true);
  const auto place = mesh.point(middle);
  double rim = 0;
  for (const auto h : mesh.halfedges())
    if (mesh.is_boundary(h)) rim += 1;
  openmesh::Attached attached(mesh);
  DecimateOptions options = to_faces(1);
  options.lock_boundary = true;
  const DecimateResult r = decimate(embedding(attached), NodeId::root, options);
  EXPECT_EQ(r.stop, DecimateResult::Stop::exhausted);
  EXPECT_FALSE(mesh.status(middle).deleted());
  EXPECT_EQ(mesh.point(middle), place);
  double left = 0;
  for (const auto h : mesh.halfedges())
    if (!mesh.status(mesh.edge_handle(h)).deleted() && mesh.is_boundary(h)) left += 1;
  EXPECT_EQ(left, rim);
}

// Two ways to say the same. Edges are numbered in another order, so that sums differ by roundings.
TEST(DecimateAttached, DoesWhatIsDoneToATexturedSurface) {
  TexturedTriangles in = waves();
  in.texcoords.clear();
  for (auto& t : in.triangles)
    for (auto& c : t) c.texcoord = -1;
  DoubleMesh mesh;
  for (const Vec3& p : in.positions) mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : in.triangles)
    mesh.add_face(std::vector{OpenMesh::VertexHandle(t[0].position), OpenMesh::VertexHandle(t[1].position),
                              OpenMesh::VertexHandle(t[2].position)});
  const DecimateOptions options = to_faces(100);
  openmesh::Attached attached(mesh);
  Embedding values = embedding(attached);
  values.set(LegalityOptions{.contact = true});
  const DecimateResult r = decimate(values, NodeId::root, options);
  TexturedSurface surface(in);
  const DecimateResult s = decimate(surface, options);
  EXPECT_EQ(r.collapsed, s.collapsed);
  EXPECT_EQ(r.faces_after, s.faces_after);
  EXPECT_NEAR(r.max_cost, s.max_cost, 1e-3 * s.max_cost);
}

TEST(DecimateAttached, OnlySurfacesAreDecimated) {
  DoubleMesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({0, 1, 0});
  mesh.add_face(std::vector{a, b, c});
  openmesh::Attached attached(mesh);
  const NodeId rim = attached.add_boundary();
  EXPECT_THROW((void)decimate(embedding(attached), rim, to_faces(1)), UsageError);
  EXPECT_THROW((void)decimate(embedding(attached), NodeId::root, {}), InputError);
}

}  // namespace
}  // namespace multimesh::test
