// SPDX-License-Identifier: BSD-3-Clause
#include "tools/decimate_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "multimesh/error.hpp"
#include "tools/follow_paths.hpp"
#include "tools/number_check.hpp"
#include "tools/surface_paths.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

CLI::Validator length() {
  return number([](double e) { return e > 0 && std::isfinite(e); }, "above 0, for instance 0.001", "E");
}
CLI::Validator weight() {
  return number([](double w) { return w >= 0 && std::isfinite(w); }, "0 or more", "W");
}

void add_targets(CLI::App& command, DecimateArguments& a) {
  auto* group = command.add_option_group("Targets", "at least one; the first that is met ends the run");
  auto* ratio =
      group->add_option("--ratio", a.ratio, "share of the faces to keep, in (0, 1]")
          ->check(number([](double r) { return r > 0 && r <= 1; }, "in (0, 1], for instance 0.1", "R"));
  group->add_option("--faces", a.faces, "number of faces to keep")
      ->check(number([](double n) { return n >= 1 && n == std::floor(n); }, "a whole number above 0", "N"))
      ->excludes(ratio);
  group
      ->add_option("--max-error", a.max_error,
                   "no point of the input is farther than this from the result, and no vertex of the result "
                   "from the input; relative to the diagonal of the bounding box (0.001 = 0.1%)")
      ->check(length());
  group
      ->add_option("--max-texture-error", a.max_texture_error,
                   "no vertex of the input is drawn farther than this from its place; relative as above")
      ->check(length());
  group
      ->add_option("--levels", a.levels,
                   "levels of detail written during the run: shares or numbers of faces, descending, "
                   "separated by commas. "
                   "Level i goes to OUT.lod<i>.obj, the last one or the target to OUT.obj")
      ->delimiter(',')
      ->check(
          number([](double r) { return r > 0 && std::isfinite(r); }, "above 0, for instance 0.5,0.25", "L"));
  group->require_option(1, 0);
}

void add_limits(CLI::App& command, DecimateArguments& a) {
  command.add_flag("--lock-boundary", a.lock_boundary, "keep the boundary as it is")->group("Limits");
  command.add_flag("--lock-seams", a.lock_seams, "keep seams as they are")->group("Limits");
  command
      .add_flag("--preserve-materials,!--no-preserve-materials", a.preserve_materials,
                "keep borders between materials as curves (default: yes)")
      ->group("Limits");
  command
      .add_option(
          "--feature-angle", a.feature_angle,
          "edges at which the surface bends by this or more, in degrees, are kept as curves; in a tile of "
          "triangles, points where interfaces and the boundary bend by this")
      ->check(number([](double d) { return d > 0 && d <= 180; }, "in (0, 180], for instance 40", "DEGREES"))
      ->group("Limits");
  command
      .add_option("--normal-deviation", a.normal_deviation,
                  "no normal deviates by more than this from those of the input's faces merged into its "
                  "face, in degrees")
      ->check(number([](double d) { return d > 0 && d <= 180; }, "in (0, 180], for instance 15", "DEGREES"))
      ->group("Limits");
  command
      .add_option("--aspect-ratio", a.aspect_ratio,
                  "no triangle's longest edge becomes more than this times its shortest height; default in a "
                  "tile: 10")
      ->check(number([](double r) { return r >= 1.155 && std::isfinite(r); },
                     "1.155 or more, for instance 20", "R"))
      ->group("Limits");
}

void add_weights(CLI::App& command, DecimateArguments& a) {
  const auto add = [&](const char* name, double& value, const char* text) {
    command.add_option(name, value, text)->check(weight())->capture_default_str()->group("Cost");
  };
  command
      .add_option(
          "--cost", a.cost,
          "what is collapsed first: quadric (deviation of shape and texture) or length (shortest edge)")
      ->check(CLI::IsMember({"quadric", "length"}))
      ->capture_default_str()
      ->group("Cost");
  add("--uv-weight", a.weights.uv_weight,
      "weight of misplaced texture relative to misplaced surface: 0 shape only, 1 texture first");
  add("--curve-weight", a.weights.curve_weight, "weight of boundaries, borders and sharp edges");
  add("--seam-weight", a.weights.seam_weight, "weight of the position of seams on the surface");
  add("--uv-curve-weight", a.weights.uv_curve_weight, "weight of the position of seams in the texture");
  add("--memory-weight", a.weights.memory_weight,
      "weight of the distance from the input's planes relative to that from the current surface");
}

}  // namespace

void add_options(CLI::App& command, DecimateArguments& a) {
  add_surface_paths(command, a.input, a.output);
  add_targets(command, a);
  add_limits(command, a);
  add_weights(command, a);
  add_follow_paths(command, a.follow_paths);
  add_weld_options(command, a.weld);
  add_report_options(command, a.report, "with both surfaces in 3D, their atlases and the measured errors");
  command.add_flag("--measure", a.measure, "measure the final distance and texture deviation, for --report")
      ->group("Reports");
  command.add_flag("--quiet", a.quiet, "print errors only");
}

TexturedSurfaceOptions surface_options(const DecimateArguments& a) {
  TexturedSurfaceOptions o;
  if (a.feature_angle > 0) o.feature_angle = a.feature_angle * std::numbers::pi / 180;
  o.keep_label_borders = a.preserve_materials;
  return o;
}

DecimateOptions decimate_options(const DecimateArguments& a, std::size_t faces) {
  const auto share = [&](double r) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(r * static_cast<double>(faces))));
  };
  DecimateOptions o = a.weights;
  o.cost = a.cost == "length" ? DecimateCost::length : DecimateCost::quadric;
  o.lock_boundary = a.lock_boundary;
  o.lock_seams = a.lock_seams;
  if (a.max_error > 0) o.max_error = a.max_error;
  if (a.max_texture_error > 0) o.max_texture_error = a.max_texture_error;
  if (a.normal_deviation > 0) o.max_normal_deviation = a.normal_deviation * std::numbers::pi / 180;
  if (a.aspect_ratio > 0) o.max_aspect_ratio = a.aspect_ratio;
  if (a.faces > 0) o.faces = a.faces;
  if (a.ratio > 0) o.faces = share(a.ratio);
  for (const double l : a.levels) o.levels.push_back(l <= 1 ? share(l) : static_cast<std::size_t>(l));
  if (!o.levels.empty() && o.faces == 0 && a.max_error == 0 && a.max_texture_error == 0) {
    o.faces = o.levels.back();
    o.levels.pop_back();
  }
  for (std::size_t i = 0; i < o.levels.size(); ++i)
    if (o.levels[i] <= (i + 1 < o.levels.size() ? o.levels[i + 1] : o.faces))
      throw InputError("--levels must descend, and end above the target: level " + std::to_string(i + 1) +
                       " is " + std::to_string(o.levels[i]) + " faces");
  return o;
}

}  // namespace multimesh::tools
