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
#include "tools/domain_json.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/output_check.hpp"
#include "tools/quality_json.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

constexpr const char* group = "Tetrahedra";
/// Share of the volume of a region above which a change causes a warning.
constexpr double much_of_volume = 0.005;

void refuse_options(const RemeshArguments& a, bool tetrahedra) {
  const auto refuse = [&](bool given, const char* option) {
    if (given)
      throw InputError(
          a.input + ": " + option + " is for " +
          (tetrahedra ? "surfaces, and this is a mesh of tetrahedra" : "tetrahedra, and this is a surface"));
  };
  if (tetrahedra) {
    refuse(a.options.lock_seams, "--lock-seams");
    refuse(a.options.lock_boundary, "--lock-boundary (for tetrahedra: --lock-patch)");
    refuse(!a.preserve_materials, "--no-preserve-materials");
    refuse(a.follow_paths, "--follow-paths");
    refuse(a.uv_weld_given, "--uv-weld");
  } else {
    refuse(a.target_given, "--target-amips");
    refuse(!a.locked_patches.empty(), "--lock-patch");
    refuse(!a.locked_regions.empty(), "--lock-region");
    refuse(a.no_periodic, "--no-periodic");
    refuse(a.format.ascii, "--ascii");
    refuse(a.format.msh_2, "--msh2");
  }
}

double diagonal(const TetDomain& domain) {
  Eigen::AlignedBox3d box;
  for (Index v = 0; v < domain.mesh().capacity(0); ++v)
    if (domain.mesh().is_live(0, v)) box.extend(domain.points()[v]);
  return box.diagonal().norm();
}

DomainRemeshOptions options_of(const RemeshArguments& a, const files::DomainFile& file) {
  DomainRemeshOptions o;
  static_cast<RemeshOptions&>(o) = static_cast<const RemeshOptions&>(a.options);
  o.target_amips = a.target_amips;
  o.locked_patches = files::tags_of_patches(file, a.locked_patches, "--lock-patch");
  o.locked_regions = files::tags_of_groups(file, 3, a.locked_regions, "--lock-region");
  return o;
}

void warn_of_tetrahedra(const ImproveResult& r, double target, std::vector<std::string>& warnings) {
  if (r.target_reached) return;
  std::ostringstream text;
  text.precision(4);
  text << r.after.above_target << " tetrahedra have an AMIPS energy above " << target << ", the greatest is "
       << r.after.max_amips << "; improve, which may split edges of the surface, may do better";
  warnings.push_back(text.str());
}

void warn_of_volumes(const TetTopology& before, const TetTopology& after,
                     std::vector<std::string>& warnings) {
  for (const auto& [tag, volume] : before.volumes) {
    const auto now = after.volumes.find(tag);
    const double change = now == after.volumes.end() ? -1 : now->second / volume - 1;
    if (std::abs(change) <= much_of_volume) continue;
    std::ostringstream text;
    text.precision(2);
    text << "the volume of region " << tag << " has changed by " << 100 * change
         << " %; a shorter length keeps "
         << "it better";
    warnings.push_back(text.str());
  }
}

// Nothing prevents parts of the surface that are nearer to each other than the length from coming together.
void warn_of_contact(const TaggedTetrahedra& lists, std::vector<std::string>& warnings) {
  const std::size_t n = hanging_points(lists).size();
  if (n > 0)
    warnings.push_back("the surface touches itself: " + std::to_string(n) +
                       " points lie in the middle of an edge or a face of it; a shorter length keeps parts "
                       "of it apart");
}

void run(RemeshArguments& a, files::DomainFile& file, RunReport& report) {
  check_output_path(a.output, {a.input});
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
  warn_of_volumes(before.tets, after.tets, file.warnings);
  warn_of_contact(output.lists, file.warnings);
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

void add_tetrahedra_options(CLI::App& command, RemeshArguments& a) {
  command.add_option("--target-amips", a.target_amips, "AMIPS energy towards which tetrahedra are improved")
      ->check(CLI::Range(3.0, 1e9))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--lock-patch", a.locked_patches,
                  "patches whose triangles stay unchanged, by tags or names")
      ->group(group);
  command.add_option("--lock-region", a.locked_regions, "regions to leave unchanged, by their tags")
      ->group(group);
  add_periodic_option(command, a.no_periodic)->group(group);
  add_format_options(command, a.format, group);
}

bool remesh_if_tetrahedra(RemeshArguments& a, RunReport& report) {
  if (files::is_surface_format(a.input)) {
    refuse_options(a, false);
    return false;
  }
  files::DomainFile file = files::read_simplices(a.input);
  refuse_options(a, file.has_tetrahedra());
  if (!file.has_tetrahedra()) return false;
  prepare(file, {.weld = a.weld_given ? std::optional(a.weld.tolerance) : std::nullopt,
                 .no_weld = !a.weld.positions,
                 .no_periodic = a.no_periodic});
  run(a, file, report);
  return true;
}

}  // namespace multimesh::tools

#endif
