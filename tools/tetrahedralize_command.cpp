// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "tools/command.hpp"
#include "tools/domain_arguments.hpp"
#include "tools/domain_json.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/warnings.hpp"
#ifdef MULTIMESH_WITH_TETGEN
#include "adapters/tetgen/missed_bounds.hpp"
#include "tools/fill_surface.hpp"
#endif
#ifdef MULTIMESH_WITH_IMPROVE
#include "multimesh/algorithms/improve.hpp"
#endif

namespace multimesh::tools {

#ifdef MULTIMESH_WITH_TETGEN

namespace {

struct TetrahedralizeArguments {
  std::string input, output;
  ReportOptions report;
  double feature_angle = 0, max_volume = 0, length = 0, relative_length = 0, ratio = 0, dihedral = 0;
  double minutes = 10, megabytes = 0, weld = 0;
  std::string keep = "winding";
  std::vector<std::string> regions, holes;
  files::DomainReadOptions taken;
  SimplexFormat format;
  bool split_surface = false, lock_surface = false;
};

constexpr const char* keep_names[] = {"winding", "even-odd", "all"};

tetgen::TetrahedralizeOptions tetgen_options(const TetrahedralizeArguments& a,
                                             const files::DomainFile& file) {
  tetgen::TetrahedralizeOptions o;
  o.keep = a.keep == "all"       ? tetgen::Keep::all
           : a.keep == "winding" ? tetgen::Keep::winding
                                 : tetgen::Keep::even_odd;
  for (const std::string& text : a.regions) o.regions.push_back(parse_region_seed(text));
  for (const std::string& text : a.holes) o.holes.push_back(parse_point(text, "--hole"));
  o.max_volume = a.max_volume;
  o.edge_length = a.length;
  if (a.relative_length > 0) {
    o.edge_length = a.relative_length * bounding_box_diagonal(files::triangles_of(file).positions);
  }
  o.radius_edge_ratio = a.ratio;
  o.min_dihedral = a.dihedral;
  o.split_surface = a.split_surface;
  o.time_limit = std::chrono::duration<double>(60 * a.minutes);
  o.memory_limit = static_cast<std::uint64_t>(std::min(a.megabytes, 1e9) * 1e6);
  return o;
}

/// Adds the names of regions and patches to the report.
void add_names(const std::vector<io::SimplexSoup::Group>& groups, Json& j) {
  for (const auto& g : groups) {
    if (g.dimension < 2) continue;
    for (Json& part : j[g.dimension == 3 ? "regions" : "patches"])
      if (part["tag"] == g.tag) part["name"] = g.name;
  }
}

/// TetGen takes the length as a volume; edges that are still longer are split here.
void split_longer(TetDomain& domain, double length, const TetrahedralizeArguments& a) {
#ifdef MULTIMESH_WITH_IMPROVE
  if (length > 0) split_long_edges(domain, length, {{.time_limit = 60 * a.minutes}, {}, a.lock_surface});
#else
  (void)domain, (void)length, (void)a;
#endif
}

/// Which of the requested sizes the mesh misses.
std::vector<std::string> missed(const TaggedTetrahedra& t, const tetgen::TetrahedralizeOptions& options) {
  return tetgen::missed_bounds({t.points, t.tets}, t.triangles, options);
}

/// The input's triangles, as they are filled.
HtmlMesh page_of(const files::DomainFile& file) {
  HtmlMesh page;
  page.surface = files::triangles_of(file);
  return page;
}

void run(TetrahedralizeArguments& a, RunReport& report) {
  check_output_path(a.output, {a.input}, a.format);
  const bool splits = a.split_surface || (!a.lock_surface && (a.length > 0 || a.relative_length > 0));
  a.taken.sides_stay = !splits;
  files::DomainFile file = files::read_domain(a.input, a.taken);
  TetDomainOptions options;
  if (a.feature_angle > 0) options.feature_angle = a.feature_angle * std::numbers::pi / 180;
  HtmlMesh page;
  if (report.wants_page()) page = page_of(file);
  const tetgen::TetrahedralizeOptions sizes = tetgen_options(a, file);
  const FilledSurface filled = fill_surface(file, sizes, a.weld);
  TetDomain domain(filled.tets, options);
  split_longer(domain, sizes.edge_length, a);
  DomainResult output(domain);
  add(missed(output.lists, sizes), file.warnings);
  add(files::warnings_of(domain.report()), file.warnings);
  Json& j = report.json();
  j = to_json(multimesh::report(domain, output.topology));
  add(write_if_same_mesh(a.output, topology_of(filled.tets), std::move(output), filled.groups,
                         {a.format.options(), {true, true, true}}),
      file.warnings);
  add_names(filled.groups.groups, j);
  if (report.wants_page()) show_domains(report, std::move(page), domain, a.input, a.output);
  if (!report.is_printed()) {
    std::cout << a.output << '\n';
    print_domain(j);
  }
  report.finish(file.warnings);
}

}  // namespace

namespace {

/// As a check of an option: says what is wrong with a text that `parse` rejects.
template <class Parse>
auto parsed_by(Parse parse) {
  return [parse](const std::string& text) -> std::string {
    try {
      parse(text);
      return {};
    } catch (const InputError& e) {
      return e.what();
    }
  };
}

void add_seed_options(CLI::App& command, TetrahedralizeArguments& a) {
  command
      .add_option("--region", a.regions,
                  "NAME:x,y,z: the region of this point has the name, or the tag if it is a number, and is "
                  "filled; once per region")
      ->check(parsed_by(parse_region_seed))
      ->allow_extra_args(false);
  command.add_option("--hole", a.holes, "x,y,z: the region of this point is left empty; once per hole")
      ->check(parsed_by([](const std::string& text) { return parse_point(text, "--hole"); }))
      ->allow_extra_args(false);
}

}  // namespace

void add_tetrahedralize_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "tetrahedralize", "Fill the volume that a surface encloses with tetrahedra, using TetGen.");
  auto a = std::make_shared<TetrahedralizeArguments>();
  command->add_option("IN", a->input, std::string("surface: ") + files::all_formats)->required();
  command->add_option("-o,--output", a->output, files::written_simplex_formats)->required();
  command
      ->add_option("--feature-angle", a->feature_angle,
                   "edges at which the surface bends by at least this become curves; degrees in (0, 180)")
      ->check(CLI::Range(1e-6, 180.0));
  auto* length =
      command
          ->add_option("--edge-length", a->length, "longest edge; also on the surface, unless that is locked")
          ->check(positive_number())
          ->group("Targets");
  command
      ->add_option("--relative-edge-length", a->relative_length,
                   "the same, relative to the bounding box's diagonal")
      ->check(positive_number())
      ->excludes(length)
      ->group("Targets");
  command->add_option("--max-volume", a->max_volume, "largest volume of a tetrahedron")
      ->check(positive_number())
      ->group("Targets");
  command
      ->add_option("--radius-edge-ratio", a->ratio,
                   "quality: largest ratio of circumradius to shortest edge; 2 is usual")
      ->check(CLI::Range(1.1, 1e6))
      ->group("Targets");
  command
      ->add_option("--min-dihedral", a->dihedral,
                   "quality: target for the smallest dihedral angle; degrees, at most 25")
      ->check(CLI::Range(0.0, 25.0))
      ->group("Targets");
  command
      ->add_option("--keep", a->keep, "regions to keep: winding number not 0, every other one, or all inside")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(keep_names), std::end(keep_names))))
      ->capture_default_str();
  add_seed_options(*command, *a);
  command->add_option("--weld", a->weld, "join points at most this far apart; a length")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  auto* split = command->add_flag("--split-surface", a->split_surface,
                                  "let TetGen put new points on the surface, for quality");
  command
      ->add_flag("--lock-surface", a->lock_surface,
                 "keep the surface's triangles, even if their edges are longer than --edge-length")
      ->excludes(split);
  command->add_option("--time-limit", a->minutes, "minutes")->check(positive_number())->capture_default_str();
  command->add_option("--memory-limit", a->megabytes, "of the process that TetGen runs in; megabytes")
      ->check(positive_number());
  add_periodic_option(*command, a->taken.no_periodic);
  add_format_options(*command, a->format);
  add_report_options(*command, a->report, "with the surface in 3D, before and after, and the numbers");
  add_old_json_flag(*command, a->report);
  command->footer(
      "The surface, with its tags (1 if it has none), and sharp curves are written as triangles and\n"
      "edges of the same file. TetGen is under the AGPL-3 and runs as a separate program. A surface\n"
      "that is open, not manifold or intersects itself is refused.");
  command->callback([a, command, &exit_code] {
    RunReport report(*command, a->report, {a->input}, {a->output});
    run(*a, report);
    exit_code = done;
  });
}

#else

void add_tetrahedralize_command(CLI::App& app, int&) {
  auto* command =
      app.add_subcommand("tetrahedralize", "Not in this build: configure with -DMULTIMESH_WITH_TETGEN=ON.");
  command->allow_extras();
  command->callback(
      [] { throw InputError("tetrahedralize: this build has no TetGen (-DMULTIMESH_WITH_TETGEN=ON)"); });
}

#endif

}  // namespace multimesh::tools
