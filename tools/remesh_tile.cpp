// SPDX-License-Identifier: BSD-3-Clause
#include "tools/remesh_tile.hpp"

#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "adapters/io/naming.hpp"
#include "multimesh/algorithms/remesh_tile.hpp"
#ifdef MULTIMESH_WITH_IMPROVE
#include "multimesh/algorithms/remesh_domain.hpp"
#endif
#include "multimesh/error.hpp"
#include "tools/joined_check.hpp"
#include "tools/quality_json.hpp"
#include "tools/tile_page.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

/// Interfaces and curved sides are polygons of other edges afterwards.
constexpr double much_of_area = 1e-3;

void warn_of_length(const PeriodicDomain& domain, double length, std::vector<std::string>& warnings) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    LatticeVector unit{};
    unit[i] = 1;
    if (domain.lattice().is_periodic(static_cast<int>(i)))
      least = std::min(least, domain.lattice().shift(unit).norm());
  }
  if (3 * length <= least) return;
  std::ostringstream text;
  text << "the length is more than a third of the period " << least
       << ": three edges must remain along each period, so edges may be shorter";
  warnings.push_back(text.str());
}

struct Remeshed {
  TileRemeshResult surface;
  std::optional<ImproveResult> tetrahedra;
};

Remeshed run(PeriodicDomain& domain, TileSides sides, const RemeshArguments& a) {
  if (domain.tree().mesh(domain.tile()).dimension() == 2) {
    OptionCheck{a.input, false}.refuse(a.target_given, "--target-amips");
    return {remesh(domain, TileRemeshOptions{a.options, sides}), {}};
  }
#ifdef MULTIMESH_WITH_IMPROVE
  SurfaceRemeshOptions options{a.options};
  options.target_amips = a.target_amips;
  options.passes_at_end = passes_in_tile;
  options.max_growth = growth_in_tile;
  DomainRemeshResult r = remesh_walls(domain, sides, options);
  return {{r.surface, 0}, std::move(r.tetrahedra)};
#else
  throw InputError(a.input + ": is a tile of tetrahedra; this program was built without their improvement");
#endif
}

void warn(const RemeshArguments& a, const Remeshed& r, std::vector<std::string>& warnings) {
  warn_of_lengths(a, r.surface, warnings);
  add(dropped_from_sides(r.surface.dropped_listed), warnings);
  if (r.tetrahedra) warn_of_tetrahedra(*r.tetrahedra, a.target_amips, warnings);
}

}  // namespace

void remesh_tile(RemeshArguments& a, RunReport& report) {
  check_tile_outputs(a.input, a.output, a.format, a.periodic);
  if (a.feature_angle > 0) a.periodic.corner_angle = a.periodic.feature_angle = a.feature_angle;
  auto [file, domain] = read_periodic(a.input, a.periodic);
  a.options.length = a.length > 0 ? a.length : a.relative_length * domain.diagonal();
  warn_of_length(domain, a.options.length, file.warnings);
  const TileSides usual = domain.has_flat_sides() ? TileSides::flat : TileSides::free;
  const TileSides sides = requested_sides(a.periodic).value_or(usual);
  const TileTopology before = topology_of(domain);
  std::optional<TilePage> page;
  if (report.wants_page()) page.emplace(domain);
  Json tile_before, tile_after;
  if (report.wanted()) tile_before = to_json(domain, before);
  const Remeshed r = io::naming(a.input, [&] { return run(domain, sides, a); });
  warn(a, r, file.warnings);
  const TileTopology after = topology_of(domain);
  warn_of_sizes(r.tetrahedra ? "volume" : "area", before.sizes, after.sizes, much_of_area,
                "a smaller --length or --feature-angle", file.warnings);
  constexpr double any = std::numeric_limits<double>::infinity();
  add(write_tile_outputs(a.output, before, after, domain, file, a.format.options(), any, a.periodic),
      file.warnings);
  Json& j = report.json();
  j = to_json(a, r.surface);
  j["options"]["feature_angle_degrees"] = r.tetrahedra ? a.periodic.feature_angle : a.periodic.corner_angle;
  if (r.tetrahedra) j["tetrahedra"] = to_json(r.tetrahedra->after);
  if (report.wanted()) tile_after = to_json(domain, after);
  j["periodic"] = {{"sides", name_of(sides)}, {"before", tile_before}, {"after", tile_after}};
  if (page) page->show(report, domain, a.input, a.output);
  report.finish(file.warnings, a.quiet);
  if (a.quiet) return;
  std::cerr << file.tile.facets.size() << (r.tetrahedra ? " tetrahedra -> " : " faces -> ")
            << domain.tile_lists().facets.size() << " in " << report.seconds() << " s; "
            << percent_in_range(r.surface) << " % of the edges" << (r.tetrahedra ? " of the surface" : "")
            << " are within 4/5 and 4/3 of " << a.options.length << '\n';
}

}  // namespace multimesh::tools
