// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/io/weld_surface.hpp"
#include "tools/periodic_arguments.hpp"
#include "tools/run_report.hpp"
#include "tools/tetrahedra_arguments.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

/// What the command line of `multimesh decimate` says. Angles in degrees; 0 where an option is not given.
struct DecimateArguments : TetrahedraArguments {
  std::string input, output;
  ReportOptions report;
  double ratio = 0, max_error = 0, max_texture_error = 0;
  std::size_t faces = 0;
  std::vector<double> levels;  ///< ratios, or numbers of faces
  bool lock_boundary = false, lock_seams = false, preserve_materials = true;
  double normal_deviation = 0, aspect_ratio = 0, feature_angle = 0;
  DecimateOptions weights;  ///< only cost and weights of it
  std::string cost = "quadric";
  bool measure = false, quiet = false, follow_paths = false;
  io::SurfaceWeldOptions weld;
  bool improve = false;  ///< of tetrahedra
  PeriodicArguments periodic;
};

/// Adds the options to the command; they are written into `a` when it is parsed.
void add_options(CLI::App& command, DecimateArguments& a);

TexturedSurfaceOptions surface_options(const DecimateArguments& a);
/// `faces`: how many the input has. \throw InputError if the levels do not descend to the target
DecimateOptions decimate_options(const DecimateArguments& a, std::size_t faces);

}  // namespace multimesh::tools
