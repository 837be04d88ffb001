// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/improvement/candidates.hpp"
#include "multimesh/edge_queue.hpp"

namespace multimesh::improvement {

/// The loop over bad tetrahedra.
class Improver {
 public:
  Improver(TetDomain& domain, const ImproveOptions& options);

  /// One pass over all tetrahedra above the target, worst first. In a daring one, a split that makes things
  /// worse is kept if what follows at once makes them better than before.
  /// \return how many operations were done
  std::size_t pass(bool daring);
  /// Splits edges that are too long, and collapses short ones. \return how many
  std::size_t resize();

  const Workspace& work() const { return work_; }
  const Counts& counts() const { return counts_; }
  /// Cubed energy above which a tetrahedron is bad.
  double limit() const { return limit_; }

 private:
  bool improve_tet(Index t);
  bool dare(Index t);
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
  bool trying_ = false;         ///< in a trial: changes go to touched_
  std::vector<Index> touched_, star_;
};

}  // namespace multimesh::improvement
