// SPDX-License-Identifier: BSD-3-Clause
#include "tools/decimate_tetrahedra.hpp"

#ifdef MULTIMESH_WITH_IMPROVE

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "adapters/io/naming.hpp"
#include "multimesh/algorithms/decimate_domain.hpp"
#include "tools/decimate_report.hpp"
#include "tools/domain_json.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/output_check.hpp"
#include "tools/quality_json.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

/// Of the improvement at the end.
constexpr int passes = 40;
constexpr const char* remedy = "more faces, --max-error or --feature-angle";

void refuse_options(const CLI::App& command, const DecimateArguments& a, bool tetrahedra) {
  const OptionCheck check{a.input, tetrahedra};
  if (!tetrahedra) {
    check.refuse(a.improve, "--improve");
    return check.refuse_tetrahedra_options(a);
  }
  check.refuse(a.lock_boundary, "--lock-boundary (for tetrahedra: --lock-patch)");
  check.refuse(!a.preserve_materials, "--no-preserve-materials");
  for (const char* option :
       {"--lock-seams", "--max-texture-error", "--levels", "--uv-weight", "--seam-weight",
        "--uv-curve-weight", "--follow-paths", "--uv-weld", "--measure"})
    check.refuse(command.count(option) > 0, option);
}

DomainDecimateOptions options_of(const DecimateArguments& a, const files::DomainFile& file,
                                 std::size_t faces) {
  DomainDecimateOptions o;
  static_cast<DecimateOptions&>(o) = decimate_options(a, faces);
  o.target_amips = a.target_amips;
  o.passes_at_end = a.improve ? passes : 0;
  o.locked_patches = files::tags_of_patches(file, a.locked_patches, "--lock-patch");
  o.locked_regions = files::tags_of_groups(file, 3, a.locked_regions, "--lock-region");
  return o;
}

void run(const DecimateArguments& a, files::DomainFile& file, RunReport& report) {
  check_output_path(a.output, {a.input}, a.format);
  TetDomainOptions curves;
  if (a.feature_angle > 0) curves.feature_angle = a.feature_angle * std::numbers::pi / 180;
  TetDomain domain = files::take_domain(file, curves);
  const DomainReport before = multimesh::report(domain);
  HtmlMesh page;
  if (report.wants_page()) page = html_mesh(domain);
  const DomainDecimateOptions options = options_of(a, file, before.surface ? before.surface->faces : 0);
  const DomainDecimateResult result = io::naming(a.input, [&] { return decimate(domain, options); });
  DomainResult output(domain);
  const DomainReport after = multimesh::report(domain, output.topology);
  warn_of_target(options, result.surface, "faces of the surface", file.warnings);
  if (result.tetrahedra) warn_of_tetrahedra(*result.tetrahedra, a.target_amips, file.warnings);
  warn_of_sizes("volume", before.tets.volumes, after.tets.volumes, much_of_size, remedy, file.warnings);
  warn_of_contact(output.lists, remedy, file.warnings);
  const files::DomainWriteOptions how{a.format.options(), {false, a.feature_angle > 0, false}};
  constexpr double any = std::numeric_limits<double>::infinity();
  add(write_if_same_mesh(a.output, before.tets, std::move(output), file.groups(), how, any), file.warnings);
  Json& j = report.json();
  j = decimation_json(a, options, result.surface);
  j["before"] = to_json(before);
  j["after"] = to_json(after);
  j["tetrahedra"] = result.tetrahedra ? to_json(result.tetrahedra->after) : Json();
  if (report.wants_page()) show_domains(report, std::move(page), domain, a.input, a.output);
  report.finish(file.warnings, a.quiet);
  if (a.quiet) return;
  std::cerr << before.surface->faces << " faces of the surface -> " << after.surface->faces << ", "
            << before.tets.tets << " tetrahedra -> " << after.tets.tets
            << "; stopped by: " << to_string(result.surface.stop) << '\n';
}

}  // namespace

void add_tetrahedra_options(CLI::App& command, DecimateArguments& a) {
  command
      .add_flag("--improve", a.improve, "improve the tetrahedra at the end, with the surface as it is then")
      ->group("Tetrahedra");
  add_tetrahedra_options(command, static_cast<TetrahedraArguments&>(a));
}

bool decimate_if_tetrahedra(const CLI::App& command, const DecimateArguments& a) {
  std::optional<files::DomainFile> file = read_tetrahedra(a.input, a, a.weld);
  refuse_options(command, a, file.has_value());
  if (!file) return false;
  RunReport report(command, a.report, {a.input}, {a.output});
  run(a, *file, report);
  return true;
}

}  // namespace multimesh::tools

#endif
