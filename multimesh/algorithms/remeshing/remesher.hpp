// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/remeshing/distance_guard.hpp"
#include "multimesh/algorithms/remeshing/part_sizes.hpp"
#include "multimesh/algorithms/remeshing/reference.hpp"
#include "multimesh/algorithms/remeshing/star_shape.hpp"
#include "multimesh/column.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/refused_questions.hpp"
#include "multimesh/scheduler.hpp"
#include "multimesh/strata.hpp"

namespace multimesh::remeshing {

// Botsch and Kobbelt 2004, section 4: relative to the requested length.
inline constexpr double shortest_share = 4.0 / 5, longest_share = 4.0 / 3;
/// With these thresholds, edges on a surface are on average 0.92 of the length to which they refer
/// (docs/remesh.md). The requested length is the average.
inline constexpr double of_average = 1 / 0.92;

/// One run. The passes change the mesh so that lengths come into range; between them vertices are moved to
/// where triangles are regular, always onto the input. Nothing is asked again until a star there has changed.
class Remesher {
 public:
  Remesher(EmbeddedMesh& surface, const RemeshOptions& options);
  RemeshResult run();
  /// Per edge: the number of its curve, from 1; 0 for plain edges.
  const std::vector<Index>& lines() const noexcept { return line_; }

 private:
  void let_others_work(int round);
  void lock_lines();
  bool is_side_of_chart(Dart edge);
  bool is_locked_line(Dart edge) const {
    return !locked_lines_.empty() && locked_lines_[line_[mesh_.simplex(edge, 1)]];
  }
  /// Whether the edge may neither be split nor collapsed.
  bool is_frozen(Dart edge) const { return is_locked_line(edge) || strata_.is_frozen(edge); }
  /// That of the strata, but for locked lines.
  Freedom freedom(Dart vertex, std::array<Dart, 2>& line) const;
  void refine();
  PriorityScheduler::Stop split_long_edges();
  bool flattens_beside_whole(Dart edge);
  Outcome halve(Dart edge);
  void collapse_short_edges();
  void swap_edges();
  void smooth();
  void raise_least_angles();
  void restore_sizes();
  std::vector<PartSizes::Step> steps_off_the_input();
  Vec3 way_off_the_curve(Dart vertex, const std::array<Dart, 2>& line) const;
  Vec3 way_off_the_surface(Dart vertex);

  bool may_be_removed(Dart edge);
  Outcome collapse(Dart edge);
  Outcome collapse_guarded(Dart edge);
  double longest_after_collapse(Dart edge);
  bool swap(Dart edge);
  bool may_be_swapped(Dart edge);
  bool swap_guarded(Dart edge);
  int deviation(Dart vertex, int change);
  void smooth(Dart vertex);
  bool move_to_centre(Dart vertex);
  Vec3 centre(Dart vertex, Vec3& normal);
  struct Wanted {
    Vec3 at;
    double from_input;  ///< usually no farther than that
  };
  std::optional<Place> place(Dart vertex, Freedom freedom, const std::array<Dart, 2>& line,
                             const Wanted& wanted, const Vec3& normal) const;
  bool move(Dart vertex, const Place& to);
  double least_angle_of(Dart triangle) const;
  void queue_small_angles(WorkQueue& faces) const;
  bool raise_angle(Dart triangle);
  bool swap_to_raise_angles(Dart edge);
  bool collapse_to_raise_angles(Dart edge);
  bool move_to_raise_angles(Dart vertex);
  std::vector<Vec3> near_places(Dart vertex, Freedom freedom, const std::array<Dart, 2>& line,
                                const Vec3& normal) const;
  /// The triangles around all copies that the surface has of a k-simplex; around both ends of edges.
  void read_stars(const Copies& copies, int k, DartBuffer& triangles);
  void read_stars_of_ends(const Copies& edges, DartBuffer& triangles);
  void drop_repeated(DartBuffer& triangles, std::size_t stars) const;
  bool others_allow_collapse(Dart edge);
  /// An operation on the triangles of changing_; undone if it moves the surface too far from the input.
  Outcome guarded(const std::function<Outcome()>& operation);
  Outcome refuse() const { return {{Check::invariant, node_, {}}, no_dart, no_dart}; }
  bool assign(const Place& to);

  Vec3 at(Dart d) const { return positions_.at(mesh_.vertex(d)); }
  double length(Dart edge) const { return (at(edge) - at(mesh_.reorder(edge, exchange_ends))).norm(); }
  /// Its length relative to the thresholds.
  double measure(Dart edge);
  double measure_on_line(double length, Dart from, Dart to);
  std::optional<double> next_on_line(Dart edge);
  void count_edges();

  // --- what is asked of whom, and was refused
  enum class Question : std::uint8_t { smooth, raise_vertex, raise_face };
  static std::uint64_t question(Question q, Index simplex) {
    return std::uint64_t{simplex} << 2U | static_cast<std::uint64_t>(q);
  }
  StarStamps::Stamp stamp(Dart triangle) const;
  void all_has_changed();
  void note_changes(const DartBuffer& triangles);

  EmbeddedMesh& surface_;
  Propagation& operations_;
  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  Coordinates& positions_;
  std::span<Coordinates* const> below_;
  const RemeshOptions& options_;
  std::vector<Index> patch_, line_;  // of faces and edges, see Reference
  Column<Index> patch_column_, line_column_;
  std::vector<bool> locked_lines_;  // by number; empty: none
  double shortest_, longest_, smallest_move_;
  std::vector<bool> placed_;  // per vertex: on the input
  StarStamps stars_;
  RefusedQuestions refused_;
  PriorityScheduler splitting_, collapsing_;

  Strata strata_;
  Reference reference_;
  DistanceGuard guard_;
  StarShape shape_;
  PartSizes sizes_;
  std::vector<std::unique_ptr<KeepsOrientation>> sides_below_;
  RemeshResult result_;

  struct Write {
    std::size_t mesh;
    Dart dart;
    Vec3 at;
  };
  Copies copies_;
  std::vector<Write> writes_;
  DartBuffer star_, edges_, changing_;
  std::vector<Index> corners_;
};

}  // namespace multimesh::remeshing
