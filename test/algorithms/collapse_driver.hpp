// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "multimesh/algorithms/decimation/collapse_cost.hpp"
#include "multimesh/algorithms/decimation/placement_test.hpp"
#include "multimesh/algorithms/decimation/planned_places.hpp"
#include "multimesh/operations.hpp"

namespace multimesh::test {

/// The parts of decimation, put together as decimate() does, without its queue: collapses of any edge, to any
/// place that legality and the orientation of triangles allow.
class CollapseDriver {
 public:
  CollapseDriver(TexturedSurface& surface, const DecimateOptions& options);

  /// Collapses e by its plan, if that is allowed. \return whether it was done
  bool collapse(Dart e, const decimation::CollapsePlan& plan);
  /// Collapses of random edges, half of them to the best place, half to a place on the edge; ends early where
  /// nearly all are refused. \return how many were done
  std::size_t collapse_some(std::size_t wanted, std::mt19937& random);
  /// Collapses the cheapest edges first. \return how many were done
  std::size_t collapse_cheapest(std::size_t wanted);

  /// A dart at the vertex that the last collapse made.
  Dart merged() const { return merged_; }
  const Mesh& root() const { return root_; }
  const decimation::CollapseCost& cost() const { return cost_; }
  const decimation::Ranks& ranks() const { return ranks_; }
  const decimation::TriangleReader& reader() const { return reader_; }
  /// A test to be asked besides those of the driver; not owned.
  void add(decimation::PlacementTest& test) { more_tests_.push_back(&test); }
  /// Called after a collapse with the star as it was predicted.
  std::function<void(const decimation::PredictedStar&)> on_collapse;

 private:
  bool allowed(const decimation::CollapsePlan& plan);

  const DecimateOptions options_;
  const Mesh& root_;
  Embedding embedding_;
  EmbeddedMesh mesh_;
  decimation::Ranks ranks_;
  decimation::TriangleReader reader_;
  decimation::CollapseCost cost_;
  decimation::PredictedStar star_;
  decimation::CollapsePlan plan_;
  decimation::PlannedPlaces places_;
  std::vector<std::unique_ptr<decimation::PlacementTest>> tests_;
  std::vector<decimation::PlacementTest*> more_tests_;
  bool held_place_allowed_ = false;
  FunctionInvariant held_;
  Dart merged_ = no_dart;
};

/// The costs of a surface as it is, summed up anew.
struct FreshCost {
  FreshCost(TexturedSurface& surface, const DecimateOptions& options)
      : embedding(surface.embedding()),
        mesh(embedding, NodeId::root),
        ranks(mesh, options),
        reader(mesh, ranks),
        cost(options, ranks, reader) {}

  Embedding embedding;
  EmbeddedMesh mesh;
  decimation::Ranks ranks;
  decimation::TriangleReader reader;
  decimation::CollapseCost cost;
};

}  // namespace multimesh::test
