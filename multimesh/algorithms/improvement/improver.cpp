// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/improver.hpp"

#include <algorithm>
#include <optional>

#include "multimesh/faces.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::improvement {

namespace {

// Of a trial: how many operations may follow a split, and what it must gain.
constexpr int longest_trial = 48;
constexpr double trial_gain = 0.9;
// Within this factor of what the surface forces, a tetrahedron is as good as it gets.
constexpr double near_bound = 1.1;

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
  if (trying_ && c.kind == Kind::split) fresh_.push_back(work_.mesh().vertex(at));
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
  for (const auto& [i, j] : edge_corners) candidates_.edge_swap(Workspace::edge(t, i, j), demand, best);
  for (const Permutation p : faces_around(3, 2, -1))
    candidates_.face_swap(tet::TetMesh::dart(t, p), demand, best);
  const Corners c = work_.corners(t);
  for (int i = 0; i < 4; ++i) {
    if (std::find(fresh_.begin(), fresh_.end(), c[i]) != fresh_.end()) continue;
    for (int j = 0; j < 4; ++j)
      if (i != j) candidates_.collapse(Workspace::edge(t, i, j), demand, best);
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
  for (const auto& [i, j] : edge_corners) candidates_.split(Workspace::edge(t, i, j), demand, best);
  return take(best);
}

bool Improver::improve_tet(Index t) {
  return swap_or_collapse(t, demand_) || smooth(t, demand_) || split(t, demand_);
}

// --- trials --------------------------------------------------------------------------------------------

// Runs `start`, which splits some edges, and improves what came of it. All is undone unless all of that is
// better than `before` in the end, or good enough.
template <class Start>
bool Improver::attempt(double before, const Start& start) {
  Transaction trial = work_.operations().transaction();
  const Counts counts = counts_;
  const std::size_t done = done_;
  trying_ = true;
  touched_.clear();
  fresh_.clear();
  const bool better = start() && improve_touched(std::max(trial_gain * before, limit_));
  trying_ = false;
  fresh_.clear();
  if (!better) {
    done_ = done;
    for (std::size_t i = 0; i < n_kinds; ++i) counts_[i].done = counts[i].done;
    return false;
  }
  trial.commit();
  for (const Index s : touched_)
    if (work_.is_live(s))
      if (const double q = work_.quality_of(s); q > limit_) queue_.push(s, -q);
  return true;
}

bool Improver::is_forced(Index t, const Obstacles& obstacles) const {
  double bound = 0;
  for (const Index v : work_.corners(t)) bound = std::max(bound, near_bound * obstacles.bound_at(v));
  return work_.quality_of(t) <= bound * bound * bound;
}

bool Improver::try_splits(Index t) {
  const double before = work_.quality_of(t);
  Demand daring = demand_;
  daring.enough = flat;
  for (const auto& [i, j] : edge_corners) {
    Candidate split;
    candidates_.split(Workspace::edge(t, i, j), daring, split);
    if (split && attempt(before, [&] { return take(split); })) return true;
  }
  return false;
}

// Bisects longest edges (Rivara 1984), each time near the worst tetrahedron: where the domain is thin, or the
// mesh coarse beside something small, one split alone does not help.
bool Improver::try_refinement(Index t, int splits) {
  Demand daring = demand_;
  daring.enough = flat;
  const double before = work_.quality_of(t);
  return attempt(before, [&] {
    touched_.push_back(t);
    Index worst = t;
    for (int i = 0; i < splits; ++i) {
      Candidate split;
      candidates_.split(longest_edge_near(worst), daring, split);
      if (!take(split)) return i > 0;
      double quality;
      worst = worst_touched(quality);
      if (!(quality > limit_)) break;
    }
    return true;
  });
}

// The longest edge of t, or, if another one of the tetrahedra around it is longer, that, and so on.
Dart Improver::longest_edge_near(Index t) const {
  double longest = 0;
  Dart e = no_dart;
  const auto look_at = [&](Index s) {
    const Corners c = work_.corners(s);
    bool longer = false;
    for (const auto& [i, j] : edge_corners) {
      const double length = (work_.point(c[i]) - work_.point(c[j])).norm();
      if (length > longest) longest = length, e = Workspace::edge(s, i, j), longer = true;
    }
    return longer;
  };
  look_at(t);
  for (bool longer = true; longer;) {
    longer = false;
    work_.read_ring(e, ring_);
    for (const Dart d : ring_.darts) longer = look_at(tet::TetMesh::tet(d)) || longer;
  }
  return e;
}

Index Improver::worst_touched(double& quality) const {
  Index worst = no_index;
  quality = 0;
  for (const Index t : touched_)
    if (work_.is_live(t))
      if (const double q = work_.quality_of(t); q > quality) quality = q, worst = t;
  return worst;
}

// Improves the worst of the touched tetrahedra until all are better than this.
bool Improver::improve_touched(double limit) {
  for (int i = 0; i < longest_trial; ++i) {
    double quality;
    const Index worst = worst_touched(quality);
    if (quality < limit) return true;
    if (!improve_tet(worst)) return false;
  }
  return false;
}

std::size_t Improver::pass(int trial_splits) {
  const std::size_t done = done_;
  std::optional<Obstacles> obstacles;
  if (trial_splits > 0) obstacles.emplace(work_, options_.surface_splits);
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t))
      if (const double q = work_.quality_of(t); q > limit_) queue_.push(t, -q);
  EdgeQueue::Entry next;
  while (queue_.pop(next)) {
    const Index t = next.edge;
    if (!work_.is_live(t) || work_.held().is_locked_tet(t) || !(work_.quality_of(t) > limit_)) continue;
    if (improve_tet(t) || trial_splits == 0 || is_forced(t, *obstacles)) continue;
    if (!try_splits(t) && trial_splits > 1) try_refinement(t, trial_splits);
  }
  return done_ - done;
}

// --- sizes ---------------------------------------------------------------------------------------------

// Tetrahedra in the order of their greatest length, as long as that is above 1; `length` gives it, and the
// edge.
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
    if (!work_.is_live(next.edge) || work_.held().is_locked_tet(next.edge) || !(length(next.edge, e) > 1))
      continue;
    touched_.clear();
    if (!apply(e)) continue;
    for (const Index t : touched_) push(t);
  }
  trying_ = false;
  fresh_.clear();
  return done_ - done;
}

std::size_t Improver::resize() {
  Demand demand = demand_;
  demand.gain = 1;
  demand.enough = limit_;
  const auto extreme = [&](Index t, Dart& e, const auto& measure) {
    const Corners c = work_.corners(t);
    double greatest = 0;
    for (const auto& [i, j] : edge_corners) {
      const double m = measure((work_.point(c[i]) - work_.point(c[j])).norm());
      if (m > greatest) greatest = m, e = Workspace::edge(t, i, j);
    }
    return greatest;
  };
  const double longest = options_.edge_length * 4 / 3, shortest = options_.edge_length * 4 / 5;
  std::size_t n =
      sweep_edges([&](Index t, Dart& e) { return extreme(t, e, [&](double l) { return l / longest; }); },
                  [&](Dart e) {
                    Candidate split;
                    candidates_.split(e, demand, split);
                    return take(split);
                  });
  demand.longest = longest;
  n += sweep_edges([&](Index t, Dart& e) { return extreme(t, e, [&](double l) { return shortest / l; }); },
                   [&](Dart e) {
                     Candidate collapse;
                     candidates_.collapse(e, demand, collapse);
                     candidates_.collapse(work_.mesh().reorder(e, exchange_ends), demand, collapse);
                     return take(collapse);
                   });
  return n;
}

}  // namespace multimesh::improvement
