// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/io/weld_surface.hpp"
#include "tools/periodic_arguments.hpp"
#include "tools/run_report.hpp"
#include "tools/tetrahedra_arguments.hpp"

namespace multimesh::tools {

struct RemeshArguments : TetrahedraArguments {
  std::string input, output;
  ReportOptions report;
  double length = 0, relative_length = 0;  ///< 0: not given
  double feature_angle = 0;                ///< degrees; 0: not given
  bool preserve_materials = true, quiet = false, follow_paths = false;
  RemeshOptions options;
  io::SurfaceWeldOptions weld;
  PeriodicArguments periodic;
};

Json to_json(const RemeshArguments& a, const RemeshResult& r);
double percent_in_range(const RemeshResult& r);
/// A sentence if the length was not reached.
void warn_of_lengths(const RemeshArguments& a, const RemeshResult& r, std::vector<std::string>& warnings);

}  // namespace multimesh::tools
