// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "multimesh/edge_queue.hpp"
#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"

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
      : tree_(operations.tree()), node_(node), mesh_(tree_.mesh(node)) {}

  /// Runs until the policy is finished or a whole pass over the refused edges has changed nothing. After each
  /// operation, all edges of the facets that changed (Outcome::changed) get a new cost; after a collapse in a
  /// surface only those at the merged vertex. Refused edges are tried again when that happens to them, and in
  /// the next pass. Edges farther away may also depend on what was changed; the policy must detect this when
  /// they are due, and postpone them. Cost: O(log n) per operation and update.
  template <class Policy>
  Stop run(Policy& policy) {
    const auto start = std::chrono::steady_clock::now();
    const Stop stop = run_passes(policy);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return stop;
  }

  /// Of the last run, wall-clock time.
  double seconds() const noexcept { return seconds_; }

  /// Edges refused in the last pass: the reason why a run is exhausted.
  const std::vector<Index>& refused_edges() const noexcept { return refused_; }

 private:
  template <class Policy>
  Stop run_passes(Policy& policy) {
    queue_.reserve(mesh_.capacity(1));
    for (Index e = 0; e < mesh_.capacity(1); ++e)
      if (mesh_.is_live(1, e))
        if (const auto cost = policy.cost(mesh_.dart_of(1, e))) queue_.push(e, *cost);
    for (;;) {
      const std::size_t done = operations_;
      if (pass(policy) == Stop::finished) return Stop::finished;
      if (operations_ == done) return Stop::exhausted;
      ask_again(policy);
    }
  }

  template <class Policy>
  Stop pass(Policy& policy) {
    refused_.clear();
    EdgeQueue::Entry next;
    while (queue_.pop(next)) {
      if (!mesh_.is_live(1, next.edge)) continue;
      if (policy.finished(next.cost)) return Stop::finished;
      const Attempt attempt = policy.apply(mesh_.dart_of(1, next.edge), next.cost);
      if (attempt.postponed) {
        queue_.push(next.edge, attempt.cost);
        continue;
      }
      if (!attempt.outcome) {
        refused_.push_back(next.edge);
        continue;
      }
      ++operations_;
      update_around(attempt.outcome, policy);
    }
    return Stop::exhausted;
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

  template <class Policy>
  void ask_again(Policy& policy) {
    for (const Index e : refused_)
      if (mesh_.is_live(1, e))
        if (const auto cost = policy.cost(mesh_.dart_of(1, e))) queue_.push(e, *cost);
  }

  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  Copies copies_;
  EdgeQueue queue_;
  std::vector<Index> refused_;
  DartBuffer star_;
  std::vector<std::pair<Index, Dart>> edges_;
  std::size_t operations_ = 0;
  double seconds_ = 0;
};

}  // namespace multimesh
