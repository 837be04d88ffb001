// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

#include "adapters/io/atomic_file.hpp"
#include "multimesh/algorithms/bounding_box.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/version.hpp"
#include "tools/command.hpp"
#include "tools/follow_paths.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/surface_file.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

namespace {

struct RemeshArguments {
  std::string input, output, report;
  double length = 0, relative_length = 0;  ///< 0: not given
  double feature_angle = 0;                ///< degrees; 0: not given
  bool preserve_materials = true, quiet = false, follow_paths = false;
  SurfaceRemeshOptions options;
};

void add_options(CLI::App& command, RemeshArguments& a) {
  const auto length =
      number([](double l) { return l > 0 && std::isfinite(l); }, "above 0, for instance 0.02", "L");
  command.add_option("IN", a.input, "surface to read: OBJ, PLY, OFF or STL")->required();
  command.add_option("-o,--output", a.output, "OBJ file to write")->required();
  auto* target = command.add_option_group("Length", "of the edges that are wanted");
  target->add_option("--length", a.length, "in the units of the file")->check(length);
  target->add_option("--relative-length", a.relative_length, "relative to the diagonal of the bounding box")
      ->check(length);
  target->require_option(1);
  command.add_option("--iterations", a.options.iterations, "rounds of split, collapse, swap and smoothing")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option("--feature-angle", a.feature_angle,
                  "edges at which the surface bends by this or more, in degrees, are kept as curves")
      ->check(number([](double d) { return d > 0 && d <= 180; }, "in (0, 180], for instance 40", "DEGREES"));
  command.add_flag("--lock-seams", a.options.lock_seams, "keep texture seams as they are, edge by edge");
  command.add_flag("--lock-boundary", a.options.lock_boundary, "keep the boundary as it is, edge by edge");
  command.add_flag("--preserve-materials,!--no-preserve-materials", a.preserve_materials,
                   "keep borders between materials as curves (default: yes)");
  add_follow_paths(command, a.follow_paths);
  command.add_option("--report", a.report, "write what was done as JSON");
  command.add_flag("--quiet", a.quiet, "print errors only");
}

Json to_json(const RemeshArguments& a, const RemeshResult& r) {
  Json j;
  j["program"] = std::string("multimesh ") + version;
  j["input"] = a.input;
  j["output"] = a.output;
  j["options"] = {{"length", a.options.length},
                  {"iterations", a.options.iterations},
                  {"feature_angle_degrees", a.feature_angle},
                  {"lock_seams", a.options.lock_seams},
                  {"lock_boundary", a.options.lock_boundary},
                  {"preserve_materials", a.preserve_materials}};
  j["operations"] = {
      {"splits", r.splits}, {"collapses", r.collapses}, {"swaps", r.swaps}, {"moves", r.moves}};
  j["edges"] = r.edges;
  j["edges_in_range"] = r.edges_in_range;
  j["seconds"] = r.seconds;
  return j;
}

void check_paths(const RemeshArguments& a) {
  check_obj_output(a.output);
  if (!a.report.empty()) check_output_path(a.report, {a.input, a.output});
}

void run(RemeshArguments& a) {
  check_paths(a);
  SurfaceFile file = read_surface(a.input);
  file.follow_paths = a.follow_paths;
  a.options.length =
      a.length > 0 ? a.length : a.relative_length * bounding_box_diagonal(file.input.positions);
  if (!(a.options.length > 0)) throw InputError(a.input + ": the surface has no extent; give --length");
  TexturedSurfaceOptions curves;
  if (a.feature_angle > 0) curves.feature_angle = a.feature_angle * std::numbers::pi / 180;
  curves.keep_label_borders = a.preserve_materials;
  TexturedSurface surface = take_surface(file, curves);
  Json before;
  if (!a.report.empty()) before = tools::to_json(surface);
  const std::size_t faces = surface.live_triangles();
  const RemeshResult result = remesh(surface, a.options);
  write_surface(a.output, surface, file, file.warnings);
  if (!a.report.empty()) {
    Json j = to_json(a, result);
    j["before"] = before;
    j["after"] = tools::to_json(surface);
    j["warnings"] = file.warnings;
    io::AtomicFile report(a.report);
    report.write(to_text(j));
    report.commit();
  }
  if (a.quiet) return;
  for (const auto& w : file.warnings) std::cerr << "warning: " << w << '\n';
  const double share = 100.0 * static_cast<double>(result.edges_in_range) / static_cast<double>(result.edges);
  std::cerr << faces << " faces -> " << surface.live_triangles() << " in " << result.seconds << " s; "
            << std::round(10 * share) / 10 << " % of the edges are within 4/5 and 4/3 of " << a.options.length
            << '\n';
}

}  // namespace

void add_remesh_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("remesh", "Make all edges about as long; texture seams and curves stay lines.");
  auto a = std::make_shared<RemeshArguments>();
  add_options(*command, *a);
  command->footer(
      "Example:  multimesh remesh cow.obj -o even.obj --relative-length 0.01\n"
      "          multimesh remesh part.stl -o even.obj --length 2.5 --feature-angle 40\n\n"
      "Kept: the topology of the surface and of every chart, the graph of the seams and of the curves, "
      "materials\n"
      "and groups of each face. Seams are not frozen: they get edges of the same length. Vertices stay on "
      "the\n"
      "input, with its texture coordinates there. No triangle of the texture flips or loses its area.");
  command->callback([a, &exit_code] {
    run(*a);
    exit_code = done;
  });
}

}  // namespace multimesh::tools
