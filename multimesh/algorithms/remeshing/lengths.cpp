// SPDX-License-Identifier: BSD-3-Clause
// Lengths relative to the thresholds.
#include <algorithm>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh::remeshing {

void Remesher::count_edges() {
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e)) continue;
    const double l = length(mesh_.dart_of(1, e));
    result_.shortest = result_.edges == 0 ? l : std::min(result_.shortest, l);
    result_.longest = std::max(result_.longest, l);
    ++result_.edges;
    result_.edges_in_range += l >= shortest_share * options_.length && l <= longest_share * options_.length;
  }
}

// Along a curve, edges have on average the length that the thresholds require. An edge is measured together
// with the next ones on either side, with which smoothing will even it out: of edges that are all too short,
// but whose double is too long, every third vertex can be removed.
double Remesher::measure(Dart edge) {
  return line_[mesh_.simplex(edge, 1)] == 0
             ? length(edge)
             : measure_on_line(length(edge), edge, mesh_.reorder(edge, exchange_ends));
}

double Remesher::measure_on_line(double length, Dart from, Dart to) {
  return of_average * (2 * length + next_on_line(from).value_or(length) + next_on_line(to).value_or(length)) /
         4;
}

/// The length of the other edge at a of the curve that contains (a, b, ..), if a may move along that curve.
std::optional<double> Remesher::next_on_line(Dart edge) {
  std::array<Dart, 2> line{};
  if (freedom(edge, line) != Freedom::line) return std::nullopt;
  return length(mesh_.same_simplex(line[0], edge, 1) ? line[1] : line[0]);
}

/// Over the edges at a that b will have when (a, b, ..) is collapsed. Edges that are too long already do not
/// count.
double Remesher::longest_after_collapse(Dart edge) {
  const Dart other = mesh_.reorder(edge, exchange_ends);
  edges_around(mesh_, edge, edges_);
  double longest = 0;
  for (const Dart x : edges_) {
    if (mesh_.same_simplex(x, edge, 1) || measure(x) > longest_) continue;
    const Dart far = mesh_.reorder(x, exchange_ends);
    const double then = (at(far) - at(other)).norm();
    const bool on_line = line_[mesh_.simplex(x, 1)] != 0;
    longest = std::max(longest, on_line ? measure_on_line(then, far, other) : then);
  }
  return longest;
}

}  // namespace multimesh::remeshing
