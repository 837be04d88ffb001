// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/fit_copies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace multimesh {

namespace {

/// Relative to the diagonal: differences of copies, and of coordinates of points in one plane.
constexpr double rounding = 1e-15;
constexpr double noise = 1e-12;

/// The most frequent one; of several, the least.
double most_frequent(std::vector<double> values) {
  std::ranges::sort(values);
  double best = values.front();
  std::size_t most = 0;
  for (std::size_t i = 0, end = 0; i < values.size(); i = end) {
    while (end < values.size() && values[end] == values[i]) ++end;
    if (end - i > most) most = end - i, best = values[i];
  }
  return best;
}

/// Moves the vertices of two sides across an axis into two planes, if they lie there but for noise.
class SidePlanes {
 public:
  SidePlanes(std::size_t axis, LabelledTile& tile, const Lattice& lattice,
             const std::vector<Index>& representative)
      : axis_(axis),
        tile_(tile),
        lattice_(lattice),
        representative_(representative),
        side_(tile.point.size()) {}

  void flatten(double tolerance) {
    find_sides();
    if (height_ == 0 || !has_one_height_) return;
    const double low = most_frequent(lower_);
    const auto place = [&](Side side) { return side == Side::low ? low : low + height_; };
    for (Index v = 0; v < side_.size(); ++v)
      if (side_[v] != Side::none && !(std::abs(tile_.point[v][axis_] - place(side_[v])) <= tolerance)) return;
    for (Index v = 0; v < side_.size(); ++v)
      if (side_[v] != Side::none) tile_.point[v][axis_] = place(side_[v]);
  }

 private:
  enum class Side : std::uint8_t { none, low, high };

  /// How much higher a vertex is than its representative.
  double step(Index v) const {
    return lattice_.shift(tile_.offset[v] - tile_.offset[representative_[v]])[axis_];
  }
  void find_sides() {
    for (Index v = 0; v < side_.size(); ++v) {
      const double s = is_used(v) ? step(v) : 0;
      if (s == 0) continue;
      if (height_ == 0) height_ = std::abs(s);
      has_one_height_ = has_one_height_ && std::abs(s) == height_;
      side_[v] = s > 0 ? Side::high : Side::low;
      side_[representative_[v]] = s > 0 ? Side::low : Side::high;
    }
    for (Index v = 0; v < side_.size(); ++v) {
      if (is_used(v) && step(v) == 0) side_[v] = side_[representative_[v]];
      if (side_[v] == Side::low) lower_.push_back(tile_.point[v][axis_]);
    }
  }
  bool is_used(Index v) const { return tile_.vertex_class[v] != no_index; }

  std::size_t axis_;
  LabelledTile& tile_;
  const Lattice& lattice_;
  const std::vector<Index>& representative_;
  std::vector<Side> side_;  // per vertex
  std::vector<double> lower_;
  double height_ = 0;
  bool has_one_height_ = true;
};

}  // namespace

Vec3 box_without_noise(std::span<const Vec3> points, std::span<const Index> used, double diagonal) {
  Vec3 sizes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::ranges::minmax(used, {}, [&](Index v) { return points[v][i]; });
    std::array<std::vector<double>, 2> near;
    for (const Index v : used) {
      if (points[v][i] - points[low][i] <= noise * diagonal) near[0].push_back(points[v][i]);
      if (points[high][i] - points[v][i] <= noise * diagonal) near[1].push_back(points[v][i]);
    }
    sizes[i] = most_frequent(std::move(near[1])) - most_frequent(std::move(near[0]));
  }
  return sizes;
}

double fit_copies(LabelledTile& tile, const Lattice& lattice, VertexClasses& classes, double diagonal) {
  std::vector<Index> representative(tile.point.size());
  double largest = 0;
  for (Index v = 0; v < tile.point.size(); ++v) {
    if (tile.vertex_class[v] == no_index) continue;
    const Index r = representative[v] = classes.representative(v);
    if (r == v) continue;
    const Vec3 shift = lattice.shift(tile.offset[v]), place = tile.point[r] + shift;
    const double distance = (place - tile.point[v]).norm() / diagonal;
    largest = std::max(largest, distance);
    for (std::size_t i = 0; i < 3; ++i)
      if (distance > rounding || shift[i] == 0) tile.point[v][i] = place[i];
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    SidePlanes(axis, tile, lattice, representative).flatten(noise * diagonal);
  return largest;
}

}  // namespace multimesh
