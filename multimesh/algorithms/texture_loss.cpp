// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/texture_loss.hpp"

#include <cmath>

#include "multimesh/algorithms/comparison/texture_comparison.hpp"
#include "multimesh/geometry/bounding_box.hpp"

namespace multimesh {

namespace {

using namespace comparison;

bool has_texture(const TexturedTriangles& surface) {
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), is_textured);
}

bool is_tolerable(const TextureQuality& q) {
  return q.deviation <= tolerable_texture.deviation && q.outside <= tolerable_texture.outside;
}

/// Measures surfaces against one original.
class TextureMeter {
 public:
  explicit TextureMeter(const TexturedTriangles& original)
      : map_(original),
        chart_(charts(original, EdgeSides(original))),
        diagonal_(bounding_box_diagonal(original.positions)) {}

  TextureQuality operator()(const TexturedTriangles& surface) const {
    constexpr std::size_t samples = 10'000;
    constexpr std::uint64_t seed = 1;
    constexpr unsigned threads = 1;
    const PaintedCentroids centroids = painted_centroids(surface, map_, threads);
    const ChartPairs pairs(chart_, surface, charts(surface, EdgeSides(surface)), centroids, diagonal_);
    const std::vector<TexturedPoint> points = textured_points(surface, sample(surface, samples, seed));
    if (points.empty()) return {};
    std::vector<TextureMap::Place> places = painted(map_, points, threads);
    const double n = static_cast<double>(points.size());
    TextureQuality quality;
    quality.outside = static_cast<double>(pairs.move_into_charts(map_, points, places, threads)) / n;
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      squares += (places[i].position - points[i].position).squared_norm();
    quality.deviation = std::sqrt(squares / n) / diagonal_;
    return quality;
  }

 private:
  TextureMap map_;
  std::vector<Index> chart_;
  double diagonal_;
};

/// Numbers of faces to measure during the run, each four fifths of the previous one.
std::vector<std::size_t> levels_between(std::size_t from, std::size_t to) {
  std::vector<std::size_t> levels;
  for (std::size_t n = from - from / 5; n > to && (levels.empty() || n < levels.back()); n -= n / 5)
    levels.push_back(n);
  return levels;
}

}  // namespace

bool may_have_lost_texture(const DecimateOptions& options, const DecimateResult& result) {
  constexpr double high_cost = 0.008;
  constexpr std::size_t faces_per_chart = 10;
  if (result.charts == 0 || result.collapsed == 0 || std::isfinite(options.max_texture_error)) return false;
  return result.max_cost > high_cost || result.faces_after < faces_per_chart * result.charts ||
         result.stop != DecimateResult::Stop::faces;
}

std::optional<TextureLoss> find_texture_loss(const TexturedTriangles& input,
                                             const TexturedSurfaceOptions& surface_options,
                                             const DecimateOptions& options, const DecimateResult& result,
                                             const TexturedTriangles& left) {
  if (!has_texture(input) || !has_texture(left)) return std::nullopt;
  const TextureMeter measure(input);
  TextureLoss loss;
  loss.at_end = measure(left);
  if (is_tolerable(loss.at_end)) return std::nullopt;
  TexturedSurface surface(input, surface_options);
  DecimateOptions again = options;
  again.faces = result.faces_after;
  again.levels = levels_between(result.faces_before, result.faces_after);
  again.progress = nullptr;
  bool lost = false;
  again.on_level = [&](std::size_t) {
    std::vector<Index> source;
    lost = lost || !is_tolerable(measure(surface.triangles(source)));
    if (!lost) loss.faces = surface.live_triangles();
  };
  (void)decimate(surface, again);
  return loss;
}

}  // namespace multimesh
