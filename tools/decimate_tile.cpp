// SPDX-License-Identifier: BSD-3-Clause
#include "tools/decimate_tile.hpp"

#ifdef MULTIMESH_WITH_IMPROVE

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "adapters/io/naming.hpp"
#include "multimesh/algorithms/decimate_domain.hpp"
#include "tools/decimate_report.hpp"
#include "tools/quality_json.hpp"
#include "tools/tile_page.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

/// Tiles are for solvers: in them, without a limit, triangles come out that are nearly lines.
constexpr double usual_aspect_ratio = 10;

std::size_t count_faces(const Mesh& mesh) {
  std::size_t n = 0;
  for (Index f = 0; f < mesh.capacity(2); ++f) n += mesh.is_live(2, f);
  return n;
}

/// A tile of a file, to be decimated.
struct Task {
  DecimateArguments& a;
  files::TileFile file;
  PeriodicDomain domain;
  bool is_solid;
  TileSides sides;
  SurfaceDecimateOptions options;

  Task(DecimateArguments& arguments, ReadTile tile)
      : a(arguments),
        file(std::move(tile.file)),
        domain(std::move(tile.domain)),
        is_solid(domain.tree().mesh(domain.tile()).dimension() == 3),
        sides(requested_sides(a.periodic).value_or(TileSides::flat)) {
    const OptionCheck check{a.input, is_solid};
    if (!is_solid) check.refuse(a.improve, "--improve"), check.refuse(a.target_given, "--target-amips");
    const std::optional<NodeId> surface = is_solid ? domain.add_walls() : domain.tile();
    static_cast<DecimateOptions&>(options) =
        decimate_options(a, surface ? count_faces(domain.tree().mesh(*surface)) : 0);
    options.target_amips = a.target_amips;
    options.passes_at_end = passes_in_tile;
    options.max_growth = growth_in_tile;
    if (a.aspect_ratio == 0) options.max_aspect_ratio = usual_aspect_ratio;
  }

  std::size_t facets() const { return domain.tile_lists().facets.size(); }
};

PeriodicArguments& with_corners(DecimateArguments& a) {
  a.periodic.corner_angle = a.periodic.feature_angle = a.feature_angle > 0 ? a.feature_angle : 180;
  return a.periodic;
}

void run(Task task, RunReport& report) {
  auto& [a, file, domain, is_solid, sides, options] = task;
  const TileTopology before = topology_of(domain);
  std::optional<TilePage> page;
  if (report.wants_page()) page.emplace(domain);
  Json tile_before, tile_after;
  if (report.wanted()) tile_before = to_json(domain, before);
  const std::size_t facets = task.facets();
  const DomainDecimateResult r = io::naming(a.input, [&] { return decimate(domain, sides, options); });
  warn_of_target(options, r.surface, is_solid ? "faces of the surface" : "faces", file.warnings);
  if (r.tetrahedra) warn_of_tetrahedra(*r.tetrahedra, a.target_amips, file.warnings);
  const TileTopology after = topology_of(domain);
  warn_of_sizes(is_solid ? "volume" : "area", before.sizes, after.sizes, much_of_size,
                "more faces, --max-error or --feature-angle", file.warnings);
  constexpr double any = std::numeric_limits<double>::infinity();
  add(write_tile_outputs(a.output, before, after, domain, file, a.format.options(), any, a.periodic),
      file.warnings);
  Json& j = report.json();
  j = decimation_json(a, options, r.surface);
  j["facets"] = {{"before", facets}, {"after", task.facets()}};
  j["options"]["aspect_ratio"] = options.max_aspect_ratio;
  if (is_solid) j["tetrahedra"] = to_json(r.tetrahedra->after);
  if (report.wanted()) tile_after = to_json(domain, after);
  j["periodic"] = {{"sides", name_of(sides)}, {"before", tile_before}, {"after", tile_after}};
  if (page) page->show(report, domain, a.input, a.output);
  report.finish(file.warnings, a.quiet);
  if (a.quiet) return;
  std::cerr << r.surface.faces_before << " faces -> " << r.surface.faces_after;
  if (is_solid) std::cerr << ", " << facets << " tetrahedra -> " << task.facets();
  std::cerr << "; stopped by: " << to_string(r.surface.stop) << '\n';
}

}  // namespace

void add_tile_options(CLI::App& command, DecimateArguments& a) {
  auto* periodic = add_periodic_tile_options(command, a.periodic);
  add_tile_output_options(command, a.periodic);
  for (const char* other :
       {"--lock-boundary", "--lock-seams", "--max-texture-error", "--levels", "--preserve-materials",
        "--uv-weight", "--seam-weight", "--uv-curve-weight", "--follow-paths", "--weld", "--uv-weld",
        "--measure", "--lock-patch", "--lock-region", "--no-periodic"})
    periodic->excludes(command.get_option(other));
}

void decimate_tile(const CLI::App& command, DecimateArguments& a) {
  check_tile_outputs(a.input, a.output, a.format, a.periodic);
  RunReport report(command, a.report, {a.input}, {a.output});
  run(Task(a, read_periodic(a.input, with_corners(a))), report);
}

}  // namespace multimesh::tools

#endif
