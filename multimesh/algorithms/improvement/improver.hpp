// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/improvement/candidates.hpp"
#include "multimesh/algorithms/improvement/obstacles.hpp"
#include "multimesh/work_queue.hpp"

namespace multimesh::improvement {

/// How bad a mesh is, apart from what the surface forces.
struct Badness {
  double worst = 0;   ///< the greatest quality, relative to what is required there
  double volume = 0;  ///< of the tetrahedra above that
  bool is_worse_than(const Badness& other) const;
};

/// Within this factor of what the surface forces, a tetrahedron cannot be improved.
inline constexpr double near_bound = 1.1;

/// The loop over bad tetrahedra.
class Improver {
 public:
  Improver(const Embedding& embedding, NodeId node, const ImproveOptions& options);

  /// Tetrahedra are bad from now on if their energy is above this.
  void aim_at(double amips);
  std::size_t count_above(double amips) const { return count_worse(amips * amips * amips); }
  std::size_t count_bad() const { return count_worse(limit_); }
  /// One pass over all bad tetrahedra, worst first. Where nothing helps directly, that many splits are tried
  /// that make things worse at first; they are kept if the operations after them make things better than
  /// before. \return how many operations were done
  std::size_t pass(int trial_splits);
  /// Makes smaller steps count, with more trials. \return false if this was already the case
  bool take_smaller_steps();
  /// Refines around all bad tetrahedra, regardless of quality at first, and makes passes on the result.
  /// Undoes everything unless the mesh gets better.
  bool refine_and_improve();
  /// Splits edges above this length, longest first; quality counts only where it was good enough.
  /// \return how many
  std::size_t split_longer(double longest, const Demand& demand);
  /// Splits all edges above this length at their middle, regardless of quality.
  std::size_t split_longer(double longest);
  /// Splits edges that are too long, and collapses short ones. \return how many
  /// \param first quality does not matter for the splits yet
  std::size_t resize(bool first);
  /// For the current mesh, compared with the requested length.
  EdgeLengths measure_lengths() const;
  /// How many tetrahedra the mesh may have while edges are split for quality.
  void set_largest_size(std::size_t tets) { largest_size_ = tets; }
  /// Called about once a second.
  void set_tick(std::function<void()> tick) { tick_ = std::move(tick); }
  bool is_out_of_time() const;
  Badness badness() const;
  /// Whether splits were omitted because the mesh had reached its limit.
  bool was_full() const { return was_full_; }
  const Obstacles& forced() const { return forced_; }

  const Workspace& work() const { return work_; }
  const Counts& counts() const { return counts_; }
  /// Cubed energy above which a tetrahedron is bad.
  double limit() const { return limit_; }

 private:
  bool improve_tet(Index t);
  void improve_bad(Index t, int trial_splits);
  bool was_asked(Index t, int effort) const;
  Refusals::Stamp stamp(Index t) const;
  std::size_t count_worse(double quality) const;
  void push(Index t);
  Demand daring() const;
  double demanded(Index t) const;
  void grade(Index v, Index a, Index b);
  bool may_grow();
  void tick();
  void push_bad();
  std::size_t refine();
  Dart longest_edge(Index t) const;
  bool is_kept(Index v) const { return v < kept_.size() && kept_[v]; }
  void keep(Index v);
  bool try_splits(Index t);
  bool try_refinement(Index t, int splits);
  template <class Start>
  bool attempt(double before, const Start& start);
  Dart longest_edge_near(Index t) const;
  Index worst_touched(double& quality) const;
  bool swap_or_collapse(Index t, const Demand& demand);
  bool smooth(Index t, const Demand& demand);
  bool split(Index t, const Demand& demand);
  /// \return a dart at a vertex that all new tetrahedra contain, no_dart if refused
  Dart apply(const Candidate& candidate);
  bool take(const Candidate& candidate);
  void note_refused(const Candidate& candidate, Index a, Index b);
  template <class Find>
  bool take_best(const Demand& demand, const Find& find);
  void changed(Dart v, bool surface);
  bool improve_touched(double limit);

  template <class Excess, class Apply>
  std::size_t sweep_edges(const Excess& excess, const Apply& apply);

  ImproveOptions options_;
  double limit_;
  Workspace work_;
  Obstacles forced_;
  /// Per vertex: the AMIPS energy that is unavoidable around it.
  std::vector<double> expected_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), ticked_ = start_;
  std::size_t largest_size_ = std::numeric_limits<std::size_t>::max();
  bool was_full_ = false;
  int questions_ = 0;     ///< whether the mesh may grow
  std::size_t size_ = 0;  ///< as of a few questions ago
  std::function<void()> tick_;
  Counts counts_{};
  Refusals refusals_;
  Candidates candidates_;
  /// The greatest effort spent in vain on a tetrahedron, and the stamp of its corners' stars then.
  struct Asked {
    Refusals::Stamp stamp = 0;
    int effort = -1;
  };
  std::vector<Asked> asked_;
  Demand demand_;
  WorkQueue queue_;  ///< of tetrahedra; cost: minus the quality
  std::size_t done_ = 0;
  bool trying_ = false;  ///< in a trial: changes go to touched_
  std::vector<Index> touched_, star_, corners_;
  Dart split_at_ = no_dart;   ///< at the vertex of the last split
  std::vector<bool> kept_;    ///< vertices made by refinement, which may not be collapsed at once
  std::vector<Index> fresh_;  ///< vertices made by the trial, which may not be collapsed at once
  mutable Ring ring_;
  mutable DartBuffer copies_;
};

}  // namespace multimesh::improvement
