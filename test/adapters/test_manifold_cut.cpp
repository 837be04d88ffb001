// SPDX-License-Identifier: BSD-3-Clause
// A user's mesh is cut in place where its vertices join several fans, attached, and joined again.
#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>

#include "adapters/openmesh/manifold_cut.hpp"
#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};
struct TraitsWithStatus : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh3 = OpenMesh::TriMesh_ArrayKernelT<Traits>;

struct Anything {  // any type that OpenMesh takes
  std::string name;
  std::vector<int> list;
  friend bool operator==(const Anything&, const Anything&) = default;
};

/// All faces by the numbers of their vertices' places.
template <class UserMesh>
std::multiset<std::array<double, 9>> faces_of(const UserMesh& mesh) {
  std::multiset<std::array<double, 9>> all;
  for (const auto f : mesh.all_faces()) {
    if (mesh.has_face_status() && mesh.status(f).deleted()) continue;
    std::array<std::array<double, 3>, 3> p{};
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(f)) {
      for (std::size_t k = 0; k < 3; ++k) p[i][k] = double(mesh.point(v)[static_cast<int>(k)]);
      ++i;
    }
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    std::array<double, 9> face{};
    for (std::size_t k = 0; k < 9; ++k) face[k] = p[k / 3][k % 3];
    all.insert(face);
  }
  return all;
}

/// Every handle of the connectivity in memory, except links of the boundary, which may be in another order
/// around a vertex.
template <class UserMesh>
std::vector<int> connectivity(const UserMesh& mesh) {
  std::vector<int> words{int(mesh.n_vertices()), int(mesh.n_edges()), int(mesh.n_faces())};
  for (const auto h : mesh.all_halfedges())
    for (const int w : {mesh.to_vertex_handle(h).idx(), mesh.face_handle(h).idx(),
                        mesh.is_boundary(h) ? -1 : mesh.next_halfedge_handle(h).idx()})
      words.push_back(w);
  return words;
}

/// Edges whose two vertices are also those of another edge.
template <class UserMesh>
std::size_t double_edges(const UserMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto e : mesh.all_edges()) {
    if (mesh.has_edge_status() && mesh.status(e).deleted()) continue;
    const auto h = mesh.halfedge_handle(e, 0);
    ++edges[std::minmax(mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx())];
  }
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second > 1; }));
}

template <class UserMesh>
class CutMesh : public testing::Test {
 protected:
  /// Some faces of a shape, as far as OpenMesh takes them.
  UserMesh mesh_of(const Shape& s, const std::vector<bool>& keep) {
    UserMesh mesh;
    for (const auto& p : s.points) mesh.add_vertex({p[0], p[1], p[2]});
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
      if (!keep[f]) continue;
      std::vector<OpenMesh::VertexHandle> v;
      for (const Index i : s.facets.facet(f)) v.emplace_back(static_cast<int>(i));
      mesh.add_face(v);
    }
    return mesh;
  }
  UserMesh random_part(const Shape& s, std::mt19937& random) {
    std::vector<bool> keep;
    const auto share = 20 + random() % 70;
    for (std::size_t f = 0; f < s.facets.size(); ++f) keep.push_back(random() % 100 < share);
    return mesh_of(s, keep);
  }
  static std::vector<Shape> shapes() { return {grid(6, 6), torus(6, 6), sphere(1)}; }
};

using Meshes = testing::Types<Mesh3, OpenMesh::PolyMesh_ArrayKernelT<Traits>,
                              OpenMesh::TriMesh_ArrayKernelT<TraitsWithStatus>>;
TYPED_TEST_SUITE(CutMesh, Meshes);

TYPED_TEST(CutMesh, RandomPartsOfMeshesAttachAndAreJoinedAgain) {
  std::mt19937 random(5);
  std::size_t cut_vertices = 0;
  for (const Shape& shape : this->shapes())
    for (int round = 0; round < 30; ++round) {
      TypeParam mesh = this->random_part(shape, random);
      if (mesh.n_faces() == 0) continue;
      const auto before = connectivity(mesh);
      const auto faces = faces_of(mesh);
      const bool had_status = mesh.has_vertex_status();
      openmesh::ManifoldCut cut(mesh);
      cut_vertices += cut.copies();
      for (const auto v : mesh.vertices()) EXPECT_TRUE(mesh.is_isolated(v) || mesh.is_manifold(v));
      {
        openmesh::Attached<TypeParam> attached(mesh);
        EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
      }
      EXPECT_EQ(faces_of(mesh), faces);
      const auto joined = cut.join();
      EXPECT_EQ(joined.copies, cut.copies());
      EXPECT_EQ(joined.left, 0U);
      EXPECT_EQ(connectivity(mesh), before);
      EXPECT_EQ(mesh.has_vertex_status(), had_status);
      for (const auto v : mesh.vertices()) EXPECT_TRUE(!had_status || !mesh.status(v).locked());
    }
  EXPECT_GT(cut_vertices, 100U);
}

TYPED_TEST(CutMesh, CopiesHaveAllPropertiesOfTheVertex) {
  // Two triangles that meet in a point: a bow tie.
  TypeParam mesh;
  for (const auto& p :
       std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}})
    mesh.add_vertex({p[0], p[1], p[2]});
  const auto v = [](int i) { return OpenMesh::VertexHandle(i); };
  mesh.add_face(v(0), v(1), v(2));
  mesh.add_face(v(0), v(3), v(4));
  OpenMesh::VPropHandleT<Anything> thing;
  OpenMesh::VPropHandleT<bool> flag;
  mesh.add_property(thing, "thing");
  mesh.add_property(flag, "flag");
  mesh.property(thing, v(0)) = {"nought", {1, 2, 3}};
  mesh.property(flag, v(0)) = true;
  mesh.request_vertex_status();
  mesh.status(v(0)).set_selected(true);
  openmesh::ManifoldCut cut(mesh);
  ASSERT_EQ(cut.copies(), 1U);
  ASSERT_EQ(mesh.n_vertices(), 6U);
  EXPECT_EQ(mesh.point(v(5)), mesh.point(v(0)));
  EXPECT_EQ(mesh.property(thing, v(5)), (Anything{"nought", {1, 2, 3}}));
  EXPECT_TRUE(mesh.property(flag, v(5)));
  EXPECT_TRUE(mesh.status(v(5)).selected());
  EXPECT_TRUE(mesh.status(v(5)).locked() && mesh.status(v(0)).locked());
  EXPECT_EQ(mesh.valence(v(0)), 2U);
  EXPECT_EQ(mesh.valence(v(5)), 2U);
  EXPECT_EQ(cut.join().copies, 1U);
  EXPECT_EQ(mesh.n_vertices(), 5U);
  EXPECT_EQ(mesh.valence(v(0)), 4U);
  EXPECT_FALSE(mesh.status(v(0)).locked());
  EXPECT_TRUE(mesh.status(v(0)).selected());
}

TYPED_TEST(CutMesh, IsJoinedAfterOperationsWithoutDoubleEdges) {
  std::mt19937 random(9);
  std::size_t copies = 0, operations = 0;
  for (const Shape& shape : this->shapes())
    for (int round = 0; round < 25; ++round) {
      TypeParam mesh = this->random_part(shape, random);
      if (mesh.n_faces() == 0) continue;
      openmesh::ManifoldCut cut(mesh);
      {
        openmesh::Attached<TypeParam> attached(mesh);
        for (int i = 0; i < 300; ++i) {
          const OpenMesh::EdgeHandle e(static_cast<int>(random() % mesh.n_edges()));
          if (mesh.status(e).deleted()) continue;
          const auto h = mesh.halfedge_handle(e, static_cast<unsigned>(random() % 2));
          const int what = static_cast<int>(random() % 4);
          operations += what == 0   ? bool(attached.split(e, 0.3))
                        : what == 1 ? bool(attached.swap(e))
                                    : bool(attached.collapse(h, Placement::at(0.5)));
        }
        EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
        if (random() % 2) attached.garbage_collection();
      }
      const auto faces = faces_of(mesh);
      copies += cut.copies();
      const auto joined = cut.join();
      EXPECT_EQ(joined.copies, cut.copies());
      EXPECT_EQ(joined.left, 0U);
      EXPECT_EQ(faces_of(mesh), faces);
      EXPECT_EQ(double_edges(mesh), 0U);
      EXPECT_EQ(openmesh::ManifoldCut(mesh).copies(), joined.copies);  // as many as it had come apart into
    }
  EXPECT_GT(copies, 50U);
  EXPECT_GT(operations, 2000U);
}

TEST(ManifoldCut, SimplicesWithTheSameVerticesComeApart) {
  // Two triangles back to back, which share all three edges.
  Mesh3 mesh;
  for (int i = 0; i < 3; ++i) mesh.add_vertex({double(i % 2), double(i / 2), 0});
  const auto v = [](int i) { return OpenMesh::VertexHandle(i); };
  mesh.add_face(v(0), v(1), v(2));
  mesh.add_face(v(0), v(2), v(1));
  ASSERT_EQ(mesh.n_faces(), 2U);
  EXPECT_THROW(openmesh::Attached<Mesh3>{mesh}, InputError);
  openmesh::ManifoldCut cut(mesh);
  EXPECT_EQ(cut.copies(), 3U);
  EXPECT_EQ(mesh.n_edges(), 6U);
  {
    openmesh::Attached<Mesh3> attached(mesh);
    EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
  }
  const auto joined = cut.join();  // in a point: more would be two edges with the same vertices
  EXPECT_EQ(joined.copies, 1U);
  EXPECT_EQ(joined.left, 2U);
  EXPECT_EQ(double_edges(mesh), 0U);
}

TEST(ManifoldCut, NeedsADetachedMeshAndJoinsWhenItGoes) {
  Mesh3 mesh;
  for (int i = 0; i < 5; ++i) mesh.add_vertex({double(i), double(i * i), 0});
  const auto v = [](int i) { return OpenMesh::VertexHandle(i); };
  mesh.add_face(v(0), v(1), v(2));
  mesh.add_face(v(0), v(3), v(4));
  {
    openmesh::ManifoldCut cut(mesh);
    openmesh::Attached<Mesh3> attached(mesh);
    EXPECT_EQ(mesh.n_vertices(), 6U);
    EXPECT_THROW(cut.join(), UsageError);
    EXPECT_THROW(cut.keep(), UsageError);
    EXPECT_THROW(openmesh::ManifoldCut{mesh}, UsageError);
  }
  EXPECT_EQ(mesh.n_vertices(), 5U);
  {
    openmesh::ManifoldCut cut(mesh);
    cut.keep();
  }
  EXPECT_EQ(mesh.n_vertices(), 6U);
  EXPECT_FALSE(mesh.has_vertex_status());
}

TEST(ManifoldCut, FilesThatOpenMeshReadsCanBeAttached) {
  namespace fs = std::filesystem;
  const fs::path folder = MULTIMESH_SHARED_DATA;
  if (!fs::exists(folder / "surface_dirty")) GTEST_SKIP() << "the collection is missing";
  std::size_t read = 0, cut_files = 0;
  omerr().disable();
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".obj" && extension != ".off" && extension != ".ply" && extension != ".stl") continue;
    if (fs::file_size(entry.path()) > 3'000'000) continue;
    SCOPED_TRACE(entry.path().filename().string());
    Mesh3 mesh;
    OpenMesh::IO::Options options;
    if (!OpenMesh::IO::read_mesh(mesh, entry.path().string(), options) || mesh.n_faces() == 0) continue;
    ++read;
    const auto before = connectivity(mesh);
    openmesh::ManifoldCut cut(mesh);
    cut_files += cut.copies() > 0;
    EXPECT_NO_THROW(openmesh::Attached<Mesh3>{mesh});
    const auto joined = cut.join();
    if (joined.left == 0) {
      EXPECT_EQ(connectivity(mesh), before);
    }
  }
  omerr().enable();
  EXPECT_GT(read, 50U);
  EXPECT_GT(cut_files, 20U);
}

}  // namespace
}  // namespace multimesh::test
