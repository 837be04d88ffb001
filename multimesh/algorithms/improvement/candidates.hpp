// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "multimesh/algorithms/improvement/counts.hpp"
#include "multimesh/algorithms/improvement/exact_place.hpp"
#include "multimesh/algorithms/improvement/refusals.hpp"
#include "multimesh/algorithms/improvement/smoothing.hpp"
#include "multimesh/algorithms/improvement/workspace.hpp"

namespace multimesh::improvement {

/// How surface and curve edges may be split, see SurfaceSplits.
enum class HeldSplits : std::uint8_t { none, exact, rounded };

/// An operation that would improve the worst of the tetrahedra it replaces.
struct Candidate {
  Kind kind = Kind::smoothing;
  Dart dart = no_dart;
  double before = 0;  ///< the worst quality of what it replaces
  double after = std::numeric_limits<double>::infinity();
  Vec3 place{};              ///< of the new or moved vertex
  std::uint8_t strata = 0;   ///< of the new vertex
  bool in_boundary = false;  ///< a swap of an edge of the boundary
  bool surface = false;      ///< whether it changes triangles of the surface, or curves

  explicit operator bool() const noexcept { return dart != no_dart; }
};

/// Requirements on a candidate.
struct Demand {
  double gain = 0.97;                                        ///< after < gain * before
  double enough = 0;                                         ///< or after <= this
  double shortest = 0;                                       ///< no new edge is shorter
  double longest = std::numeric_limits<double>::infinity();  ///< no new edge is longer
  HeldSplits held_splits = HeldSplits::rounded;
  bool in_middle = false;  ///< splits put the new vertex at the middle, not at the best place
  bool sharp = false;      ///< vertices may also move to where the worst tetrahedron alone is best
  bool remember = false;   ///< refused candidates are not tried again until something around them has changed

  bool is_too_long(const Vec3& p, const Vec3& q) const {
    return longest < std::numeric_limits<double>::infinity() && (p - q).norm() > longest;
  }
  double limit(double before) const { return std::max(gain * before, enough); }
};

/// Finds candidates from positions only; nothing is changed. Candidates worse than `best` are not found.
/// Refusals are counted.
class Candidates {
 public:
  Candidates(const Workspace& work, Counts& counts, Refusals& refusals)
      : work_(work), counts_(counts), refusals_(refusals), place_(work) {}

  /// Whether the operation on the edge is known to be refused; of a vertex: a = b.
  bool is_known(Kind kind, Index a, Index b, const Demand& demand) const {
    return demand.remember && refusals_.knows(kind, a, b);
  }
  /// The same for both orders of the ends.
  bool is_edge_known(Kind kind, Index a, Index b, const Demand& demand) const {
    return is_known(kind, std::min(a, b), std::max(a, b), demand);
  }

  /// For the edge of a dart, with the best apex.
  void edge_swap(Dart e, const Demand& demand, Candidate& best);
  /// For the face of a dart.
  void face_swap(Dart f, const Demand& demand, Candidate& best);
  /// For all faces of a tetrahedron.
  void face_swaps(Index t, const Demand& demand, Candidate& best);
  /// For the edge of (a,b,..), moving a to b.
  void collapse(Dart e, const Demand& demand, Candidate& best);
  /// For the vertex of a dart.
  void smoothing(Dart v, const Demand& demand, Candidate& best);
  /// For the edge of a dart, with the new vertex at its best place; on held edges, at the middle.
  void split(Dart e, const Demand& demand, Candidate& best);

 private:
  /// A face of a tetrahedron: its corners, and the opposite one, of positive orientation.
  struct Face {
    Dart dart;
    Index tet;
    Corners corners;
  };
  /// \param here the quality of the tetrahedron, once it is known; negative before
  void face_swap(const Face& face, double& here, const Demand& demand, Candidate& best);
  /// What is held around the edge of the ring.
  struct EdgeState {
    bool curve = false, locked = false;
    std::vector<std::size_t> faces;  ///< positions in the rim
    bool is_free() const { return !curve && !locked && faces.empty(); }
  };
  void read_edge_state(const Ring& ring);
  void read_halves(const Ring& ring);
  double read_copies_of_edge(Dart e);
  bool may_split_held(const Vec3& middle, HeldSplits splits) const;
  void refuse(Kind kind, Why why) {
    ++counts_[static_cast<std::size_t>(kind)].refused[static_cast<std::size_t>(why)];
  }
  void refuse_worse(Kind kind, double after) {
    refuse(kind, after < std::numeric_limits<double>::infinity() ? Why::worse : Why::inverted);
  }
  /// Counts an attempt, unless it is known to be refused.
  bool is_refused_already(Kind kind, Index a, Index b, const Demand& demand) {
    if (is_known(kind, a, b, demand)) return true;
    tried(kind);
    return false;
  }
  void note(Kind kind, Index a, Index b, const Demand& demand) {
    if (demand.remember) refusals_.note(kind, a, b);
  }
  std::pair<Index, Index> ends(Dart e) const;
  bool read_place(Dart v, const Demand& demand);
  void read_star_at(Dart v);
  void tried(Kind kind) { ++counts_[static_cast<std::size_t>(kind)].tried; }
  double ring_quality(const Ring& ring) const;
  double star_quality(const std::vector<Corners>& star) const;
  double fan_quality(const Ring& ring, std::size_t apex, double limit) const;
  bool read_merging(Dart e);
  double merged_quality(double limit) const;
  Axes allowed_axes(Index v) const;
  Vec3 place_on_surface(const Vec3& start, Axes axes, double limit) const;
  bool may_swap_wall(const Ring& ring) const;
  bool is_fan_too_long(const Ring& ring, std::size_t apex, const Demand& demand) const;
  void read_opposite(Index v);
  const Vec3& point(Index v) const { return work_.point(v); }

  const Workspace& work_;
  Counts& counts_;
  Refusals& refusals_;
  ExactPlace place_;
  Ring ring_;
  EdgeState edge_;
  std::vector<Corners> star_;
  Index star_of_ = no_index;  ///< the vertex of that star, in this state
  Refusals::Stamp star_stamp_ = 0;
  double star_quality_ = 0;
  std::vector<Opposite> opposite_;
  /// Of an edge with copies:
  DartBuffer copies_;
  std::vector<std::pair<Index, Index>> merging_;  ///< their vertices: each first one goes to the second
  Ring beside_;
};

}  // namespace multimesh::improvement
