// SPDX-License-Identifier: BSD-3-Clause
// Trials: some splits, and what can be made of them, or nothing.
#include <algorithm>

#include "multimesh/algorithms/improvement/improver.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::improvement {

namespace {

// How many operations may follow a split, and what it must gain.
constexpr int longest_trial = 48;
constexpr double trial_gain = 0.9;

}  // namespace

// Runs `start`, which splits some edges, and improves what came of it. All is undone unless all of that is
// better than `before` in the end, or good enough.
template <class Start>
bool Improver::attempt(double before, const Start& start) {
  Transaction trial = work_.operations().transaction();
  Refusals::Trial stamps(refusals_);
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
  stamps.keep();
  for (const Index s : touched_)
    if (work_.is_live(s)) push(s);
  return true;
}

// Takes splits whatever comes of them at first.
Demand Improver::daring() const {
  Demand demand = demand_;
  demand.enough = flat;
  demand.remember = false;
  return demand;
}

bool Improver::try_splits(Index t) {
  const double before = work_.quality_of(t);
  for (const auto& [i, j] : edge_corners) {
    Candidate split;
    candidates_.split(work_.edge(t, i, j), daring(), split);
    if (split && attempt(before, [&] { return take(split); })) return true;
  }
  return false;
}

// Bisects longest edges (Rivara 1984), each time near the worst tetrahedron: where the domain is thin, or the
// mesh coarse beside something small, one split alone does not help.
bool Improver::try_refinement(Index t, int splits) {
  const double before = work_.quality_of(t);
  return attempt(before, [&] {
    touched_.push_back(t);
    Index worst = t;
    for (int i = 0; i < splits; ++i) {
      Candidate split;
      candidates_.split(longest_edge_near(worst), daring(), split);
      if (!take(split)) return i > 0;
      double quality = 0;
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
      if (length > longest) longest = length, e = work_.edge(s, i, j), longer = true;
    }
    return longer;
  };
  look_at(t);
  for (bool longer = true; longer;) {
    longer = false;
    work_.read_copies(e, 1, copies_);
    for (const Dart copy : copies_) {
      work_.read_ring(copy, ring_);
      for (const Dart d : ring_.darts) longer = look_at(work_.tet(d)) || longer;
    }
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
    double quality = 0;
    const Index worst = worst_touched(quality);
    if (quality < limit) return true;
    if (!improve_tet(worst)) return false;
  }
  return false;
}

}  // namespace multimesh::improvement
