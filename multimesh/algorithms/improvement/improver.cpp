// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/improver.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/faces.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::improvement {

Improver::Improver(const Embedding& embedding, NodeId node, const ImproveOptions& options)
    : options_(options),
      limit_(options.target_amips * options.target_amips * options.target_amips),
      work_(embedding, node, options),
      forced_(work_, options.surface_splits),
      expected_(work_.mesh().capacity(0)),
      refusals_(work_.count_tets()),
      candidates_(work_, counts_, refusals_) {
  for (Index v = 0; v < expected_.size(); ++v) {
    expected_[v] = forced_.bound_at(v);
    corners_.push_back(v);
  }
  refusals_.change(corners_, true);
  demand_.remember = true;
  demand_.enough = limit_;
  demand_.shortest = options.min_edge_length;
  demand_.held_splits = static_cast<HeldSplits>(options.surface_splits);
}

// --- doing ---------------------------------------------------------------------------------------------

Dart Improver::apply(const Candidate& c) {
  switch (c.kind) {
    case Kind::split: {
      const Index a = work_.mesh().vertex(c.dart);
      const Index b = work_.mesh().vertex(work_.mesh().reorder(c.dart, exchange_ends));
      const Dart halves = work_.split(c.dart, c.place, c.strata);
      if (halves == no_dart) return no_dart;
      const Dart at = work_.mesh().reorder(halves, exchange_ends);
      grade(work_.mesh().vertex(at), a, b);
      split_at_ = at;
      return at;
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

// What a mesh in an envelope refused, it will refuse again.
void Improver::note_refused(const Candidate& c, Index a, Index b) {
  if (c.kind == Kind::smoothing) b = a;
  if (c.kind != Kind::collapse && b < a) std::swap(a, b);
  refusals_.note(c.kind, a, b);
}

// The best candidate, or if the tree refuses that, the next best.
template <class Find>
bool Improver::take_best(const Demand& demand, const Find& find) {
  constexpr int most_tries = 4;
  for (int i = 0; i < most_tries; ++i) {
    Candidate best;
    find(best);
    if (take(best)) return true;
    if (!best || !best.surface || !demand.remember) return false;
  }
  return false;
}

bool Improver::take(const Candidate& c) {
  if (!c) return false;
  Count& count = counts_[static_cast<std::size_t>(c.kind)];
  Index face[4];
  work_.mesh().vertices(c.dart, face);
  const Dart at = apply(c);
  if (at == no_dart) {
    ++count.refused[static_cast<std::size_t>(Why::legality)];
    if (c.surface) note_refused(c, face[0], face[1]);
    return false;
  }
  ++count.done;
  ++done_;
  if (trying_ && c.kind == Kind::split) work_.add_copies(work_.mesh().vertex(at), fresh_);
  changed(at, c.surface);
  // It splits an edge of the face on its way: what is around that has new numbers, though nothing else.
  if (c.kind == Kind::face_swap)
    for (const Index v : {face[0], face[1]}) changed(work_.mesh().dart_of(0, v), false);
  return true;
}

// All tetrahedra around the vertex are to be looked at again.
void Improver::changed(Dart v, bool surface) {
  work_.read_star(v, star_);
  corners_.clear();
  for (const Index t : star_) {
    work_.add_copies(work_.corners(t), corners_);
  }
  refusals_.change(corners_, surface);
  if (trying_)
    touched_.insert(touched_.end(), star_.begin(), star_.end());
  else
    for (const Index t : star_) push(t);
}

void Improver::push(Index t) {
  if (const double q = work_.quality_of(t); q > limit_) queue_.push(t, -q);
}

// Near what is forced, a mesh of reasonable size cannot be good at once: what must be expected falls off with
// each bisection.
void Improver::grade(Index v, Index a, Index b) {
  corners_.clear();
  work_.add_copies(v, corners_);
  for (const Index copy : corners_) {
    if (copy >= expected_.size()) expected_.resize(copy + copy / 2 + 1, 3);
    expected_[copy] = std::sqrt(expected_[a] * expected_[b]);
  }
}

// The cubed energy from which on a tetrahedron is worth new vertices.
double Improver::demanded(Index t) const {
  double expected = 0;
  for (const Index v : work_.corners(t)) expected = std::max(expected, near_bound * expected_[v]);
  return std::max(limit_, expected * expected * expected);
}

bool Improver::may_grow() {
  constexpr int questions_per_count = 256;
  if (questions_++ % questions_per_count == 0) size_ = work_.count_tets();
  const bool full = size_ >= largest_size_;
  was_full_ = was_full_ || full;
  return !full;
}

bool Improver::is_out_of_time() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return passed.count() > options_.time_limit;
}

void Improver::tick() {
  if (!tick_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - ticked_ < std::chrono::seconds(1)) return;
  ticked_ = now;
  tick_();
}

// --- one tetrahedron -----------------------------------------------------------------------------------

bool Improver::swap_or_collapse(Index t, const Demand& demand) {
  const Corners c = work_.corners(t);
  return take_best(demand, [&](Candidate& best) {
    for (const auto& [i, j] : edge_corners)
      if (!candidates_.is_edge_known(Kind::edge_swap, c[i], c[j], demand))
        candidates_.edge_swap(work_.edge(t, i, j), demand, best);
    candidates_.face_swaps(t, demand, best);
    for (int i = 0; i < 4; ++i) {
      if (is_kept(c[i]) || std::find(fresh_.begin(), fresh_.end(), c[i]) != fresh_.end()) continue;
      for (int j = 0; j < 4; ++j)
        if (i != j && !candidates_.is_known(Kind::collapse, c[i], c[j], demand))
          candidates_.collapse(work_.edge(t, i, j), demand, best);
    }
  });
}

bool Improver::smooth(Index t, const Demand& demand) {
  const Corners c = work_.corners(t);
  return take_best(demand, [&](Candidate& best) {
    for (int i = 0; i < 4; ++i)
      if (!candidates_.is_known(Kind::smoothing, c[i], c[i], demand))
        candidates_.smoothing(work_.edge(t, i, i == 0 ? 1 : 0), demand, best);
  });
}

bool Improver::split(Index t, const Demand& demand) {
  const Corners c = work_.corners(t);
  return take_best(demand, [&](Candidate& best) {
    for (const auto& [i, j] : edge_corners)
      if (!candidates_.is_edge_known(Kind::split, c[i], c[j], demand))
        candidates_.split(work_.edge(t, i, j), demand, best);
  });
}

bool Improver::improve_tet(Index t) {
  return swap_or_collapse(t, demand_) || smooth(t, demand_) || split(t, demand_);
}

std::size_t Improver::count_worse(double quality) const {
  std::size_t n = 0;
  for (Index t = 0; t < work_.mesh().capacity(3); ++t) n += work_.is_live(t) && work_.quality_of(t) > quality;
  return n;
}

void Improver::push_bad() {
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t)) push(t);
}

Refusals::Stamp Improver::stamp(Index t) const {
  return refusals_.stars().latest(work_.corners(t));
}

bool Improver::was_asked(Index t, int effort) const {
  return t < asked_.size() && asked_[t].effort >= effort && asked_[t].stamp == stamp(t);
}

void Improver::improve_bad(Index t, int trial_splits) {
  if (was_asked(t, trial_splits)) return;
  if (swap_or_collapse(t, demand_) || smooth(t, demand_)) return;
  if (work_.quality_of(t) > demanded(t) && may_grow()) {
    if (split(t, demand_)) return;
    if (trial_splits > 0 && try_splits(t)) return;
    if (trial_splits > 1 && try_refinement(t, trial_splits)) return;
  }
  if (t >= asked_.size()) asked_.resize(t + t / 2 + 1);
  asked_[t] = {stamp(t), trial_splits};
}

std::size_t Improver::pass(int trial_splits) {
  const std::size_t done = done_;
  push_bad();
  WorkQueue::Entry next;
  while (queue_.pop(next) && !is_out_of_time()) {
    const Index t = next.simplex;
    if (!work_.is_live(t) || work_.strata().facet_stays(t) || !(work_.quality_of(t) > limit_)) continue;
    tick();
    improve_bad(t, trial_splits);
  }
  return done_ - done;
}

void Improver::aim_at(double amips) {
  limit_ = amips * amips * amips;
  demand_.enough = limit_;
  demand_.gain = Demand{}.gain;
  demand_.sharp = false;
  refusals_.forget();
  asked_.clear();
}

bool Improver::take_smaller_steps() {
  if (demand_.sharp) return false;
  demand_.sharp = true;
  demand_.gain = 0.999;
  refusals_.forget();
  asked_.clear();
  return true;
}

// --- refinement ----------------------------------------------------------------------------------------

bool Badness::is_worse_than(const Badness& other) const {
  constexpr double clearly = 0.97;
  if (other.worst < clearly * worst) return true;
  return other.worst <= worst && other.volume < clearly * volume;
}

Badness Improver::badness() const {
  Badness b;
  for (Index t = 0; t < work_.mesh().capacity(3); ++t) {
    if (!work_.is_live(t) || work_.strata().facet_stays(t)) continue;
    const double excess = work_.quality_of(t) / demanded(t);
    if (!(excess > 1)) continue;
    const Corners c = work_.corners(t);
    b.worst = std::max(b.worst, excess);
    b.volume += six_volume(work_.point(c[0]), work_.point(c[1]), work_.point(c[2]), work_.point(c[3]));
  }
  return b;
}

void Improver::keep(Index v) {
  corners_.clear();
  work_.add_copies(v, corners_);
  for (const Index copy : corners_) {
    if (copy >= kept_.size()) kept_.resize(copy + copy / 2 + 1, false);
    kept_[copy] = true;
  }
}

Dart Improver::longest_edge(Index t) const {
  const Corners c = work_.corners(t);
  double longest = 0;
  Dart e = no_dart;
  for (const auto& [i, j] : edge_corners)
    if (const double length = (work_.point(c[i]) - work_.point(c[j])).norm(); length > longest)
      longest = length, e = work_.edge(t, i, j);
  return e;
}

std::size_t Improver::refine() {
  Demand demand = daring();
  demand.in_middle = true;
  std::vector<Index> bad;
  for (Index t = 0; t < work_.mesh().capacity(3); ++t)
    if (work_.is_live(t) && !work_.strata().facet_stays(t) && work_.quality_of(t) > demanded(t))
      bad.push_back(t);
  std::size_t done = 0;
  for (const Index t : bad) {
    if (!work_.is_live(t) || !may_grow()) continue;
    Candidate split;
    candidates_.split(longest_edge_near(t), demand, split);
    if (!take(split)) continue;
    keep(work_.mesh().vertex(split_at_));
    ++done;
  }
  return done;
}

bool Improver::refine_and_improve() {
  constexpr int deepest = 3;
  Transaction round = work_.operations().transaction();
  Refusals::Trial stamps(refusals_);
  const Counts counts = counts_;
  const std::size_t done = done_;
  const Badness before = badness();
  for (int i = 0; i < deepest && !is_out_of_time() && refine() > 0; ++i) {
    for (const int trial_splits : {0, 1, 2}) pass(trial_splits);
    if (!before.is_worse_than(badness())) continue;
    round.commit();
    stamps.keep();
    kept_.clear();
    asked_.clear();  // of what was kept, collapses were not asked
    return true;
  }
  kept_.clear();
  done_ = done;
  for (std::size_t i = 0; i < n_kinds; ++i) counts_[i].done = counts[i].done;
  return false;
}

}  // namespace multimesh::improvement
