// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/improver.hpp"

#include <algorithm>

namespace multimesh::improvement {

namespace {

constexpr int edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
// Of a trial: how many operations may follow a split, and what it must gain.
constexpr int longest_trial = 24;
constexpr double trial_gain = 0.9;

}  // namespace

Improver::Improver(TetDomain& domain, const ImproveOptions& options)
    : options_(options),
      limit_(options.target_amips * options.target_amips * options.target_amips),
      work_(domain, options.locked_regions),
      candidates_(work_, counts_) {
  demand_.shortest = options.min_edge_length;
  demand_.held_splits = static_cast<HeldSplits>(options.surface_splits);
}

// --- doing ---------------------------------------------------------------------------------------------

Dart Improver::apply(const Candidate& c) {
  switch (c.kind) {
    case Kind::split: {
      const Dart halves = work_.split(c.dart, c.place, c.strata);
      return halves == no_dart ? no_dart : work_.mesh().reorder(halves, exchange_ends);
    }
    case Kind::collapse:
      return work_.collapse(c.dart);
    case Kind::edge_swap:
      return c.in_boundary ? work_.swap_in_boundary(c.dart) : work_.swap(c.dart);
    case Kind::face_swap:
      return work_.swap_face(c.dart);
    case Kind::smoothing:
      return work_.move(c.dart, c.place) ? c.dart : no_dart;
  }
  return no_dart;
}

bool Improver::take(const Candidate& c) {
  if (!c) return false;
  Count& count = counts_[static_cast<std::size_t>(c.kind)];
  const Dart at = apply(c);
  if (at == no_dart) {
    ++count.refused[static_cast<std::size_t>(Why::legality)];
    return false;
  }
  ++count.done;
  ++done_;
  changed(at);
  return true;
}

// All tetrahedra around the vertex are to be looked at again.
void Improver::changed(Dart v) {
  work_.read_star(v, star_);
  if (trying_) {
    touched_.insert(touched_.end(), star_.begin(), star_.end());
    return;
  }
  for (const Index t : star_)
    if (const double q = work_.quality_of(t); q > limit_) queue_.push(t, -q);
}

// --- one tetrahedron -----------------------------------------------------------------------------------

bool Improver::swap_or_collapse(Index t, const Demand& demand) {
  Candidate best;
  for (const auto& [i, j] : edges) candidates_.edge_swap(Workspace::edge(t, i, j), demand, best);
  for (const Permutation p : {Permutation{}, permutation(0, 1, 3, 2), permutation(0, 2, 3, 1), permutation(1, 2, 3, 0)})
    candidates_.face_swap(tet::TetMesh::dart(t, p), demand, best);
  for (const auto& [i, j] : edges) {
    candidates_.collapse(Workspace::edge(t, i, j), demand, best);
    candidates_.collapse(Workspace::edge(t, j, i), demand, best);
  }
  return take(best);
}

bool Improver::smooth(Index t, const Demand& demand) {
  Candidate best;
  for (int i = 0; i < 4; ++i) candidates_.smoothing(Workspace::edge(t, i, i == 0 ? 1 : 0), demand, best);
  return take(best);
}

bool Improver::split(Index t, const Demand& demand) {
  Candidate best;
  for (const auto& [i, j] : edges) candidates_.split(Workspace::edge(t, i, j), demand, best);
  return take(best);
}

bool Improver::improve_tet(Index t) {
  return swap_or_collapse(t, demand_) || smooth(t, demand_) || split(t, demand_);
}

// Splits that make the worst tetrahedron worse at first.
bool Improver::dare(Index t) {
  const double before = work_.quality_of(t);
  Demand daring = demand_;
  daring.enough = flat;
  for (const auto& [i, j] : edges) {
    Candidate start;
    candidates_.split(Workspace::edge(t, i, j), daring, start);
    if (!start) continue;
    Transaction trial = work_.operations().transaction();
    trying_ = true;
    touched_.clear();
    const Counts counts = counts_;
    const std::size_t done = done_;
    const bool better = take(start) && improve_touched(trial_gain * before);
    trying_ = false;
    if (!better) {  // undone
      done_ = done;
      for (std::size_t i = 0; i < n_kinds; ++i) counts_[i].done = counts[i].done;
      continue;
    }
    trial.commit();
    for (const Index s : touched_)
      if (work_.is_live(s))
        if (const double q = work_.quality_of(s); q > limit_) queue_.push(s, -q);
    return true;
  }
  return false;
}

// Improves the worst of the touched tetrahedra until all are better than this.
bool Improver::improve_touched(double limit) {
  for (int i = 0; i < longest_trial; ++i) {
    Index worst = no_index;
    double quality = 0;
    for (const Index t : touched_)
      if (work_.is_live(t))
        if (const double q = work_.quality_of(t); q > quality) quality = q, worst = t;
    if (quality < limit) return true;
    if (!swap_or_collapse(worst, demand_) && !smooth(worst, demand_)) return false;
  }
  return false;
}

std::size_t Improver::pass(bool daring) {
  const std::size_t done = done_;
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t))
      if (const double q = work_.quality_of(t); q > limit_) queue_.push(t, -q);
  EdgeQueue::Entry next;
  while (queue_.pop(next)) {
    const Index t = next.edge;
    if (!work_.is_live(t) || work_.held().is_locked_tet(t) || !(work_.quality_of(t) > limit_)) continue;
    if (!improve_tet(t) && daring) dare(t);
  }
  return done_ - done;
}

// --- sizes ---------------------------------------------------------------------------------------------

// Tetrahedra in the order of their greatest length, as long as that is above 1; `length` gives it, and the edge.
template <class Length, class Apply>
std::size_t Improver::sweep_edges(const Length& length, const Apply& apply) {
  const std::size_t done = done_;
  EdgeQueue queue;
  Dart e;
  const auto push = [&](Index t) {
    if (const double l = length(t, e); l > 1) queue.push(t, -l);
  };
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t)) push(t);
  EdgeQueue::Entry next;
  trying_ = true;  // what changes goes to touched_, not to the queue of bad ones
  while (queue.pop(next)) {
    if (!work_.is_live(next.edge) || work_.held().is_locked_tet(next.edge) || !(length(next.edge, e) > 1)) continue;
    touched_.clear();
    if (!apply(e)) continue;
    for (const Index t : touched_) push(t);
  }
  trying_ = false;
  return done_ - done;
}

std::size_t Improver::resize() {
  Demand demand = demand_;
  demand.gain = 1;
  demand.enough = limit_;
  const auto extreme = [&](Index t, Dart& e, const auto& measure) {
    const Corners c = work_.corners(t);
    double greatest = 0;
    for (const auto& [i, j] : edges) {
      const double m = measure((work_.point(c[static_cast<std::size_t>(i)]) -
                                work_.point(c[static_cast<std::size_t>(j)])).norm());
      if (m > greatest) greatest = m, e = Workspace::edge(t, i, j);
    }
    return greatest;
  };
  const double longest = options_.edge_length * 4 / 3, shortest = options_.edge_length * 4 / 5;
  std::size_t n = sweep_edges(
      [&](Index t, Dart& e) { return extreme(t, e, [&](double l) { return l / longest; }); },
      [&](Dart e) {
        Candidate split;
        candidates_.split(e, demand, split);
        return take(split);
      });
  demand.longest = longest;
  n += sweep_edges(
      [&](Index t, Dart& e) { return extreme(t, e, [&](double l) { return shortest / l; }); },
      [&](Dart e) {
        Candidate collapse;
        candidates_.collapse(e, demand, collapse);
        candidates_.collapse(work_.mesh().reorder(e, exchange_ends), demand, collapse);
        return take(collapse);
      });
  return n;
}

}  // namespace multimesh::improvement
