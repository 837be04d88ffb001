// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/version.hpp"
#include "tools/command.hpp"
#include "tools/comparison_page.hpp"
#include "tools/follow_paths.hpp"
#include "tools/joined_check.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/remesh_arguments.hpp"
#include "tools/remesh_tetrahedra.hpp"
#include "tools/remesh_tile.hpp"
#include "tools/surface_json.hpp"
#include "tools/surface_paths.hpp"
#include "tools/warnings.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

void add_options(CLI::App& command, RemeshArguments& a) {
  const auto length =
      number([](double l) { return l > 0 && std::isfinite(l); }, "above 0, for instance 0.02", "L");
  add_surface_paths(command, a.input, a.output);
  auto* target = command.add_option_group("Targets", "give one: the edge length");
  target->add_option("--length", a.length, "edge length, in the units of the file")->check(length);
  target
      ->add_option("--relative-length", a.relative_length,
                   "edge length, relative to the diagonal of the bounding box")
      ->check(length);
  target->require_option(1);
  command.add_option("--max-faces", a.options.max_faces, "refuse a length that makes more faces than this")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--iterations", a.options.iterations, "rounds of split, collapse, swap and smoothing")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option(
          "--feature-angle", a.feature_angle,
          "edges at which the surface bends by this or more, in degrees, are kept as curves; in a tile, "
          "points where interfaces and the boundary bend by this (default there: 20)")
      ->check(number([](double d) { return d > 0 && d <= 180; }, "in (0, 180], for instance 40", "DEGREES"));
  command.add_flag("--lock-seams", a.options.lock_seams, "keep texture seams as they are, edge by edge");
  command.add_flag("--lock-boundary", a.options.lock_boundary, "keep the boundary as it is, edge by edge");
  command.add_flag("--preserve-materials,!--no-preserve-materials", a.preserve_materials,
                   "keep borders between materials as curves (default: yes)");
  add_follow_paths(command, a.follow_paths);
  add_weld_options(command, a.weld);
  add_report_options(command, a.report, "with both surfaces in 3D and the measured errors");
  command.add_flag("--quiet", a.quiet, "print errors only");
#ifdef MULTIMESH_WITH_IMPROVE
  add_tetrahedra_options(command, a);
#endif
  auto* periodic = add_periodic_tile_options(command, a.periodic);
  add_tile_output_options(command, a.periodic);
  for (const char* other : {"--lock-seams", "--lock-boundary", "--weld",
#ifdef MULTIMESH_WITH_IMPROVE
                            "--lock-patch", "--lock-region", "--no-periodic",
#endif
                            "--preserve-materials"})
    periodic->excludes(command.get_option(other));
}

void check_paths(const RemeshArguments& a) {
  check_surface_output(a.output);
  if (!a.report.html.empty() &&
      std::filesystem::weakly_canonical(a.input) == std::filesystem::weakly_canonical(a.output))
    throw InputError(a.output +
                     ": would replace the input, with which it is to be compared; choose another name");
}

void check_faces(const RemeshArguments& a, const TexturedSurface& surface) {
  const double faces = expected_faces(surface, a.options.length),
               most = static_cast<double>(a.options.max_faces);
  if (!(faces > most)) return;
  std::ostringstream text;
  text << a.input << ": edges of length " << a.options.length << " make about " << faces
       << " faces, more than " << a.options.max_faces << "; give a length of at least "
       << a.options.length * std::sqrt(faces / most) << ", or a greater --max-faces";
  throw InputError(text.str());
}

}  // namespace

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
  j["shortest_edge"] = r.shortest;
  j["longest_edge"] = r.longest;
  j["length_reached"] = length_reached(r, a.options.length);
  j["seconds"] = r.seconds;
  return j;
}

double percent_in_range(const RemeshResult& r) {
  return std::round(1000.0 * static_cast<double>(r.edges_in_range) / static_cast<double>(r.edges)) / 10;
}

void warn_of_lengths(const RemeshArguments& a, const RemeshResult& r, std::vector<std::string>& warnings) {
  if (length_reached(r, a.options.length)) return;
  std::ostringstream text;
  text << "the length was not reached everywhere: " << percent_in_range(r)
       << " % of the edges are within 4/5 and 4/3 of " << a.options.length << ", the shortest is "
       << r.shortest << ", the longest " << r.longest
       << "; curves and fixed vertices are closer together than that, or more --iterations are needed";
  warnings.push_back(text.str());
}

namespace {

/// Compares with the input, which is read again.
void show(const RemeshArguments& a, const TexturedSurface& surface, RunReport& report) {
  const files::SurfaceFile input = files::read_surface(a.input, {a.weld, a.follow_paths});
  std::vector<Index> source;
  TexturedTriangles remeshed = surface.triangles(source);
  SurfaceComparison comparison =
      compare_surfaces(input.input, remeshed, {.topology = false, .per_vertex = true});
  HtmlMesh after = html_mesh(std::move(remeshed), source, input);
  after.caption = std::filesystem::path(a.output).filename().string();
  report.show(comparison_page(std::filesystem::path(a.input).filename().string() + ", remeshed",
                              html_mesh(input), std::move(after), std::move(comparison), report.json()));
}

void run(RemeshArguments& a, RunReport& report) {
  if (a.periodic.is_given()) return remesh_tile(a, report);
#ifdef MULTIMESH_WITH_IMPROVE
  if (remesh_if_tetrahedra(a, report)) return;
#endif
  check_paths(a);
  files::SurfaceFile file = files::read_surface(a.input, {a.weld, a.follow_paths});
  a.options.length =
      a.length > 0 ? a.length : a.relative_length * bounding_box_diagonal(file.input.positions);
  if (!(a.options.length > 0)) throw InputError(a.input + ": the surface has no extent; give --length");
  TexturedSurfaceOptions curves;
  if (a.feature_angle > 0) curves.feature_angle = a.feature_angle * std::numbers::pi / 180;
  curves.keep_label_borders = a.preserve_materials;
  TexturedSurface surface = files::take_surface(file, curves);
  check_faces(a, surface);
  Json before;
  if (report.wanted()) before = tools::to_json(surface);
  const SurfaceTopology topology = topology_of(surface);
  const RemeshResult result = remesh(surface, a.options);
  warn_of_lengths(a, result, file.warnings);
  add(write_if_same_mesh(a.output, topology, surface, file), file.warnings);
  if (report.wanted()) {
    report.json() = to_json(a, result);
    report.json()["before"] = before;
    report.json()["after"] = tools::to_json(surface);
    report.json()["options"].update(tools::to_json(a.weld));
    report.json()["welded"] = tools::to_json(file.weld);
  }
  if (report.wants_page()) show(a, surface, report);
  report.finish(file.warnings, a.quiet);
  if (a.quiet) return;
  std::cerr << topology.faces << " faces -> " << surface.live_triangles() << " in " << result.seconds
            << " s; " << percent_in_range(result) << " % of the edges are within 4/5 and 4/3 of "
            << a.options.length << '\n';
}

}  // namespace

void add_remesh_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "remesh", "Give all edges about the same length; texture seams and curves are kept.");
  auto a = std::make_shared<RemeshArguments>();
  add_options(*command, *a);
  command->footer(
      "Example:  multimesh remesh cow.obj -o even.obj --relative-length 0.01\n"
      "          multimesh remesh part.stl -o even.obj --length 2.5 --feature-angle 40\n"
      "          multimesh remesh rve.msh -o even.msh --length 0.05 --periodic xyz\n\n"
      "Kept: the topology of the surface and of every chart, the graph of the seams and of the\n"
      "curves, materials and groups of each face. Seams are not frozen: their edges get the same\n"
      "length. Vertices stay on the input, with its texture coordinates there. No triangle of the\n"
      "texture flips or loses its area. A warning, also in the report, says if less than 90 % of the\n"
      "edges are in range, or one is longer than twice the length or shorter than a quarter of it;\n"
      "the exit status is then still 0.");
  command->callback([a, command, &exit_code] {
    a->weld_given = command->count("--weld") > 0;
    a->uv_weld_given = command->count("--uv-weld") > 0;
#ifdef MULTIMESH_WITH_IMPROVE
    a->target_given = command->count("--target-amips") > 0;
#endif
    RunReport report(*command, a->report, {a->input}, {a->output});
    run(*a, report);
    exit_code = done;
  });
}

}  // namespace multimesh::tools
