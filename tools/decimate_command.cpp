// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "multimesh/algorithms/texture_loss.hpp"
#include "multimesh/domains/turn_reversed.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/surface_file.hpp"
#include "tools/command.hpp"
#include "tools/comparison_json.hpp"
#include "tools/comparison_page.hpp"
#include "tools/decimate_report.hpp"
#include "tools/decimate_tetrahedra.hpp"
#include "tools/decimate_tile.hpp"
#include "tools/html_report.hpp"
#include "tools/joined_check.hpp"
#include "tools/output_check.hpp"
#include "tools/warnings.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

namespace fs = std::filesystem;

/// small.obj -> small.lod1.obj
fs::path level_path(const fs::path& output, std::size_t level) {
  fs::path path = output;
  path.replace_extension(".lod" + std::to_string(level) + output.extension().string());
  return path;
}

bool same_file(const fs::path& x, const fs::path& y) {
  std::error_code error;  // of a path that does not exist: it is no other file then
  return fs::weakly_canonical(x, error) == fs::weakly_canonical(y, error);
}

/// All files that may be written.
std::vector<std::string> outputs(const DecimateArguments& a) {
  std::vector<std::string> paths{a.output};
  for (std::size_t level = 1; level <= a.levels.size(); ++level)
    paths.push_back(level_path(a.output, level).string());
  return paths;
}

void check_paths(const DecimateArguments& a) {
  check_surface_output(a.output);
  for (std::size_t level = 1; level <= a.levels.size(); ++level) {
    const fs::path path = level_path(a.output, level);
    check_output_path(path, {});
    if (same_file(path, a.input))
      throw InputError(path.string() +
                       ": a level would replace the input; choose another name for the output");
  }
  if ((a.measure || !a.report.html.empty()) && same_file(a.input, a.output))
    throw InputError(a.output +
                     ": would replace the input, with which it is to be compared; choose another name");
}

/// State of the whole run, for the reports.
class Run {
 public:
  Run(const DecimateArguments& a, RunReport& report)
      : a_(a),
        report_(report),
        file_(files::read_surface(a.input, {a.weld, a.follow_paths})),
        options_(decimate_options(a, file_.input.triangles.size())) {}

  void decimate();
  void check_texture();
  void finish();

 private:
  bool wants_comparison() const { return report_.wanted() && (a_.measure || report_.wants_page()); }
  bool wants_texture_check() const {
    return (!a_.quiet || report_.wanted()) && may_have_lost_texture(options_, result_);
  }
  void write_level(const TexturedSurface& surface, std::size_t level);
  void fill_report();
  void measure(Json& j);

  const DecimateArguments& a_;
  RunReport& report_;
  files::SurfaceFile file_;
  DecimateOptions options_;
  SurfaceTopology topology_;  ///< before
  DecimateResult result_;
  Json before_, after_, levels_ = Json::array(), texture_loss_;
  double seconds_ = 0;
  // For a page, a measurement or a check only.
  TexturedTriangles left_;
  std::vector<Index> source_;
};

void Run::write_level(const TexturedSurface& surface, std::size_t level) {
  const fs::path path = level_path(a_.output, level + 1);
  (void)write_if_same_mesh(path, topology_, surface, file_);  // warnings are the same as for the last one
  levels_.push_back({{"output", path.string()}, {"faces", surface.live_triangles()}});
}

void Run::decimate() {
  TexturedSurface surface = files::take_surface(file_, surface_options(a_));
  topology_ = topology_of(surface);
  if (report_.wanted()) before_ = to_json(surface);
  const bool show = !a_.quiet && isatty(STDERR_FILENO);
  if (show)
    options_.progress = [](std::size_t faces) { std::cerr << "\r" << faces << " faces   " << std::flush; };
  options_.on_level = [&](std::size_t level) { write_level(surface, level); };
  result_ = multimesh::decimate(surface, options_);
  if (show) std::cerr << "\r";
  add(write_if_same_mesh(a_.output, topology_, surface, file_), file_.warnings);
  if (report_.wanted()) after_ = to_json(surface);
  if (wants_comparison() || wants_texture_check()) left_ = surface.triangles(source_);
  seconds_ = report_.seconds();
}

/// Reports whether the texture was lost, and when.
void Run::check_texture() {
  if (!wants_texture_check()) return;
  files::SurfaceFile input = files::read_surface(a_.input);
  (void)turn_reversed(TexturedSurface(input.input), input.input);
  const auto loss = find_texture_loss(input.input, surface_options(a_), options_, result_, left_);
  if (!loss) return;
  texture_loss_ = to_json(*loss);
  file_.warnings.push_back(in_words(*loss, result_));
}

/// Compares with the input, which is read again: its memory was not kept during decimation.
void Run::measure(Json& j) {
  const files::SurfaceFile input = files::read_surface(a_.input, {a_.weld, a_.follow_paths});
  SurfaceComparison comparison =
      compare_surfaces(input.input, left_, {.topology = false, .per_vertex = report_.wants_page()});
  const Json measured = to_json(comparison);
  j["measured"] = {{"distance", measured["distance"]}, {"texture", measured["texture"]}};
  if (!report_.wants_page()) return;
  HtmlMesh after = html_mesh(std::move(left_), source_, input);
  after.caption = fs::path(a_.output).filename().string();
  Json numbers = j;
  numbers.erase("measured");
  report_.show(comparison_page(fs::path(a_.input).filename().string() + ", decimated", html_mesh(input),
                               std::move(after), std::move(comparison), std::move(numbers)));
}

void Run::fill_report() {
  Json& j = report_.json();
  j = decimation_json(a_, options_, result_);
  j["outputs"] = {a_.output};
  for (const Json& level : levels_) j["outputs"].push_back(level["output"]);
  if (!levels_.empty()) j["levels"] = levels_;
  j["before"] = before_;
  j["after"] = after_;
  j["seconds"] = seconds_;
  j["options"].update(to_json(a_.weld));
  j["welded"] = to_json(file_.weld);
  if (!texture_loss_.is_null()) j["texture_loss"] = texture_loss_;
  if (wants_comparison()) measure(j);
}

void Run::finish() {
  warn_of_target(options_, result_, "faces", file_.warnings);
  if (report_.wanted()) fill_report();
  report_.finish(file_.warnings, a_.quiet);
  if (a_.quiet) return;
  std::cerr << result_.faces_before << " faces -> " << result_.faces_after << " in " << seconds_
            << " s; stopped by: " << to_string(result_.stop) << '\n';
}

}  // namespace

void add_decimate_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "decimate",
      "Reduce the number of faces; texture seams stay intact, and tetrahedra follow their surface.");
  auto a = std::make_shared<DecimateArguments>();
  add_options(*command, *a);
#ifdef MULTIMESH_WITH_IMPROVE
  add_tetrahedra_options(*command, *a);
  add_tile_options(*command, *a);
#endif
  command->footer(
      "Example:  multimesh decimate cow.obj -o small.obj --ratio 0.1 --report report.json\n"
      "          multimesh decimate cow.obj -o small.obj --levels 0.5,0.25,0.1 --report-html cow.html\n"
      "          multimesh decimate rve.msh -o coarse.msh --periodic xyz --ratio 0.3\n\n"
      "Kept: the topology of the surface and of every chart, the graph of the seams, materials and\n"
      "groups of each face. No triangle of the texture flips or loses its area. Polygons become\n"
      "triangles; normals are recomputed if the input has any. If topology does not allow the target,\n"
      "the file is written with as few faces as it allows; a warning says what prevents fewer, and\n"
      "the report counts the reasons.\n\n"
      "Of tetrahedra the surface is decimated: boundary, interfaces and listed triangles. All\n"
      "tetrahedra stay of positive volume; regions, patches and curves are kept. In a periodic tile\n"
      "they are improved at the end, with the surface as it is then.");
  command->callback([a, command, &exit_code] {
    exit_code = done;
#ifdef MULTIMESH_WITH_IMPROVE
    a->weld_given = command->count("--weld") > 0;
    a->target_given = command->count("--target-amips") > 0;
    if (a->periodic.is_given()) return decimate_tile(*command, *a);
    if (decimate_if_tetrahedra(*command, *a)) return;
#endif
    check_paths(*a);
    RunReport report(*command, a->report, {a->input}, outputs(*a));
    Run run(*a, report);
    run.decimate();
    run.check_texture();
    run.finish();
  });
}

}  // namespace multimesh::tools
