// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/compare.hpp"

#include <cmath>
#include <string>

#include "multimesh/algorithms/comparison/color_pattern.hpp"
#include "multimesh/algorithms/comparison/distances.hpp"
#include "multimesh/algorithms/comparison/texture_comparison.hpp"
#include "multimesh/error.hpp"

namespace multimesh {

using spatial::Nearby;
using spatial::TriangleTree;

namespace comparison {
namespace {

struct Box {
  Vec3 low;
  double diagonal;
};

Box bounding_box(const TexturedTriangles& s) {
  Vec3 low = position(s, s.triangles[0][0]), high = low;
  for (const Corners& t : s.triangles)
    for (const auto& c : t) low = min(low, position(s, c)), high = max(high, position(s, c));
  return {low, (high - low).norm()};
}

void check(const TexturedTriangles& s, const std::string& name) {
  if (s.triangles.empty()) throw InputError("the " + name + " surface has no triangles");
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (const auto& c : s.triangles[t])
      if (c.position < 0 || static_cast<std::size_t>(c.position) >= s.positions.size() ||
          (c.texcoord >= 0 && static_cast<std::size_t>(c.texcoord) >= s.texcoords.size()))
        throw InputError("the " + name + " surface, triangle " + std::to_string(t) +
                         ": an index is out of range");
  check_size(s);
}

double root_mean_square(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v * v;
  return x.empty() ? 0 : std::sqrt(sum / static_cast<double>(x.size()));
}

double maximum(const std::vector<double>& x) {
  return x.empty() ? 0 : *std::max_element(x.begin(), x.end());
}

TextureDeviation summary(std::vector<double> x) {
  TextureDeviation d;
  if (x.empty()) return d;
  d.rms = root_mean_square(x);
  for (const double v : x) d.mean += v;
  d.mean /= static_cast<double>(x.size());
  d.max = maximum(x);
  const auto p95 = x.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(x.size() - 1));
  std::nth_element(x.begin(), p95, x.end());
  d.p95 = *p95;
  return d;
}

bool has_texture(const TexturedTriangles& s) {
  return std::any_of(s.triangles.begin(), s.triangles.end(), [](const Corners& t) { return is_textured(t); });
}

void set_flips(CountedSurface& counted, const Flips& flips) {
  counted.flipped = flips.flipped;
  counted.zero_area = flips.zero_area;
}

class Comparison {
 public:
  Comparison(const TexturedTriangles& original, const TexturedTriangles& other, const CompareOptions& options)
      : original_(original), other_(other), options_(options), box_(bounding_box(original)) {
    if (!(box_.diagonal > 0)) throw InputError("the original surface is a single point");
    out_.diagonal = box_.diagonal;
  }
  SurfaceComparison run();

 private:
  void compare_distances();
  OneWayDistance summary_of(const std::vector<Nearby>& at_samples,
                            const std::vector<Nearby>& at_vertices) const;
  void compare_textures();
  double color_psnr(const std::vector<Index>& textured, const std::vector<TextureMap::Place>& places) const;
  SeamCrack seam_crack(const TextureMap& map, const ChartPairs& charts, const EdgeSides& sides) const;
  void vertex_deviation(const TextureMap& map, const ChartPairs& charts);
  void compare_samples(const TextureMap& map, const ChartPairs& charts);

  double relative(double length) const { return length / box_.diagonal; }
  double relative(const Nearby& n) const { return relative(std::sqrt(n.squared_distance)); }

  const TexturedTriangles &original_, &other_;
  const CompareOptions& options_;
  const Box box_;
  std::vector<Sample> samples_;      // of the other surface
  std::vector<Vec3> points_;         // their positions
  std::vector<Vec3> closest_point_;  // of the original, to each
  SurfaceComparison out_;
};

OneWayDistance Comparison::summary_of(const std::vector<Nearby>& at_samples,
                                      const std::vector<Nearby>& at_vertices) const {
  std::vector<double> d;
  for (const Nearby& n : at_samples) d.push_back(relative(n));
  OneWayDistance result{root_mean_square(d), maximum(d)};
  for (const Nearby& n : at_vertices) result.max = std::max(result.max, relative(n));
  return result;
}

std::vector<Vec3> positions(const TexturedTriangles& surface, const std::vector<Index>& which) {
  std::vector<Vec3> all;
  for (const Index i : which) all.push_back(surface.positions[i]);
  return all;
}

void Comparison::compare_distances() {
  const unsigned threads = options_.threads;
  {
    const TriangleTree tree = tree_in_space(original_);
    samples_ = sample(other_, options_.samples, options_.seed);
    points_ = points(other_, samples_);
    const auto at_samples = closest(tree, points_, threads);
    const auto used = used_positions(other_);
    const auto at_vertices = closest(tree, positions(other_, used), threads);
    out_.to_original = summary_of(at_samples, at_vertices);
    for (const Nearby& n : at_samples)
      closest_point_.push_back(spatial::at(tree.triangles()[n.facet], n.barycentric));
    if (options_.per_vertex) {
      out_.vertex_distance.assign(other_.positions.size(), 0);
      for (std::size_t i = 0; i < used.size(); ++i) out_.vertex_distance[used[i]] = relative(at_vertices[i]);
    }
  }
  const TriangleTree tree = tree_in_space(other_);
  const auto at_samples =
      closest(tree, points(original_, sample(original_, options_.samples, options_.seed)), threads);
  const auto at_vertices = closest(tree, positions(original_, used_positions(original_)), threads);
  out_.from_original = summary_of(at_samples, at_vertices);
  out_.rms = std::sqrt(
      (out_.to_original.rms * out_.to_original.rms + out_.from_original.rms * out_.from_original.rms) / 2);
  out_.hausdorff = std::max(out_.to_original.max, out_.from_original.max);
}

double Comparison::color_psnr(const std::vector<Index>& textured,
                              const std::vector<TextureMap::Place>& places) const {
  const auto color = [&](const Vec3& x) { return color_pattern((x - box_.low) / box_.diagonal); };
  std::vector<double> difference;
  for (std::size_t i = 0; i < places.size(); ++i)
    difference.push_back((color(places[i].position) - color(closest_point_[textured[i]])).norm());
  const double per_channel = root_mean_square(difference) / std::sqrt(3.0);
  constexpr double rounding = 150;  // dB
  const double psnr = per_channel > 0 ? -20 * std::log10(per_channel) : 2 * rounding;
  return psnr > rounding ? std::numeric_limits<double>::infinity() : psnr;
}

SeamCrack Comparison::seam_crack(const TextureMap& map, const ChartPairs& charts,
                                 const EdgeSides& sides) const {
  const SeamPoints points = sample_seams(seam_edges(other_, sides), options_.samples);
  auto left = painted(map, points.left, options_.threads);
  auto right = painted(map, points.right, options_.threads);
  (void)charts.move_into_charts(map, points.left, left, options_.threads);
  (void)charts.move_into_charts(map, points.right, right, options_.threads);
  std::vector<double> crack;
  for (std::size_t i = 0; i < left.size(); ++i)
    crack.push_back(relative((left[i].position - right[i].position).norm()));
  return {root_mean_square(crack), maximum(crack)};
}

void Comparison::vertex_deviation(const TextureMap& map, const ChartPairs& charts) {
  std::vector<TexturedPoint> corners;
  std::vector<std::int32_t> at;
  for (Index t = 0; t < other_.triangles.size(); ++t)
    for (const auto& c : other_.triangles[t]) {
      if (c.texcoord < 0) continue;
      corners.push_back({position(other_, c), texcoord(other_, c), t});
      at.push_back(c.position);
    }
  auto places = painted(map, corners, options_.threads);
  (void)charts.move_into_charts(map, corners, places, options_.threads);
  out_.vertex_deviation.assign(other_.positions.size(), 0);
  for (std::size_t i = 0; i < at.size(); ++i) {
    double& d = out_.vertex_deviation[static_cast<std::size_t>(at[i])];
    d = std::max(d, relative((places[i].position - corners[i].position).norm()));
  }
}

void Comparison::compare_textures() {
  const EdgeSides original_sides(original_), other_sides(other_);
  const auto original_chart = charts(original_, original_sides);
  const auto original_orientation = sum_over_charts(original_chart, uv_areas(original_));
  const auto other_chart = charts(other_, other_sides);
  auto other_orientation = sum_over_charts(other_chart, uv_areas(other_));
  if (!has_texture(original_)) {
    set_flips(out_.other, count_flips(other_, other_orientation, 0));
    return;
  }
  const TextureMap map(original_);
  const double tolerance = 1e-12 * map.diagonal() * map.diagonal();
  set_flips(out_.original, count_flips(original_, original_orientation, tolerance));
  if (!has_texture(other_)) return;
  const PaintedCentroids centroids = painted_centroids(other_, map, options_.threads);
  other_orientation = orientation_by_original(original_orientation, other_, other_chart, centroids);
  set_flips(out_.other, count_flips(other_, other_orientation, tolerance));
  const ChartPairs pairs(original_chart, other_, other_chart, centroids, box_.diagonal);
  compare_samples(map, pairs);
  out_.texture->crack = seam_crack(map, pairs, other_sides);
  if (options_.per_vertex) vertex_deviation(map, pairs);
}

void Comparison::compare_samples(const TextureMap& map, const ChartPairs& charts) {
  std::vector<Index> textured;  // of the samples
  for (Index i = 0; i < samples_.size(); ++i)
    if (is_textured(other_.triangles[samples_[i].triangle])) textured.push_back(i);
  const std::vector<TexturedPoint> at = textured_points(other_, samples_);
  auto places = painted(map, at, options_.threads);
  TextureComparison& result = out_.texture.emplace();
  for (const TextureMap::Place& place : places) result.outside += place.uv_distance > map.rounding();
  const double n = std::max(1.0, static_cast<double>(at.size()));
  result.outside /= n;
  result.color_psnr = color_psnr(textured, places);
  result.outside_own = static_cast<double>(charts.move_into_charts(map, at, places, options_.threads)) / n;
  std::vector<double> deviation;
  for (std::size_t i = 0; i < at.size(); ++i)
    deviation.push_back(relative((places[i].position - at[i].position).norm()));
  result.deviation = summary(std::move(deviation));
}

SurfaceComparison Comparison::run() {
  for (auto [surface, counted] : {std::pair(&original_, &out_.original), std::pair(&other_, &out_.other)}) {
    counted->triangles = surface->triangles.size();
    counted->untextured =
        static_cast<std::size_t>(std::count_if(surface->triangles.begin(), surface->triangles.end(),
                                               [](const Corners& t) { return !is_textured(t); }));
    if (options_.topology) counted->meshes = report(TexturedSurface(*surface));
  }
  compare_distances();
  compare_textures();
  return std::move(out_);
}

}  // namespace
}  // namespace comparison

SurfaceComparison compare_surfaces(const TexturedTriangles& original, const TexturedTriangles& other,
                                   const CompareOptions& options) {
  comparison::check(original, "original");
  comparison::check(other, "other");
  return comparison::Comparison(original, other, options).run();
}

}  // namespace multimesh
