// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/domains/periodic_domain.hpp"
#include "tools/html_report.hpp"
#include "tools/run_report.hpp"

namespace multimesh::tools {

/// A tile as a page shows it: triangles by regions, those at a side in the colour of the side; of tetrahedra
/// the sides, each with the colour of its lattice vector, the surface of the material, and interfaces.
HtmlMesh html_mesh(const PeriodicDomain& domain);

/// The page of a command on a tile: construct it before the run.
class TilePage {
 public:
  explicit TilePage(const PeriodicDomain& before);
  /// With the numbers that the report has so far.
  void show(RunReport& report, const PeriodicDomain& after, const std::string& input,
            const std::string& output);

 private:
  HtmlMesh before_;
  HtmlHistogram histogram_;
};

}  // namespace multimesh::tools
