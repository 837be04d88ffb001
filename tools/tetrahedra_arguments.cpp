// SPDX-License-Identifier: BSD-3-Clause
#include "tools/tetrahedra_arguments.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"

namespace multimesh::tools {

namespace {

constexpr const char* group = "Tetrahedra";

}  // namespace

void add_tetrahedra_options(CLI::App& command, TetrahedraArguments& a) {
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

void OptionCheck::refuse(bool given, const char* option) const {
  if (!given) return;
  throw InputError(
      input + ": " + option + " is for " +
      (tetrahedra ? "surfaces, and this is a mesh of tetrahedra" : "tetrahedra, and this is a surface"));
}

void OptionCheck::refuse_tetrahedra_options(const TetrahedraArguments& a) const {
  refuse(a.target_given, "--target-amips");
  refuse(!a.locked_patches.empty(), "--lock-patch");
  refuse(!a.locked_regions.empty(), "--lock-region");
  refuse(a.no_periodic, "--no-periodic");
  refuse(a.format.ascii, "--ascii");
  refuse(a.format.msh_2, "--msh2");
  refuse(a.format.order != 1, "--order");
}

std::optional<files::DomainFile> read_tetrahedra(const std::string& input, const TetrahedraArguments& a,
                                                 const io::SurfaceWeldOptions& weld) {
  if (files::is_surface_format(input)) return std::nullopt;
  files::DomainFile file = files::read_simplices(input);
  if (!file.has_tetrahedra()) return std::nullopt;
  prepare(file, {.weld = a.weld_given ? std::optional(weld.tolerance) : std::nullopt,
                 .no_weld = !weld.positions,
                 .no_periodic = a.no_periodic});
  return file;
}

void warn_of_tetrahedra(const ImproveResult& r, double target, std::vector<std::string>& warnings) {
  if (r.target_reached) return;
  std::ostringstream text;
  text.precision(4);
  text << r.after.above_target << " tetrahedra have an AMIPS energy above " << target << ", the greatest is "
       << r.after.max_amips << "; improve, which may split edges of the surface, may do better";
  warnings.push_back(text.str());
}

// Nothing prevents parts of the surface that are near each other from coming together.
void warn_of_contact(const TaggedTetrahedra& lists, const std::string& remedy,
                     std::vector<std::string>& warnings) {
  const std::size_t n = hanging_points(lists).size();
  if (n > 0)
    warnings.push_back("the surface touches itself: " + std::to_string(n) +
                       " points lie in the middle of an edge or a face of it; " + remedy +
                       " keeps parts of it apart");
}

}  // namespace multimesh::tools
