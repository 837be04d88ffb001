// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "multimesh/algorithms/surface_report.hpp"

namespace multimesh {

struct CompareOptions {
  /// Points per surface, uniform over its area; and as many along the seams.
  std::size_t samples = 60000;
  /// Of the random numbers. The same seed gives the same result on every machine.
  std::uint64_t seed = 1;
  /// 0: as many as there are cores. The result does not depend on it.
  unsigned threads = 0;
  /// Count components, charts, seams and so on: `CountedSurface::meshes`.
  bool topology = true;
  /// Fill `vertex_distance` and `vertex_deviation`.
  bool per_vertex = false;
};

// All lengths below are relative to the diagonal of the original's bounding box, but for `diagonal` itself.

/// Distance of the points of one surface to the other surface.
struct OneWayDistance {
  double rms = 0;  ///< over the samples
  double max = 0;  ///< over the samples and all vertices
};

/// |p - X(uv(p))| over the samples p, X the original's map from its texture to space: how far from p on the
/// original is what is painted at p (texture deviation of Cohen, Olano & Manocha 1998). Where charts of the
/// original overlap, or lie closer than 2e-5 of the diagonal of its texture, the place nearest to p counts;
/// outside of the texture, the nearest point of it. A point belongs to a chart of the original: where another
/// one is painted at p, the own one's point that is nearest in the texture counts as well, and the nearer to
/// p.
struct TextureDeviation {
  double rms = 0, mean = 0, p95 = 0, max = 0;
};

/// |X(left) - X(right)| along the seams: distance on the original of what meets there from both sides.
struct SeamCrack {
  double rms = 0, max = 0;  ///< over points in equal distances; 0 without seams
};

/// What becomes of the original's texture image on the other surface.
struct TextureComparison {
  TextureDeviation deviation;
  /// Peak signal to noise ratio in dB, if a smooth pattern of colours in space (color_pattern.hpp) was baked
  /// into the original's texture: its colour at X(uv(p)) against that at p's closest point. Infinite above
  /// 150 dB, where differences are roundings.
  double color_psnr = 0;
  SeamCrack crack;
  double outside = 0;      ///< share of the textured samples farther than 1e-6 UV diagonals from the texture
  double outside_own = 0;  ///< the same, from the chart that each belongs to
};

/// One of the two surfaces by itself.
struct CountedSurface {
  std::size_t triangles = 0;
  std::size_t untextured = 0;  ///< triangles without texture coordinates
  /// Triangles of the texture that are turned over against their chart. That has the orientation of its
  /// total area or, on the other surface, of the original's charts at the same places.
  std::size_t flipped = 0;
  /// Triangles of the texture whose area is below 1e-12 of the squared diagonal of the original's texture.
  std::size_t zero_area = 0;
  std::optional<SurfaceReport> meshes;
};

struct SurfaceComparison {
  double diagonal = 0;  ///< of the original's bounding box
  CountedSurface original, other;
  OneWayDistance to_original;                ///< of the other surface's points
  OneWayDistance from_original;              ///< of the original's points
  double rms = 0;                            ///< root of the mean of the two squares
  double hausdorff = 0;                      ///< the larger maximum
  std::optional<TextureComparison> texture;  ///< if both are textured
  /// Per position of the other surface, its distance to the original; 0 where no triangle has it. Empty
  /// without `per_vertex`.
  std::vector<double> vertex_distance;
  /// Likewise the texture deviation, the largest of the corners there; 0 without texture. Empty without
  /// `per_vertex`, or if one of the surfaces has no texture.
  std::vector<double> vertex_deviation;
};

/// How far `other`, a decimated version for instance, is from `original`: in space, and by what it shows if
/// it is drawn with the original's texture image. Cost: O(samples log n) and a tree over each surface;
/// seconds for a million triangles. \throw InputError if one has no triangles, the original is a single
/// point, a coordinate is not finite, or as TexturedSurface
SurfaceComparison compare_surfaces(const TexturedTriangles& original, const TexturedTriangles& other,
                                   const CompareOptions& options = {});

}  // namespace multimesh
