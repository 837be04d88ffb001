// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "multimesh/embedding.hpp"
#include "multimesh/geometry/vector.hpp"
#include "multimesh/spatial/triangle_tree.hpp"
#include "multimesh/strata.hpp"

namespace multimesh::remeshing {

/// A point of the input, and the coordinates of the meshes below at that point: on a curve, one set per side,
/// contiguous.
struct Place {
  Vec3 position;
  struct Below {
    std::size_t mesh;  ///< index into the coordinates
    Vec3 at;
  };
  std::vector<Below> below;
};

/// The original surface, its patches (the parts between curves) and its curves (between vertices that stay).
/// A vertex belongs to one of them permanently, so it never jumps to another sheet.
class Reference {
 public:
  /// Numbers of patches and lines are those of faces and edges, which the operations hand on: `patch` per
  /// face; `line` per edge, one more than the number, 0 for plain edges. Cost: O(n log n)
  Reference(const EmbeddedMesh& surface, Strata& strata, std::vector<Index>& patch, std::vector<Index>& line);

  /// The point of a patch closest to p among those whose normal is within 90 degrees of `normal`. If it is
  /// within `expected` of p, points that are farther away cost nothing.
  std::optional<Place> on_patch(Index patch, const Vec3& p, const Vec3& normal, double expected) const;
  /// Whether any point of the surface is within a distance of p.
  bool has_within(const Vec3& p, double distance) const { return triangles_->has_within(p, distance); }
  std::optional<Place> on_line(Index line, const Vec3& p, double expected) const;

 private:
  struct Values {  ///< of one mesh below, at the corners of a triangle or the ends of a segment
    std::size_t mesh;
    std::array<Vec3, 3> at;
  };
  /// Triangles, or segments as triangles without area, and what is below each: from begin[i] on.
  struct Layer {
    std::vector<Index> group;
    std::vector<Vec3> normal;
    std::vector<std::uint32_t> begin{0};
    std::vector<Values> below;
    std::vector<spatial::Triangle> triangles;
  };
  void add_triangles(std::vector<Index>& patch);
  void add_segments(std::vector<Index>& line);
  void number_patches(std::vector<Index>& patch);
  void number_lines(std::vector<Index>& line);
  void add(Layer& layer, Dart d, int k, Index group);
  /// For the triangles of a group for which `look` is true.
  template <class Look>
  static std::optional<Place> closest(const Layer& layer, const spatial::TriangleTree& tree, Index group,
                                      const Vec3& p, double expected, Look look);
  static Place place(const Layer& layer, const spatial::TriangleTree& tree, const spatial::Nearby& found);

  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  const Coordinates& positions_;
  std::span<Coordinates* const> below_;
  Strata& strata_;
  Layer patches_, lines_;
  std::optional<spatial::TriangleTree> triangles_, segments_;
};

}  // namespace multimesh::remeshing
