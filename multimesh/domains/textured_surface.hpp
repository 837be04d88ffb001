// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "multimesh/domains/curve_kind.hpp"
#include "multimesh/domains/textured_triangles.hpp"
#include "multimesh/multi_mesh.hpp"

namespace multimesh {

class Embedding;

struct TexturedSurfaceOptions {
  /// Edges whose two faces' normals differ by at least this angle become curves, in radians. Faces without
  /// area create none.
  double feature_angle = std::numeric_limits<double>::infinity();
  /// Borders between labels become curves.
  bool keep_label_borders = true;
};

/// What had to be changed in the input to make it manifold.
struct CutReport {
  std::size_t copied_vertices = 0;     ///< copies made of vertices at which the surface is not manifold
  std::size_t reversed_triangles = 0;  ///< reversed to agree with their neighbours
  std::size_t triangles_without_texcoords = 0;  ///< of set 0
};

/// A textured surface as a multimesh:
///
///           surface (positions)             the root: triangles, cut where they are not manifold
///          /        |          \            .
///    texture(s)    ...        curves        texture: the triangles with texture coordinates, one vertex per
///    (UVs)                                 corner class; curves: edges of any CurveKind, ending at their
///                                          junctions and wherever their kind changes
///
/// Two corners at one position are one vertex of the texture if their texture coordinates have equal values.
/// Copies of one input vertex are locked, so that they can be joined again.
class TexturedSurface {
 public:
  /// \throw InputError naming the triangle for indices out of range, a repeated vertex in a triangle, or
  /// texture coordinates on some corners only; for lists of the wrong length, more than max_uv_sets sets, or
  /// an empty set beside others; for a feature angle that is not above 0. Cost: O(n log n)
  explicit TexturedSurface(const TexturedTriangles& input, const TexturedSurfaceOptions& options = {});
  ~TexturedSurface();
  TexturedSurface(TexturedSurface&&) noexcept;

  /// The current surface, without labels. Copies of one input position that were cut apart are one again;
  /// texture coordinates with equal values are written once per set. `source`: the input triangle of each
  /// triangle.
  TexturedTriangles triangles(std::vector<Index>& source) const;

  MultiMesh& tree();
  const MultiMesh& tree() const;
  /// All its values; nothing comes together that a reader would join; hard edges stay hard. A snapshot: must
  /// not outlive the surface, and must be remade after edits by other code. Cost: linear
  Embedding embedding();
  std::optional<NodeId> texture() const;     ///< of set 0, if any triangle has texture coordinates
  std::span<const NodeId> textures() const;  ///< by set; empty if there is none
  std::optional<NodeId> seams() const;       ///< the curves of all kinds, if there are any
  std::vector<Vec3>& positions();
  const std::vector<Vec3>& positions() const;
  /// Per vertex of the texture of a set; empty if there is no such texture.
  std::vector<Vec2>& texcoords(std::size_t set = 0);
  const std::vector<Vec2>& texcoords(std::size_t set = 0) const;
  /// Per vertex of the surface, red, green and blue in [0, 1]; empty if the input has none.
  std::vector<Vec3>& colors();
  const std::vector<Vec3>& colors() const;
  /// Per vertex of the surface, the input position that it is, or is a copy of.
  const std::vector<Index>& source_positions() const;
  std::size_t live_triangles() const;
  const CutReport& cut_report() const;

  /// What runs along an edge of the surface; the dart begins with it. no_curve if nothing does.
  CurveKinds curve_kinds(Dart root_edge) const;
  /// The same for an edge of the mesh seams(). \pre there are curves
  CurveKinds curve_kinds_of(Index curve_edge) const;

  /// Whether a vertex of the surface is one of several copies of an input vertex.
  bool is_copy(Index vertex) const;
  /// Locks a vertex of the surface, so that it must keep its place, or removes the lock. Copies stay
  /// locked.
  void set_locked(Index vertex, bool on);

  /// Whether the input has normals. If not, no edge is hard, and none can be made hard.
  bool has_normals() const;
  /// Whether the two triangles at an edge of the surface are shaded with different normals there.
  bool hard(Index edge) const;
  /// \pre has_normals()
  void set_hard(Index edge, bool on = true);
  /// For a triangle of the surface: ShadingBits except for the edges, in the orientation of the input.
  unsigned triangle_shading(Index triangle) const;
  /// Whether a triangle of the surface was reversed, and is reversed back by triangles().
  bool is_reversed(Index triangle) const;

  struct Data;  ///< private to the implementation

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace multimesh
