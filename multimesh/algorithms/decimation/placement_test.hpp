// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "multimesh/algorithms/decimation/predicted_star.hpp"

namespace multimesh::decimation {

/// A condition on the place of a merged vertex, evaluated on the predicted star before anything is touched.
class PlacementTest {
 public:
  explicit PlacementTest(std::string name) : name_(std::move(name)) {}
  virtual ~PlacementTest() = default;
  PlacementTest(const PlacementTest&) = delete;
  PlacementTest& operator=(const PlacementTest&) = delete;

  const std::string& name() const noexcept { return name_; }
  /// \pre star.place(plan) was called
  virtual bool allows(const PredictedStar& star, const CollapsePlan& plan) = 0;
  /// Called after the collapse, for tests that store something per triangle.
  virtual void collapsed(const PredictedStar&, const CollapsePlan&) {}

 private:
  std::string name_;
};

}  // namespace multimesh::decimation
