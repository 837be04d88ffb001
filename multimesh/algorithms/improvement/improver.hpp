// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/improvement/candidates.hpp"
#include "multimesh/algorithms/improvement/obstacles.hpp"
#include "multimesh/edge_queue.hpp"

namespace multimesh::improvement {

/// The loop over bad tetrahedra.
class Improver {
 public:
  Improver(TetDomain& domain, const ImproveOptions& options);

  /// One pass over all tetrahedra above the target, worst first. Where nothing helps at once, that many
  /// splits are tried that make things worse at first, and kept if what follows makes them better than
  /// before. \return how many operations were done
  std::size_t pass(int trial_splits);
  /// Splits edges that are too long, and collapses short ones. \return how many
  std::size_t resize();

  const Workspace& work() const { return work_; }
  const Counts& counts() const { return counts_; }
  /// Cubed energy above which a tetrahedron is bad.
  double limit() const { return limit_; }

 private:
  bool improve_tet(Index t);
  bool is_forced(Index t, const Obstacles& obstacles) const;
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
  void changed(Dart v);
  bool improve_touched(double limit);

  template <class Length, class Apply>
  std::size_t sweep_edges(const Length& length, const Apply& apply);

  ImproveOptions options_;
  double limit_;
  Workspace work_;
  Counts counts_{};
  Candidates candidates_;
  Demand demand_;
  EdgeQueue queue_;  ///< of tetrahedra; cost: minus the quality
  std::size_t done_ = 0;
  bool trying_ = false;  ///< in a trial: changes go to touched_
  std::vector<Index> touched_, star_;
  std::vector<Index> fresh_;  ///< vertices made by the trial, which may not be collapsed at once
  mutable Ring ring_;
};

}  // namespace multimesh::improvement
