// SPDX-License-Identifier: BSD-3-Clause
#include "test/algorithms/collapse_driver.hpp"

#include <algorithm>

#include "multimesh/algorithms/decimation/shape_tests.hpp"
#include "multimesh/algorithms/decimation/texture_orientation.hpp"
#include "multimesh/scheduler.hpp"

namespace multimesh::test {

CollapseDriver::CollapseDriver(TexturedSurface& surface, const DecimateOptions& options)
    : options_(options),
      root_(surface.tree().mesh(NodeId::root)),
      embedding_(surface.embedding()),
      mesh_(embedding_, NodeId::root),
      ranks_(mesh_, options_),
      reader_(mesh_, ranks_),
      cost_(options_, ranks_, reader_),
      star_(reader_),
      places_(mesh_, plan_),
      held_("held place", [this](const Event&) { return held_place_allowed_; }) {
  for (std::size_t k = 0; k < reader_.n_sets(); ++k)
    tests_.push_back(std::make_unique<decimation::TextureOrientation>(reader_, k));
  tests_.push_back(std::make_unique<decimation::NormalTurn>(options_.max_normal_turn));
  mesh_.operations().add(held_);
}

bool CollapseDriver::allowed(const decimation::CollapsePlan& plan) {
  star_.place(plan);
  return std::all_of(tests_.begin(), tests_.end(), [&](auto& t) { return t->allows(star_, plan); }) &&
         std::all_of(more_tests_.begin(), more_tests_.end(), [&](auto* t) { return t->allows(star_, plan); });
}

bool CollapseDriver::collapse(Dart e, const decimation::CollapsePlan& plan) {
  plan_ = plan;
  star_.read(e);
  if (!allowed(plan_)) return false;
  const Outcome outcome =
      mesh_.operations().collapse(NodeId::root, e, [&](const Event&, std::optional<double> held) {
        held_place_allowed_ = true;
        if (held && *held != plan_.t) {
          plan_ = cost_.plan_at(e, *held);
          held_place_allowed_ = allowed(plan_);
        }
        return plan_.t;
      });
  if (!outcome) return false;
  merged_ = outcome.root;
  cost_.collapsed(star_, plan_, root_.vertex(outcome.root) == plan_.a ? End::a : End::b);
  for (const auto& test : tests_) test->collapsed(star_, plan_);
  for (auto* test : more_tests_) test->collapsed(star_, plan_);
  if (on_collapse) on_collapse(star_);
  return true;
}

std::size_t CollapseDriver::collapse_some(std::size_t wanted, std::mt19937& random) {
  std::size_t done = 0;
  for (std::size_t tried = 0; done < wanted && tried < 40 * wanted; ++tried) {
    const auto edge = static_cast<Index>(random() % root_.capacity(1));
    if (!root_.is_live(1, edge)) continue;
    Dart e = root_.dart_of(1, edge);
    if (random() % 2) e = root_.reorder(e, exchange_ends);
    const auto plan = cost_.plan(e);
    if (!plan) continue;
    const bool on_edge = plan->t != 0 && plan->t != 1 && random() % 2;
    done += collapse(e, on_edge ? cost_.plan_at(e, 0.125 * static_cast<double>(random() % 9)) : *plan);
  }
  return done;
}

namespace {

struct CheapestFirst {
  CollapseDriver& driver;
  std::size_t wanted, done = 0;

  std::optional<double> cost(Dart e) const {
    const auto plan = driver.cost().plan(e);
    return plan ? std::optional(plan->cost) : std::nullopt;
  }
  Attempt apply(Dart e, double cost) {
    const auto plan = driver.cost().plan(e);
    if (plan && plan->cost > 1.05 * cost) return Attempt::postpone(plan->cost);
    if (!plan || !driver.collapse(e, *plan))
      return Outcome{{Check::invariant, NodeId::root, {}}, no_dart, no_dart};
    ++done;
    return Outcome{{}, no_dart, driver.merged()};
  }
  bool finished(double) const { return done >= wanted; }
};

}  // namespace

std::size_t CollapseDriver::collapse_cheapest(std::size_t wanted) {
  CheapestFirst policy{*this, wanted};
  PriorityScheduler(mesh_.operations()).run(policy);
  return policy.done;
}

}  // namespace multimesh::test
