// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/io/weld_surface.hpp"
#include "tools/domain_arguments.hpp"
#include "tools/run_report.hpp"

namespace multimesh::tools {

struct RemeshArguments {
  std::string input, output;
  ReportOptions report;
  double length = 0, relative_length = 0;  ///< 0: not given
  double feature_angle = 0;                ///< degrees; 0: not given
  bool preserve_materials = true, quiet = false, follow_paths = false;
  SurfaceRemeshOptions options;
  io::SurfaceWeldOptions weld;

  // Of tetrahedra.
  bool weld_given = false, uv_weld_given = false, target_given = false;
  double target_amips = 10;
  std::vector<std::string> locked_patches;
  std::vector<TetDomain::Tag> locked_regions;
  bool no_periodic = false;
  SimplexFormat format;
};

Json to_json(const RemeshArguments& a, const RemeshResult& r);
double percent_in_range(const RemeshResult& r);
/// A sentence if the length was not reached.
void warn_of_lengths(const RemeshArguments& a, const RemeshResult& r, std::vector<std::string>& warnings);

}  // namespace multimesh::tools
