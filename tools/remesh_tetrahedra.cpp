// SPDX-License-Identifier: BSD-3-Clause
#include "tools/remesh_tetrahedra.hpp"

#ifdef MULTIMESH_WITH_IMPROVE

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "adapters/io/naming.hpp"
#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/remesh_domain.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "tools/domain_json.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/output_check.hpp"
#include "tools/quality_json.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

void refuse_options(const RemeshArguments& a, bool tetrahedra) {
  const OptionCheck check{a.input, tetrahedra};
  if (!tetrahedra) return check.refuse_tetrahedra_options(a);
  check.refuse(a.options.lock_seams, "--lock-seams");
  check.refuse(a.options.lock_boundary, "--lock-boundary (for tetrahedra: --lock-patch)");
  check.refuse(!a.preserve_materials, "--no-preserve-materials");
  check.refuse(a.follow_paths, "--follow-paths");
  check.refuse(a.uv_weld_given, "--uv-weld");
}

double diagonal(const TetDomain& domain) {
  std::vector<Vec3> points;
  for (Index v = 0; v < domain.mesh().capacity(0); ++v)
    if (domain.mesh().is_live(0, v)) points.push_back(domain.points()[v]);
  return bounding_box_diagonal(points);
}

DomainRemeshOptions options_of(const RemeshArguments& a, const files::DomainFile& file) {
  DomainRemeshOptions o;
  static_cast<RemeshOptions&>(o) = static_cast<const RemeshOptions&>(a.options);
  o.target_amips = a.target_amips;
  o.locked_patches = files::tags_of_patches(file, a.locked_patches, "--lock-patch");
  o.locked_regions = files::tags_of_groups(file, 3, a.locked_regions, "--lock-region");
  return o;
}

void run(RemeshArguments& a, files::DomainFile& file, RunReport& report) {
  check_output_path(a.output, {a.input}, a.format);
  TetDomainOptions curves;
  if (a.feature_angle > 0) curves.feature_angle = a.feature_angle * std::numbers::pi / 180;
  TetDomain domain = files::take_domain(file, curves);
  a.options.length = a.length > 0 ? a.length : a.relative_length * diagonal(domain);
  const DomainReport before = multimesh::report(domain);
  HtmlMesh page;
  if (report.wants_page()) page = html_mesh(domain);
  const DomainRemeshResult result = io::naming(a.input, [&] { return remesh(domain, options_of(a, file)); });
  DomainResult output(domain);
  const DomainReport after = multimesh::report(domain, output.topology);
  warn_of_lengths(a, result.surface, file.warnings);
  warn_of_tetrahedra(result.tetrahedra, a.target_amips, file.warnings);
  warn_of_sizes("volume", before.tets.volumes, after.tets.volumes, much_of_size, "a shorter length",
                file.warnings);
  warn_of_contact(output.lists, "a shorter length", file.warnings);
  const files::DomainWriteOptions how{a.format.options(), {false, a.feature_angle > 0, false}};
  add(write_if_same_mesh(a.output, before.tets, std::move(output), file.groups(), how, a.options.length),
      file.warnings);
  report.json() = to_json(a, result.surface);
  report.json()["before"] = to_json(before);
  report.json()["after"] = to_json(after);
  report.json()["tetrahedra"] = to_json(result.tetrahedra.after);
  if (report.wants_page()) show_domains(report, std::move(page), domain, a.input, a.output);
  report.finish(file.warnings, a.quiet);
  if (a.quiet) return;
  std::cerr << before.surface->faces << " faces of the surface -> " << after.surface->faces << ", "
            << before.tets.tets << " tetrahedra -> " << after.tets.tets << "; "
            << percent_in_range(result.surface) << " % of the edges are within 4/5 and 4/3 of "
            << a.options.length << "; AMIPS max " << result.tetrahedra.after.max_amips << '\n';
}

}  // namespace

bool remesh_if_tetrahedra(RemeshArguments& a, RunReport& report) {
  std::optional<files::DomainFile> file = read_tetrahedra(a.input, a, a.weld);
  refuse_options(a, file.has_value());
  if (file) run(a, *file, report);
  return file.has_value();
}

}  // namespace multimesh::tools

#endif
