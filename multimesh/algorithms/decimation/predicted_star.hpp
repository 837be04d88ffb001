// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/algorithms/decimation/surface_triangle.hpp"

namespace multimesh::decimation {

/// The triangles around an edge that may be collapsed, in all sheets, as they are and as a plan would make
/// them: placements are judged on it before anything is touched.
///
///     .---b---.      .-------.      `faces`: those around a or b; corner 0 is that end. Those over the edge
///    / \ / \ / \    / \     / \     die: their corners 0 and 1 are a and b.
///   .---l   r---.   .--- v ---.
///    \ / \ / \ /    \ /     \ /
///     .---a---.      .-------.
class PredictedStar {
 public:
  struct Face {
    SurfaceTriangle before;
    End end = End::a;
    bool dies = false;
    bool changes = false;  ///< by the plan
    Vec3 from_first{};     ///< how far its sheet lies from the first one: not 0 in periodic tiles
    /// Corner 0 after the plan.
    Vec3 position;
    std::array<Vec2, max_sets> texcoords;

    std::array<Vec3, 3> positions_after() const {
      return {position, before.positions[1], before.positions[2]};
    }
    std::array<Vec2, 3> texcoords_after(std::size_t set) const {
      const auto& t = before.sets[set].texcoords;
      return {texcoords[set], t[1], t[2]};
    }
  };

  explicit PredictedStar(const TriangleReader& reader) : mesh_(reader.mesh()), reader_(reader) {}

  /// Reads the star of an edge dart (a, b, ...) of the surface. Re-uses its memory. Cost: that of the star.
  void read(Dart e);
  /// Predicts the star after a plan for this edge.
  void place(const CollapsePlan& plan);

  std::span<const Face> faces() const { return {faces_.data(), n_faces_}; }
  std::size_t n_sets() const { return reader_.n_sets(); }

 private:
  Face& next_face();
  void read_end(Dart end, End which, const Vec3& from_first);
  bool was_read(Index vertex, std::size_t sheets, End which) const;
  bool is_dying(Index facet) const;

  const Mesh& mesh_;
  const TriangleReader& reader_;
  std::vector<Face> faces_;
  std::size_t n_faces_ = 0, n_dying_ = 0;  ///< the dying ones come first
  DartBuffer star_, sheets_;
  std::vector<CollapsePlan::Ends> ends_;  ///< by sheet
};

}  // namespace multimesh::decimation
