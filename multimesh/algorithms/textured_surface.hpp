// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "multimesh/multi_mesh.hpp"

namespace multimesh {

/// Triangles by corners, as files have them: a position and perhaps a texture coordinate per corner.
struct TexturedTriangles {
  struct Corner {
    std::int32_t position = 0;
    std::int32_t texcoord = -1;  ///< -1: none; a triangle has three or none
  };
  std::vector<OpenMesh::Vec3d> positions;  ///< #V
  std::vector<OpenMesh::Vec2d> texcoords;  ///< #VT
  std::vector<std::array<Corner, 3>> triangles;
  /// A label per triangle, or empty: materials, for instance. Borders between labels are kept as curves.
  std::vector<Index> labels;
};

/// What had to be done to the input to make it manifold.
struct CutReport {
  std::size_t copied_vertices = 0;     ///< copies made of vertices at which the surface is not manifold
  std::size_t reversed_triangles = 0;  ///< turned round to agree with their neighbours
  std::size_t triangles_without_texcoords = 0;
};

/// A textured surface as a multimesh:
///
///      surface (positions)            the root: triangles, cut where they are not manifold
///       /              \              .
///    texture (UVs)    seams            texture: the triangles with texture coordinates, one vertex per
///                                     corner class; seams: the curves where it is cut open, those
///                                     between labels, and those around triangles that had to be turned
///                                     round, ending at their junctions and wherever their kind changes
///
/// Two corners at one position are one vertex of the texture if their texture coordinates have equal values.
/// Copies of one input vertex are locked, so that they can be joined again.
class TexturedSurface {
 public:
  /// \throw InputError naming the triangle for indices out of range, a repeated vertex in a triangle, or
  /// texture coordinates on some corners only
  explicit TexturedSurface(const TexturedTriangles& input);
  ~TexturedSurface();
  TexturedSurface(TexturedSurface&&) noexcept;

  /// The surface as it is now. Copies of one input position that were cut apart are one again; texture
  /// coordinates with equal values are written once. `source`: the input triangle of each triangle.
  TexturedTriangles triangles(std::vector<Index>& source) const;

  MultiMesh& tree();
  const MultiMesh& tree() const;
  std::optional<NodeId> texture() const;  ///< if any triangle has texture coordinates
  std::vector<NodeId> textures() const { return texture() ? std::vector<NodeId>{*texture()} : std::vector<NodeId>{}; }
  const std::vector<OpenMesh::Vec2d>& texcoords(std::size_t) const { return texcoords(); }
  std::vector<OpenMesh::Vec2d>& texcoords(std::size_t) { return texcoords(); }
  bool is_seam_only(Dart e) const { DartBuffer b; if (texture()) tree().to_child(*texture(), e, 1, b); return b.size() == 2; }
  std::optional<NodeId> seams() const;    ///< if there are such curves
  std::vector<OpenMesh::Vec3d>& positions();
  const std::vector<OpenMesh::Vec3d>& positions() const;
  std::vector<OpenMesh::Vec2d>& texcoords();
  const std::vector<OpenMesh::Vec2d>& texcoords() const;
  /// Per vertex of the surface, the input position that it is (a copy of).
  const std::vector<Index>& source_positions() const;
  std::size_t live_triangles() const;
  const CutReport& cut_report() const;

  struct Data;  ///< private to the implementation

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace multimesh
