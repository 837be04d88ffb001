// SPDX-License-Identifier: BSD-3-Clause
// The last step: the parts beside the surface or its curves get their sizes back.
#include <algorithm>
#include <array>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh::remeshing {

namespace {

/// Relative to each size.
constexpr double sizes_kept = 1e-9;
/// Sizes are not linear in the steps; and a step may be refused or shortened.
constexpr int most_rounds = 8;
/// No step is longer, relative to the requested length.
constexpr double longest_step = 0.05;
/// What bends by less (the sine of the angle) is straight, and stays so.
constexpr double straight = 1e-6;

}  // namespace

// Across it, in its plane; as long as the sine of the angle by which it turns there.
Vec3 Remesher::way_off_the_curve(Dart vertex, const std::array<Dart, 2>& line) const {
  const Vec3 here = at(vertex), before = at(mesh_.reorder(line[0], exchange_ends)),
             after = at(mesh_.reorder(line[1], exchange_ends));
  const double bend = cross((here - before).unit_or_zero(), (after - here).unit_or_zero()).norm();
  return cross(sizes_.normal(), after - before).unit_or_zero() * (bend > straight ? bend : 0);
}

// Along its normal; as long as the sine of the largest angle between it and that of a triangle.
Vec3 Remesher::way_off_the_surface(Dart vertex) {
  Vec3 normal;
  (void)centre(vertex, normal);
  normal = normal.unit_or_zero();
  double bend = 0;
  for (const Dart t : star_) {
    std::array<Index, 4> v{};
    mesh_.vertices(t, v.data());
    const Vec3 p = positions_.at(v[0]);
    const Vec3 n = cross(positions_.at(v[1]) - p, positions_.at(v[2]) - p).unit_or_zero();
    bend = std::max(bend, cross(n, normal).norm());
  }
  return normal * (bend > straight ? bend : 0);
}

// Of vertices with one copy: sides that are glued keep the sizes by themselves.
std::vector<PartSizes::Step> Remesher::steps_off_the_input() {
  const Freedom wanted = sizes_.are_areas() ? Freedom::line : Freedom::surface;
  std::vector<PartSizes::Step> steps;
  for (Index v = 0; v < mesh_.capacity(0); ++v) {
    if (!mesh_.is_live(0, v) || mesh_.dart_of(0, v) == no_dart) continue;
    const Dart d = mesh_.dart_of(0, v);
    std::array<Dart, 2> line{};
    if (freedom(d, line) != wanted) continue;
    copies_.collect(tree_, node_, d, 0);
    if (copies_.of(node_).size() > 1) continue;
    const Vec3 way = sizes_.are_areas() ? way_off_the_curve(d, line) : way_off_the_surface(d);
    if (way.squared_norm() > 0) steps.push_back({d, way});
  }
  return steps;
}

void Remesher::restore_sizes() {
  if (!sizes_.are_known()) return;
  const double most = longest_step * options_.length;
  for (int round = 0; round < most_rounds && sizes_.largest_change() > sizes_kept; ++round) {
    std::vector<PartSizes::Step> steps = steps_off_the_input();
    sizes_.scale(steps);
    for (const auto& [vertex, by] : steps) {
      const Vec3 step = by.norm() > most ? by * (most / by.norm()) : by;
      result_.moves += move(vertex, {at(vertex) + step, {}});
    }
  }
}

}  // namespace multimesh::remeshing
