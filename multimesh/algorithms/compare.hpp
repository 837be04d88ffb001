// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "multimesh/algorithms/surface_report.hpp"

namespace multimesh {

struct CompareOptions {
  /// Points per surface, uniform over its area; and the same number along the seams.
  std::size_t samples = 60000;
  /// Seed of the random numbers. The same seed gives the same result on every machine.
  std::uint64_t seed = 1;
  /// 0: one per core. The result does not depend on it.
  unsigned threads = 0;
  /// Count components, charts, seams and so on: `CountedSurface::meshes`.
  bool topology = true;
  /// Fill `vertex_distance` and `vertex_deviation`.
  bool per_vertex = false;
};

// All lengths below are relative to the diagonal of the original's bounding box, except `diagonal` itself.

/// Distance of the points of one surface to the other surface.
struct OneWayDistance {
  double rms = 0;  ///< over the samples
  double max = 0;  ///< over the samples and all vertices
};

/// |p - X(uv(p))| over the samples p, X the original's map from its texture to space: the distance from p to
/// the point of the original whose content is drawn at p (texture deviation of Cohen, Olano & Manocha 1998).
/// Where charts of the original overlap, or lie closer than 2e-5 of the diagonal of its texture, the
/// candidate nearest to p counts; outside the texture, its nearest point. Each point belongs to a chart of
/// the original. Where another chart is drawn at p, the nearest point of its own chart in the texture is a
/// candidate too, and the one nearer to p counts.
struct TextureDeviation {
  double rms = 0, mean = 0, p95 = 0, max = 0;
};

/// |X(left) - X(right)| along the seams: distance on the original of the two sides that meet there.
struct SeamCrack {
  double rms = 0, max = 0;  ///< over equidistant points; 0 without seams
};

/// What the original's texture image shows on the other surface.
struct TextureComparison {
  TextureDeviation deviation;
  /// Peak signal to noise ratio in dB, assuming that a smooth pattern of colours in space (color_pattern.hpp)
  /// is baked into the original's texture: its colour at X(uv(p)) against that at p's closest point. Infinite
  /// above 150 dB, where differences are rounding errors.
  double color_psnr = 0;
  SeamCrack crack;
  double outside = 0;      ///< share of the textured samples farther than 1e-6 UV diagonals from the texture
  double outside_own = 0;  ///< the same, from the chart to which each belongs
};

/// One of the two surfaces on its own.
struct CountedSurface {
  std::size_t triangles = 0;
  std::size_t untextured = 0;  ///< triangles without texture coordinates
  /// Triangles of the texture that are flipped relative to their chart. A chart has the orientation of its
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
  /// Per position of the other surface, its distance to the original; 0 for positions without a triangle.
  /// Empty without `per_vertex`.
  std::vector<double> vertex_distance;
  /// Likewise the texture deviation, the largest of the corners there; 0 without texture. Empty without
  /// `per_vertex`, or if one of the surfaces has no texture.
  std::vector<double> vertex_deviation;
};

/// Measures how far `other`, for instance a decimated version, is from `original`: in space, and in what it
/// shows when drawn with the original's texture image. Cost: O(samples log n) and a tree over each surface;
/// seconds for a million triangles. \throw InputError if one has no triangles, the original is a single
/// point, a coordinate is not finite, or as TexturedSurface
SurfaceComparison compare_surfaces(const TexturedTriangles& original, const TexturedTriangles& other,
                                   const CompareOptions& options = {});

}  // namespace multimesh
