// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "multimesh/cut.hpp"
#include "multimesh/exact/point.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// Triangles in any state: they may cross, touch, overlap, repeat, have no area, and be oriented as they
/// like.
struct TriangleSoup {
  std::vector<Vec3> points;
  FacetList triangles;
  std::vector<std::int32_t> labels{};  ///< per triangle, or empty: all alike
};

/// Tetrahedra of a box around the points of a soup: of positive orientation, manifold, and convex as a whole.
struct BackgroundMesh {
  std::vector<std::array<double, 3>> points;  ///< those of the soup first
  FacetList tets;
  std::vector<Index> merged_to;  ///< per point of the soup: the first one that is equal, possibly itself
};

struct InsertOptions {
  /// Exactly coplanar neighbours with one label are inserted as one polygon, unless they overlap.
  bool merge_coplanar = true;
  /// New points are moved to points of few digits of the same segment or plane, where that changes nothing.
  bool snap = true;
  /// Points inside segments and polygons are taken out again where the surface is the same without them.
  bool thin = true;
  /// Points are put at the nearest doubles in the end, or up to 512 units in the last place away, where no
  /// tetrahedron is inverted by that.
  bool round = true;
  /// More new points than this are refused; 0: 50 per triangle, and 200,000.
  std::size_t most_points = 0;
  /// Called now and then with the share of what is done, in [0, 1]. May throw.
  std::function<void(double)> progress;
};

struct InsertReport {
  std::size_t polygons = 0, segments = 0, degenerate = 0;  ///< of the input; triangles without area
  std::size_t split_faces = 0, split_edges = 0;            ///< by segments
  std::size_t crossings = 0;                               ///< edges split by polygons
  std::size_t swapped = 0, snapped = 0, removed = 0;       ///< points that were taken out again
  std::size_t bits = 53;                                   ///< of the longest coordinate, before rounding
  std::size_t exact_points = 0;                            ///< that are no doubles, before rounding
  std::size_t unrounded = 0;                               ///< after it
};

/// The tetrahedra after insertion, and which of their faces the soup consists of.
struct Arrangement {
  std::vector<exact::Point> points;  ///< those of the background first; some are no corner of a tetrahedron
  FacetList tets;                    ///< of positive volume, exactly
  FacetList faces;                   ///< those in the soup, each once, oriented as the first of its triangles
  /// Per face the polygons that contain it, from begin[f] on, and whether it runs as they do.
  struct Cover {
    Index polygon;
    bool reversed;
  };
  std::vector<Cover> covers;
  std::vector<std::size_t> begin;
  std::vector<std::vector<Index>> triangles;  ///< per polygon: those of the input
  InsertReport report;
};

/// Inserts triangles exactly: each becomes a union of faces of the tetrahedra, however they lie to each
/// other. Segments are inserted by splitting what they pierce, polygons by splitting the edges that cross
/// their planes; coordinates are rational while they must be. In the end all is found again in a second pass,
/// and the sign of each tetrahedron is asked, exactly. The result depends only on the input.
///
/// \throw InputError if there are more new points than allowed; UsageError if the background does not fit.
/// Cost: near linear for surfaces that do not cross themselves; long thin triangles make many points.
Arrangement insert(const TriangleSoup& soup, const BackgroundMesh& background,
                   const InsertOptions& options = {});

}  // namespace multimesh
