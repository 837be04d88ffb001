// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace multimesh::test {

template <class PointT, unsigned halfedge_attributes = 0>
struct TexturedTraits : OpenMesh::DefaultTraits {
  using Point = PointT;
  using Normal = PointT;
  using TexCoord2D = OpenMesh::Vec2d;
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D |
                     halfedge_attributes);
};
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<TexturedTraits<OpenMesh::Vec3d>>;
using FloatMesh =
    OpenMesh::TriMesh_ArrayKernelT<TexturedTraits<OpenMesh::Vec3f, OpenMesh::Attributes::Status>>;

/// n x m squares on a torus with waves, or on a sheet of it with a boundary. Its texture is made of `charts`
/// x `charts` pieces, apart from each other.
template <class Mesh>
void make_torus(Mesh& mesh, int n, int m, int charts, bool open) {
  using Real = typename Mesh::Scalar;
  const int columns = open ? n + 1 : n, rows = open ? m + 1 : m;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double a = 2 * std::numbers::pi * i / (1.2 * n), b = 2 * std::numbers::pi * j / m;
      const double r = 1 + 0.1 * std::sin(3 * a) + 0.05 * std::cos(5 * b);
      mesh.add_vertex({Real((3 + r * std::cos(b)) * std::cos(a)), Real((3 + r * std::cos(b)) * std::sin(a)),
                       Real(r * std::sin(b) + (open ? 0.1 * j : 0))});
    }
  const auto face = [&](std::array<std::array<int, 2>, 3> corners) {
    std::vector<OpenMesh::VertexHandle> v;
    const auto vertex = [&](int i, int j) { return OpenMesh::VertexHandle(i % columns * rows + j % rows); };
    for (const auto& [i, j] : corners) v.push_back(vertex(i, j));
    const auto f = mesh.add_face(v);
    const int left = std::min({corners[0][0], corners[1][0], corners[2][0]});
    const int low = std::min({corners[0][1], corners[1][1], corners[2][1]});
    const int chart = left * charts / n * charts + low * charts / m;
    for (const auto h : mesh.fh_range(f))
      for (const auto& [i, j] : corners)
        if (mesh.to_vertex_handle(h) == vertex(i, j))
          mesh.set_texcoord2D(h, {i + 1000.0 * chart, j + 0.1 * std::sin(i)});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      face({{{i, j}, {i + 1, j}, {i + 1, j + 1}}}), face({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
}

/// Triangles whose texture coordinates have the opposite orientation, or no area.
template <class Mesh>
std::size_t mirrored_triangles(const Mesh& mesh) {
  std::size_t mirrored = 0;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge_handle(f);
    const auto a = mesh.texcoord2D(h), b = mesh.texcoord2D(mesh.next_halfedge_handle(h)),
               c = mesh.texcoord2D(mesh.prev_halfedge_handle(h));
    mirrored += (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]) <= 0;
  }
  return mirrored;
}

}  // namespace multimesh::test
