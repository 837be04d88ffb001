// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/star_stamps.hpp"
#include "multimesh/work_queue.hpp"

namespace multimesh {

/// The result of trying an edge that was due.
struct Attempt {
  Outcome outcome;
  bool postponed = false;  ///< nothing was done: the edge costs more than the queue assumed
  double cost = 0;         ///< its actual cost then

  Attempt(Outcome o) : outcome(std::move(o)) {}  // NOLINT: a policy that never postpones returns outcomes
  static Attempt postpone(double cost) {
    Attempt a{Outcome{}};
    a.postponed = true;
    a.cost = cost;
    return a;
  }
};

/// An algorithm that applies one operation to the edges of a mesh, cheapest first.
///
/// A policy has
///   std::optional<double> cost(Dart edge);     // nothing: leave this edge alone
///   Attempt apply(Dart edge, double cost);     // or Outcome
///   bool finished(double next_cost);           // the stop criterion, asked before each operation
class PriorityScheduler {
 public:
  enum class Stop {
    finished,   ///< the policy's stop criterion
    exhausted,  ///< no edge is left whose operation is allowed
  };

  explicit PriorityScheduler(const Propagation& operations, NodeId node = NodeId::root)
      : PriorityScheduler(operations, node, own_stars_) {}
  /// `stars`: those in which the caller notes its own changes, too; they must outlive the scheduler.
  PriorityScheduler(const Propagation& operations, NodeId node, StarStamps& stars)
      : tree_(operations.tree()), node_(node), mesh_(tree_.mesh(node)), stars_(stars) {}

  PriorityScheduler(const PriorityScheduler&) = delete;
  PriorityScheduler& operator=(const PriorityScheduler&) = delete;

  /// Runs on all edges until the policy is finished, or each edge left was refused in the present state of
  /// the stars of its ends. After each operation, all edges of the facets that changed (Outcome::changed) get
  /// a new cost; after a collapse in a surface only those at the merged vertex. Refused edges are tried again
  /// when that happens to them, and in the next pass if a star of their ends has changed. Edges farther away
  /// may also depend on what was changed; the policy must detect this when they are due, and postpone them.
  /// Cost: O(log n) per operation and update.
  template <class Policy>
  Stop run(Policy& policy) {
    refused_.clear();
    refused_at_.clear();
    return timed(policy, [&] { queue_where(policy, [](Dart) { return true; }); });
  }
  /// Runs on the edges that are still due after the last run, and on those at stars that have changed since.
  template <class Policy>
  Stop resume(Policy& policy) {
    return timed(policy, [&] { queue_where(policy, [&](Dart e) { return stamp(e) > seen_; }); });
  }

  /// Of the last run, wall-clock time.
  double seconds() const noexcept { return seconds_; }

  /// Whether the edge was refused when it was asked last.
  bool was_refused(Index edge) const { return edge < refused_at_.size() && refused_at_[edge] != 0; }
  /// Edges that were refused: the reason why a run is exhausted.
  const std::vector<Index>& refused_edges() const noexcept { return refused_; }

 private:
  template <class Policy, class Queue>
  Stop timed(Policy& policy, const Queue& queue) {
    const auto start = std::chrono::steady_clock::now();
    queue();
    const Stop stop = run_passes(policy);
    seen_ = stars_.now();
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return stop;
  }

  template <class Policy, class Which>
  void queue_where(Policy& policy, const Which& which) {
    queue_.reserve(mesh_.capacity(1));
    for (Index e = 0; e < mesh_.capacity(1); ++e)
      if (mesh_.is_live(1, e))
        if (const Dart d = mesh_.dart_of(1, e); which(d)) update(d, policy);
  }

  template <class Policy>
  Stop run_passes(Policy& policy) {
    for (;;) {
      if (pass(policy) == Stop::finished) return Stop::finished;
      if (!ask_again(policy)) return Stop::exhausted;
    }
  }

  template <class Policy>
  Stop pass(Policy& policy) {
    WorkQueue::Entry next;
    while (queue_.pop(next)) {
      const Index edge = next.simplex;
      if (!mesh_.is_live(1, edge)) continue;
      if (policy.finished(next.cost)) {
        queue_.push(edge, next.cost);
        return Stop::finished;
      }
      const Dart d = mesh_.dart_of(1, edge);
      const Attempt attempt = policy.apply(d, next.cost);
      if (attempt.postponed) {
        queue_.push(edge, attempt.cost);
      } else if (attempt.outcome) {
        if (was_refused(edge)) refused_at_[edge] = 0;
        update_around(attempt.outcome, policy);
      } else {
        note_refused(edge, stamp(d));
      }
    }
    return Stop::exhausted;
  }

  /// Of the ends of an edge.
  StarStamps::Stamp stamp(Dart e) const {
    const Index ends[] = {mesh_.vertex(e), mesh_.vertex(mesh_.reorder(e, exchange_ends))};
    return stars_.latest(ends);
  }

  void note_refused(Index edge, StarStamps::Stamp at) {
    if (edge >= refused_at_.size()) refused_at_.resize(std::max<std::size_t>(mesh_.capacity(1), edge + 1), 0);
    if (refused_at_[edge] == 0) refused_.push_back(edge);
    refused_at_[edge] = std::uint64_t{at} + 1;
  }

  template <class Policy>
  void update(Dart e, Policy& policy) {
    const Index edge = mesh_.simplex(e, 1);
    if (const auto cost = policy.cost(e)) {
      queue_.push(edge, *cost);
    } else {
      queue_.erase(edge);
    }
  }

  // What changed is given by a simplex of the root; the mesh may have several over it.
  template <class Policy>
  void update_around(const Outcome& outcome, Policy& policy) {
    // A policy may have constructed an outcome itself.
    const Dart changed = outcome.changed != no_dart ? outcome.changed : outcome.root;
    if (changed == no_dart) return;
    if (node_ == NodeId::root) return update_around(changed, outcome, policy);
    copies_.collect(tree_, changed, outcome.changed_dimension);
    for (const Copy& c : copies_.of(node_)) update_around(c.dart, outcome, policy);
  }

  // After a collapse in a surface: the edges at its vertex; otherwise all edges of the facets that changed.
  // In dimension 3 edges also have other indices then.
  template <class Policy>
  void update_around(Dart changed, const Outcome& outcome, Policy& policy) {
    const int d = mesh_.dimension();
    mesh_.star(changed, outcome.changed_dimension, star_);
    // Before the first refusal, nobody compares stamps.
    if (!refused_.empty() || &stars_ != &own_stars_) stamp_star();
    if (outcome.operation != Operation::collapse || d > 2) return update_all(policy);
    const bool boundary = d == 2 && mesh_.is_boundary(changed, 0);
    for (const Dart t : star_) {
      update(t, policy);
      if (!boundary) continue;  // each edge is the first one of some facet
      const Dart other = mesh_.reorder(t, edge_ax);
      if (mesh_.is_boundary(other, 1)) update(other, policy);
    }
  }

  template <class Policy>
  void update_all(Policy& policy) {
    edges_.clear();
    for (const Dart t : star_)
      for (const Permutation p : faces_around(mesh_.dimension(), 1, -1)) {
        const Dart e = mesh_.reorder(t, p);
        edges_.emplace_back(mesh_.simplex(e, 1), e);
      }
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (i == 0 || edges_[i].first != edges_[i - 1].first) update(edges_[i].second, policy);
  }

  void stamp_star() {
    corners_.clear();
    Index v[4];
    for (const Dart t : star_) {
      mesh_.vertices(t, v);
      for (int i = 0; i <= mesh_.dimension(); ++i)
        if (corners_.empty() || (v[i] != corners_.front() && v[i] != corners_.back()))
          corners_.push_back(v[i]);
    }
    stars_.change(corners_);
  }

  /// Queues the refused edges at stars that have changed since. \return false if there are none
  template <class Policy>
  bool ask_again(Policy& policy) {
    bool any = false;
    std::erase_if(refused_, [&](Index e) {
      const bool is_live = mesh_.is_live(1, e);
      const Dart d = is_live ? mesh_.dart_of(1, e) : no_dart;
      if (is_live && std::uint64_t{stamp(d)} + 1 == refused_at_[e]) return false;
      refused_at_[e] = 0;
      if (is_live) update(d, policy), any = true;
      return true;
    });
    return any;
  }

  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  StarStamps own_stars_;
  StarStamps& stars_;
  StarStamps::Stamp seen_ = 0;
  Copies copies_;
  WorkQueue queue_;
  std::vector<Index> refused_;
  std::vector<std::uint64_t> refused_at_;  // per edge: one more than its stamp then; 0: it was not
  std::vector<Index> corners_;
  DartBuffer star_;
  std::vector<std::pair<Index, Dart>> edges_;
  double seconds_ = 0;
};

}  // namespace multimesh
