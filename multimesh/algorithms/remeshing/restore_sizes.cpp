// SPDX-License-Identifier: BSD-3-Clause
// The last step: parts of a plane surface get their areas back.
#include <array>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh::remeshing {

namespace {

/// Relative to each area.
constexpr double sizes_kept = 1e-9;
/// Areas are quadratic in the steps; a step may be refused or shortened.
constexpr int most_rounds = 8;
/// No step is longer, relative to the requested length.
constexpr double longest_step = 0.05;

}  // namespace

// Sides that are glued keep the area by themselves.
std::vector<PartSizes::CurveVertex> Remesher::bounds_of_parts() {
  std::vector<PartSizes::CurveVertex> found;
  for (Index v = 0; v < mesh_.capacity(0); ++v) {
    if (!mesh_.is_live(0, v) || mesh_.dart_of(0, v) == no_dart) continue;
    const Dart d = mesh_.dart_of(0, v);
    std::array<Dart, 2> line{};
    if (freedom(d, line) != Freedom::line) continue;
    copies_.collect(tree_, node_, d, 0);
    if (copies_.of(node_).size() > 1) continue;
    found.push_back(
        {d, at(mesh_.reorder(line[1], exchange_ends)), at(mesh_.reorder(line[0], exchange_ends))});
  }
  return found;
}

void Remesher::restore_sizes() {
  if (!sizes_.are_known()) return;
  for (int round = 0; round < most_rounds && sizes_.largest_change() > sizes_kept; ++round)
    for (const auto& [vertex, by] : sizes_.steps(bounds_of_parts())) {
      const double most = longest_step * options_.length;
      const Vec3 step = by.norm() > most ? by * (most / by.norm()) : by;
      if (step.squared_norm() > 0) result_.moves += move(vertex, {at(vertex) + step, {}});
    }
}

}  // namespace multimesh::remeshing
