// SPDX-License-Identifier: BSD-3-Clause
// Edges are brought to a length.
#include <algorithm>

#include "multimesh/algorithms/improvement/improver.hpp"
#include "multimesh/pair_numbers.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::improvement {

// Tetrahedra in the order of their edge that exceeds a bound most, from the worst one on; `excess` is above 1
// for such edges. `apply` gets the tetrahedron and that edge; where it fails, the tetrahedron is left alone.
template <class Excess, class Apply>
std::size_t Improver::sweep_edges(const Excess& excess, const Apply& apply) {
  const std::size_t done = done_;
  WorkQueue queue;
  Dart e = no_dart;
  const auto worst = [&](Index t) {
    const Corners c = work_.corners(t);
    double worst = 0;
    for (const auto& [i, j] : edge_corners)
      if (const double x = excess((work_.point(c[i]) - work_.point(c[j])).norm()); x > worst)
        worst = x, e = work_.edge(t, i, j);
    return worst;
  };
  const auto push = [&](Index t) {
    if (const double x = worst(t); x > 1) queue.push(t, -x);
  };
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t)) push(t);
  WorkQueue::Entry next;
  trying_ = true;  // what changes goes to touched_, not to the queue of bad ones
  while (queue.pop(next) && !is_out_of_time()) {
    tick();
    if (!work_.is_live(next.simplex) || work_.strata().facet_stays(next.simplex) ||
        !(worst(next.simplex) > 1))
      continue;
    touched_.clear();
    if (!apply(next.simplex, e)) continue;
    touched_.push_back(next.simplex);
    for (const Index t : touched_)
      if (work_.is_live(t)) push(t);
  }
  trying_ = false;
  fresh_.clear();
  return done_ - done;
}

// The longest edge around goes first (Rivara 1984): bisecting others beside one that must stay never ends.
std::size_t Improver::split_longer(double longest, const Demand& demand) {
  return sweep_edges([&](double length) { return length / longest; },
                     [&](Index t, Dart) {
                       Candidate split;
                       candidates_.split(longest_edge_near(t), demand, split);
                       return take(split);
                     });
}

std::size_t Improver::split_longer(double longest) {
  Demand demand = daring();
  demand.gain = 1;
  demand.in_middle = true;
  return split_longer(longest, demand);
}

std::size_t Improver::resize(bool first) {
  const double shortest = options_.edge_length * 4 / 5;
  double longest = options_.edge_length * 4 / 3;
  if (const double most = options_.max_edge_length; most > 0)
    longest = longest > 0 ? std::min(longest, most) : most;
  Demand demand = demand_;
  demand.gain = 1;
  demand.enough = limit_;
  demand.remember = false;
  std::size_t n = first ? split_longer(longest) : split_longer(longest, demand);
  demand.longest = demand_.longest = longest;
  if (shortest == 0) return n;
  n += sweep_edges([&](double length) { return shortest / length; },
                   [&](Index, Dart e) {
                     Candidate collapse;
                     candidates_.collapse(e, demand, collapse);
                     candidates_.collapse(work_.mesh().reorder(e, exchange_ends), demand, collapse);
                     return take(collapse);
                   });
  return n;
}

EdgeLengths Improver::measure_lengths() const {
  EdgeLengths m;
  PairNumbers edges(work_.mesh().capacity(0));
  std::size_t in_range = 0;
  double sum = 0;
  m.shortest = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < work_.mesh().capacity(3); ++t) {
    if (!work_.is_live(t)) continue;
    const Corners c = work_.corners(t);
    for (const auto& [i, j] : edge_corners) {
      if (const Index known = edges.size(); edges(work_.name(c[i]), work_.name(c[j])) != known) continue;
      const double length = (work_.point(c[i]) - work_.point(c[j])).norm();
      const double relative = options_.edge_length > 0 ? length / options_.edge_length : 1;
      m.shortest = std::min(m.shortest, length);
      m.longest = std::max(m.longest, length);
      sum += length;
      in_range += relative >= 4.0 / 5 && relative <= 4.0 / 3;
      m.too_long += relative > 4.0 / 3;
    }
  }
  if (edges.size() == 0) return {};
  m.mean = sum / edges.size();
  m.share_in_range = static_cast<double>(in_range) / edges.size();
  return m;
}

}  // namespace multimesh::improvement
