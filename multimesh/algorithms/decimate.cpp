// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "multimesh/algorithms/decimation/collapse_cost.hpp"
#include "multimesh/algorithms/decimation/planned_places.hpp"
#include "multimesh/algorithms/decimation/shape_tests.hpp"
#include "multimesh/algorithms/decimation/surface_distance.hpp"
#include "multimesh/algorithms/decimation/texture_distance.hpp"
#include "multimesh/algorithms/decimation/texture_orientation.hpp"
#include "multimesh/scheduler.hpp"

namespace multimesh {

namespace decimation {
namespace {

/// Costs that differ by less than this factor count as equal: an edge is not postponed for it.
constexpr double same_cost = 1.05;
/// A round ends when so much of its faces is left, if others work between rounds.
constexpr double round_share = 0.8;

using Counts = std::map<std::string, std::size_t>;

std::vector<RefusalCount> by_frequency(const Counts& counts) {
  std::vector<RefusalCount> list;
  for (const auto& [reason, n] : counts) list.push_back({reason, n});
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.count > y.count; });
  return list;
}

std::string name_of(const Refusal& r) {
  return std::string(r.check == Check::invariant ? r.invariant : to_string(r.check));
}

class Decimator {
 public:
  Decimator(EmbeddedMesh& surface, const DecimateOptions& options);
  DecimateResult run();

  // The scheduler's policy.
  std::optional<double> cost(Dart e) const {
    CollapsePlan plan;
    return cost_.plan(e, plan) ? std::optional(plan.cost) : std::nullopt;
  }
  Attempt apply(Dart e, double cost);
  bool finished(double next_cost);
  bool is_done() const { return options_.faces > 0 && faces_ <= options_.faces; }

 private:
  void add_tests();
  const PlacementTest* failed_test(const CollapsePlan& plan);
  const PlacementTest* choose_place(Dart e);
  Outcome collapse(Dart e);
  bool moves_locked(const CollapsePlan& plan) const;
  void collapsed(const Outcome& outcome);
  Attempt refuse(const std::string& reason);
  std::string what_keeps(Dart e);
  void explain();
  double run_rounds();

  EmbeddedMesh& surface_;
  const DecimateOptions& options_;
  const Mesh& mesh_;
  Propagation& operations_;
  std::size_t faces_ = 0, round_ends_at_ = 0;
  std::size_t next_level_ = 0;
  DecimateResult result_;
  Counts refused_;

  Ranks ranks_;
  TriangleReader reader_;
  double diagonal_;
  CollapseCost cost_;
  PredictedStar star_;
  CollapsePlan plan_;  ///< for the edge at hand
  PlannedPlaces places_;
  bool place_is_held_ = false;
  FunctionInvariant held_;

  std::vector<std::unique_ptr<PlacementTest>> tests_;
  std::size_t n_bounds_ = 0;  ///< the first of the tests: those that bound the result
};

Decimator::Decimator(EmbeddedMesh& surface, const DecimateOptions& options)
    : surface_(surface),
      options_(options),
      mesh_(surface.mesh()),
      operations_(surface.operations()),
      ranks_(surface, options),
      reader_(surface, ranks_),
      diagonal_(reader_.diagonal()),
      cost_(options, ranks_, reader_),
      star_(reader_),
      places_(surface, plan_),
      held_("place of a held end", [this](const Event&) { return place_is_held_; }) {
  for (Index f = 0; f < mesh_.capacity(2); ++f) faces_ += mesh_.is_live(2, f);
  add_tests();
  operations_.add(held_);
}

void Decimator::add_tests() {
  const auto is_set = [](double limit) { return std::isfinite(limit); };
  if (is_set(options_.max_error))
    tests_.push_back(std::make_unique<SurfaceDistance>(reader_, options_.max_error * diagonal_));
  for (std::size_t k = 0; k < reader_.n_sets(); ++k)
    if (is_set(options_.max_texture_error))
      tests_.push_back(std::make_unique<TextureDistance>(reader_, k, options_.max_texture_error * diagonal_));
  if (is_set(options_.max_normal_deviation))
    tests_.push_back(std::make_unique<NormalDeviation>(reader_, options_.max_normal_deviation));
  if (is_set(options_.max_aspect_ratio))
    tests_.push_back(std::make_unique<AspectRatio>(options_.max_aspect_ratio));
  n_bounds_ = tests_.size();
  for (std::size_t k = 0; k < reader_.n_sets(); ++k) {
    auto test = std::make_unique<TextureOrientation>(reader_, k);
    if (k == 0) result_.charts = test->charts();
    tests_.push_back(std::move(test));
  }
  tests_.push_back(std::make_unique<NormalTurn>(options_.max_normal_turn));
}

/// The first test that the plan fails, or null. Afterwards the star is as this plan predicts.
const PlacementTest* Decimator::failed_test(const CollapsePlan& plan) {
  star_.place(plan);
  for (const auto& test : tests_)
    if (!test->allows(star_, plan)) return test.get();
  return nullptr;
}

// Where the best place fails a test, points on the edge may pass it.
const PlacementTest* Decimator::choose_place(Dart e) {
  const PlacementTest* failed = failed_test(plan_);
  if (!failed || ranks_.rank(plan_.a) != ranks_.rank(plan_.b)) return failed;
  std::array<CollapsePlan, 3> others{cost_.plan_at(e, 0.5), cost_.plan_at(e, 0), cost_.plan_at(e, 1)};
  std::stable_sort(others.begin(), others.end(),
                   [](const auto& x, const auto& y) { return x.cost < y.cost; });
  for (CollapsePlan& other : others) {
    places_.round(other);
    if (!failed_test(other)) {
      plan_ = other;
      return nullptr;
    }
  }
  return failed;
}

Attempt Decimator::refuse(const std::string& reason) {
  ++result_.tried;
  ++refused_[reason];
  return Outcome{{Check::invariant, surface_.node(), {}}, no_dart, no_dart};
}

Attempt Decimator::apply(Dart e, double cost) {
  if (!cost_.plan(e, plan_)) return refuse(name_of({Check::gluing, surface_.node(), {}}));
  if (plan_.cost > cost * same_cost) return Attempt::postpone(plan_.cost);
  places_.round(plan_);
  star_.read(e);
  if (const PlacementTest* failed = choose_place(e)) return refuse(failed->name());
  if (plan_.cost > cost * same_cost) return Attempt::postpone(plan_.cost);
  const Outcome outcome = collapse(e);
  if (!outcome) return refuse(name_of(outcome.refusal));
  collapsed(outcome);
  return outcome;
}

/// By the plan, unless legality holds an end that the ranks did not tell.
Outcome Decimator::collapse(Dart e) {
  return operations_.collapse(surface_.node(), e, [&](const Event&, std::optional<double> held) {
    place_is_held_ = true;
    if (held && *held != plan_.t) {
      plan_ = cost_.plan_at(e, *held);
      places_.round(plan_);
      place_is_held_ = !moves_locked(plan_) && !failed_test(plan_);
    }
    return plan_.t;
  });
}

bool Decimator::moves_locked(const CollapsePlan& plan) const {
  return (plan.moves(End::a) && ranks_.rank(plan.a) == Rank::locked) ||
         (plan.moves(End::b) && ranks_.rank(plan.b) == Rank::locked);
}

void Decimator::collapsed(const Outcome& outcome) {
  const End kept = mesh_.vertex(outcome.dart) == plan_.a ? End::a : End::b;
  double area = 0;
  for (const PredictedStar::Face& f : star_.faces()) {
    faces_ -= f.dies;
    const auto& p = f.before.positions;
    if (f.changes) area += cross(p[1] - p[0], p[2] - p[0]).norm() / 2;
  }
  cost_.collapsed(star_, plan_, kept);
  for (const auto& test : tests_) test->collapsed(star_, plan_);
  ++result_.tried;
  ++result_.collapsed;
  if (area > 0 && options_.cost == DecimateCost::quadric)
    result_.max_cost = std::max(result_.max_cost, std::sqrt(plan_.cost / area));
  if (options_.cost == DecimateCost::length)
    result_.max_cost = std::max(result_.max_cost, std::sqrt(plan_.cost));
  if (options_.progress && result_.collapsed % 1024 == 0) options_.progress(faces_);
}

bool Decimator::finished(double) {
  for (; next_level_ < options_.levels.size() && faces_ <= options_.levels[next_level_]; ++next_level_)
    if (options_.on_level) options_.on_level(next_level_);
  return is_done() || faces_ <= round_ends_at_;
}

std::string Decimator::what_keeps(Dart e) {
  const Refusal illegal = operations_.judge(surface_.node(), e).refusal;
  if (illegal.refused()) return name_of(illegal);
  if (!cost_.plan(e, plan_)) plan_ = cost_.plan_at(e, 0);
  if (ranks_.rank(plan_.a) == Rank::locked && ranks_.rank(plan_.b) == Rank::locked &&
      !ranks_.strata().facets_stay_at(e))
    return name_of({Check::placement, surface_.node(), {}});
  places_.round(plan_);
  star_.read(e);
  if (const PlacementTest* failed = choose_place(e)) return failed->name();
  Transaction trial = operations_.transaction();  // never committed
  return name_of(collapse(e).refusal);
}

void Decimator::explain() {
  Counts counts;
  for (Index e = 0; e < mesh_.capacity(1); ++e)
    if (mesh_.is_live(1, e)) ++counts[what_keeps(mesh_.dart_of(1, e))];
  result_.blocking = by_frequency(counts);
  for (std::size_t i = 0; i < n_bounds_; ++i)
    if (counts.contains(tests_[i]->name())) result_.stop = DecimateResult::Stop::bound;
}

/// Until the target is reached or a round with its improvement by others has not helped. Returns how long the
/// loops took.
double Decimator::run_rounds() {
  PriorityScheduler scheduler(operations_, surface_.node());
  std::vector<Attribute*> carried = surface_.inherited();
  for (Attribute* column : ranks_.columns()) carried.push_back(column);
  double seconds = 0;
  for (bool first = true;; first = false) {
    const std::size_t before = faces_;
    round_ends_at_ =
        options_.between_rounds ? static_cast<std::size_t>(round_share * static_cast<double>(faces_)) : 0;
    scheduler.run(*this);
    seconds += scheduler.seconds();
    if (!options_.between_rounds || is_done() || (faces_ == before && !first)) return seconds;
    places_.stop();
    options_.between_rounds(carried);
    places_.start();
  }
}

DecimateResult Decimator::run() {
  result_.faces_before = faces_;
  const double seconds = run_rounds();
  (void)finished(0);  // levels that the last collapse has reached
  if (is_done()) {
    result_.stop = DecimateResult::Stop::faces;
  } else {
    explain();
  }
  result_.faces_after = faces_;
  result_.seconds = seconds;
  result_.refused = by_frequency(refused_);
  result_.max_cost /= diagonal_ > 0 ? diagonal_ : 1;
  return std::move(result_);
}

void check_options(const DecimateOptions& o) {
  if (o.faces == 0 && !std::isfinite(o.max_error) && !std::isfinite(o.max_texture_error))
    throw InputError(
        "decimate: no target; give a number of faces, a maximal error or a maximal texture error");
  const auto require = [](bool good, const char* what) {
    if (!good) throw InputError(std::string("decimate: ") + what);
  };
  require(o.max_error >= 0, "max_error must not be negative");
  require(o.max_texture_error >= 0, "max_texture_error must not be negative");
  require(o.max_normal_deviation >= 0, "max_normal_deviation must not be negative");
  require(o.max_normal_turn >= 0 && o.max_normal_turn < std::numbers::pi,
          "max_normal_turn must be in [0, pi)");
  require(o.max_aspect_ratio >= 2 / std::sqrt(3.0), "max_aspect_ratio must be at least 1.155");
  for (const double w : {o.uv_weight, o.curve_weight, o.seam_weight, o.uv_curve_weight, o.memory_weight})
    require(w >= 0 && std::isfinite(w), "weights must be finite and not negative");
  for (std::size_t i = 0; i < o.levels.size(); ++i)
    require(o.levels[i] > (i + 1 < o.levels.size() ? o.levels[i + 1] : o.faces),
            "levels must descend, and end above the target number of faces");
}

}  // namespace
}  // namespace decimation

DecimateResult decimate(const Embedding& embedding, NodeId node, const DecimateOptions& options) {
  decimation::check_options(options);
  if (embedding.tree().mesh(node).dimension() != 2) throw UsageError("decimate: the mesh must be a surface");
  EmbeddedMesh surface(embedding, node);
  return decimation::Decimator(surface, options).run();
}

DecimateResult decimate(TexturedSurface& surface, const DecimateOptions& options) {
  return decimate(surface.embedding(), NodeId::root, options);
}

}  // namespace multimesh
