// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adapters/tetgen/regions.hpp"
#include "adapters/tetgen/worker_call.hpp"
#include "multimesh/tetgen/facets.hpp"

namespace multimesh::tetgen {

/// TetGen's tetrahedra, and the regions into which facets divide them.
struct Filling {
  RawTetrahedra raw;
  Regions regions;
};

/// TetGen's input: the facets, and only the points that they use.
class Surface {
 public:
  Surface(std::span<const Point> all, const Facets& facets);

  /// \throw InputError if it fails because facets intersect, WorkerError if it fails otherwise
  Filling fill(const std::string& switches, const RegionOptions& options, const WorkerOptions& worker,
               std::span<const Point> holes = {}) const;

  const std::vector<Index>& used() const { return used_; }  ///< per point, the input point
  const std::vector<Point>& points() const { return points_; }
  const Facets& facets() const { return facets_; }  ///< of these points

 private:
  std::vector<Index> used_;  // ascending
  std::vector<Point> points_;
  Facets facets_;
};

/// Gives the regions of `later` the numbers of `first`, of which some were left out. Regions are identified
/// by their facets. \throw WorkerError (bad_result) if they are not the same
void renumber(Regions& later, const Regions& first);

}  // namespace multimesh::tetgen
