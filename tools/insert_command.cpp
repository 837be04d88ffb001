// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "tools/command.hpp"
#include "tools/run_report.hpp"
#if defined(MULTIMESH_WITH_TETGEN) && defined(MULTIMESH_WITH_EXACT)
#include "multimesh/algorithms/insert_domain.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/tetgen/delaunay.hpp"
#include "tools/domain_arguments.hpp"
#include "tools/domain_json.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/soup_of_files.hpp"
#include "tools/warnings.hpp"
#endif

namespace multimesh::tools {

#if defined(MULTIMESH_WITH_TETGEN) && defined(MULTIMESH_WITH_EXACT)

namespace {

struct InsertArguments {
  std::vector<std::string> inputs;
  std::string output;
  double grid = 0, relative_grid = 0.05, feature_angle = 0;
  std::size_t most_points = 0;
  bool separate = false, no_thinning = false, quiet = false;
  SimplexFormat format;
  ReportOptions report;
};

BackgroundMesh background_of(const TriangleSoup& soup, const InsertArguments& a) {
  std::vector<tetgen::Point> points(soup.points.begin(), soup.points.end());
  tetgen::DelaunayOptions options;
  options.grid_spacing = a.grid > 0 ? a.grid : a.relative_grid * bounding_box_diagonal(soup.points);
  options.triangles = soup.triangles;
  tetgen::DelaunayMesh made = tetgen::delaunay(points, options);
  return {std::move(made.points), std::move(made.tets), std::move(made.merged_to)};
}

/// One line each some seconds of a long run.
std::function<void(double)> progress_on_standard_error() {
  using Clock = std::chrono::steady_clock;
  return [last = Clock::now()](double share) mutable {
    if (Clock::now() - last < std::chrono::seconds(5)) return;
    last = Clock::now();
    std::cerr << "insert: " << static_cast<int>(100 * share) << " %\n";
  };
}

files::DomainGroups groups_of(const ArrangementLists& lists, const SoupOfFiles& input) {
  files::DomainGroups groups{input.patches, {}};
  groups.groups.push_back({3, 1, "outside"});
  for (const auto& overlap : lists.overlaps) groups.tag_sets.push_back({2, overlap.tag, overlap.labels});
  return groups;
}

Json insertion_json(const InsertReport& r, const Arrangement& a, const ArrangementLists& lists) {
  return {{"polygons", r.polygons},
          {"segments", r.segments},
          {"triangles_without_area", r.degenerate},
          {"faces", a.faces.size()},
          {"regions", lists.regions},
          {"points_in_faces", r.split_faces},
          {"points_on_edges", r.split_edges},
          {"points_in_planes", r.crossings},
          {"points_removed", r.removed},
          {"swapped_faces", r.swapped},
          {"largest_coordinate_bits", r.bits},
          {"points_between_doubles", r.exact_points},
          {"points_not_rounded", r.unrounded},
          {"inverted_by_rounding", lists.inverted}};
}

void warn(const Arrangement& a, const ArrangementLists& lists, std::vector<std::string>& warnings) {
  if (a.report.degenerate > 0)
    warnings.push_back(std::to_string(a.report.degenerate) +
                       " triangles have no area: their edges are inserted, and they have no faces");
  if (a.report.unrounded > 0)
    warnings.push_back(std::to_string(a.report.unrounded) +
                       " points cannot be rounded to doubles without inverting tetrahedra; in the file they "
                       "are, and " +
                       std::to_string(lists.inverted) + " tetrahedra are flat or inverted there");
}

/// The triangles as given.
HtmlMesh page_of(const TriangleSoup& soup) {
  HtmlMesh page;
  page.surface.positions = soup.points;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    auto& triangle = page.surface.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i].position = static_cast<std::int32_t>(soup.triangles.facet(t)[i]);
  }
  return page;
}

void run(InsertArguments& a, RunReport& report) {
  check_output_path(a.output, {a.inputs.begin(), a.inputs.end()}, a.format);
  SoupOfFiles input = read_soup(a.inputs);
  const BackgroundMesh background = background_of(input.soup, a);
  InsertOptions options;
  options.merge_coplanar = !a.separate;
  options.thin = !a.no_thinning;
  options.most_points = a.most_points;
  if (!a.quiet) options.progress = progress_on_standard_error();
  const Arrangement arrangement = insert(input.soup, background, options);
  const ArrangementLists lists = lists_of(arrangement, input.soup);
  warn(arrangement, lists, input.warnings);
  TetDomainOptions surfaces;
  surfaces.boundary = surfaces.interfaces = false;
  if (a.feature_angle > 0) surfaces.feature_angle = a.feature_angle * std::numbers::pi / 180;
  const TetDomain domain(lists.tets, surfaces);
  DomainResult result(domain);
  Json& j = report.json();
  j = to_json(multimesh::report(domain, result.topology));
  j["insertion"] = insertion_json(arrangement.report, arrangement, lists);
  add(write_if_same_mesh(a.output, topology_of(lists.tets), std::move(result), groups_of(lists, input),
                         {a.format.options(), {true, true, true}}),
      input.warnings);
  if (report.wants_page()) show_domains(report, page_of(input.soup), domain, a.inputs.front(), a.output);
  report.finish(input.warnings, a.quiet);
  if (a.quiet || report.is_printed()) return;
  std::cout << a.output << '\n';
  print_domain(j);
}

}  // namespace

void add_insert_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "insert", "Make the triangles of surfaces in any state faces of tetrahedra in a box, exactly.");
  auto a = std::make_shared<InsertArguments>();
  command
      ->add_option("IN", a->inputs,
                   std::string("surfaces, each group a patch of its own: ") + files::all_formats)
      ->required();
  command->add_option("-o,--output", a->output, files::written_simplex_formats)->required();
  auto* grid = command->add_option("--grid", a->grid, "distance of background points; a length")
                   ->check(positive_number())
                   ->group("Targets");
  command
      ->add_option("--relative-grid", a->relative_grid,
                   "the same, relative to the bounding box's diagonal; 0: none")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->excludes(grid)
      ->group("Targets");
  command
      ->add_option("--feature-angle", a->feature_angle,
                   "edges at which the surface bends by at least this become curves; degrees in (0, 180)")
      ->check(CLI::Range(1e-6, 180.0));
  command->add_flag("--keep-triangles", a->separate,
                    "insert the edges between exactly coplanar triangles too");
  command->add_flag("--no-thinning", a->no_thinning,
                    "leave points inside triangles and edges that are not needed any more");
  command->add_option("--max-points", a->most_points,
                      "give up at more new points than this; 0: 50 per triangle, and 200,000");
  command->add_flag("-q,--quiet", a->quiet, "print nothing but errors");
  add_format_options(*command, a->format);
  add_report_options(*command, a->report, "with the surface in 3D, before and after, and the numbers");
  command->footer(
      "Triangles may cross, touch, overlap, repeat, be open or run against each other. What they enclose or\n"
      "part becomes a region; region 1 is outside. Where they cross, curves are written as edges. TetGen\n"
      "(AGPL-3) makes the background, as a separate program.");
  command->callback([a, command, &exit_code] {
    RunReport report(*command, a->report, a->inputs, {a->output});
    run(*a, report);
    exit_code = done;
  });
}

#else

void add_insert_command(CLI::App& app, int&) {
  auto* command = app.add_subcommand(
      "insert", "Not in this build: configure with -DMULTIMESH_WITH_TETGEN=ON -DMULTIMESH_WITH_EXACT=ON.");
  command->allow_extras();
  command->callback([] {
    throw InputError(
        "insert: this build has no TetGen or no GMP (-DMULTIMESH_WITH_TETGEN=ON, -DMULTIMESH_WITH_EXACT=ON)");
  });
}

#endif

}  // namespace multimesh::tools
