// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>

#include "adapters/io/atomic_file.hpp"
#include "adapters/io/output_path.hpp"
#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/error.hpp"
#include "multimesh/version.hpp"
#include "tools/command.hpp"
#include "tools/surface_file.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

namespace {

struct DecimateArguments {
  std::string input, output, report, cost = "quadric";
  double ratio = 0, max_error = 0;
  std::size_t faces = 0;
  bool quiet = false;
  CLI::Option *ratio_given = nullptr, *faces_given = nullptr, *error_given = nullptr;
};

DecimateOptions options_of(const DecimateArguments& a, std::size_t faces) {
  DecimateOptions o;
  o.cost = a.cost == "length" ? DecimateCost::length : DecimateCost::quadric;
  if (*a.ratio_given)
    o.faces = std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(a.ratio * double(faces))));
  if (*a.faces_given) o.faces = a.faces;
  if (*a.error_given) o.max_error = a.max_error;
  return o;
}

const char* to_string(DecimateResult::Stop stop) {
  switch (stop) {
    case DecimateResult::Stop::faces:
      return "target number of faces";
    case DecimateResult::Stop::bound:
      return "maximal error";
    case DecimateResult::Stop::exhausted:
      return "no edge left that may be collapsed";
  }
  return "?";
}

Json counts(const std::vector<RefusalCount>& list) {
  Json j = Json::object();
  for (const auto& [reason, count] : list) j[reason] = count;
  return j;
}

void write_report(const DecimateArguments& a, const DecimateOptions& o, const DecimateResult& r,
                  const Json& before, const Json& after, double seconds,
                  const std::vector<std::string>& warnings) {
  Json j;
  j["program"] = std::string("multimesh ") + version;
  j["input"] = a.input;
  j["output"] = a.output;
  j["options"] = {{"cost", a.cost}};
  if (o.faces > 0) j["options"]["target_faces"] = o.faces;
  if (std::isfinite(o.max_error)) j["options"]["max_error"] = o.max_error;
  j["faces"] = {{"before", r.faces_before}, {"after", r.faces_after}};
  j["target_reached"] = r.stop != DecimateResult::Stop::exhausted || o.faces == 0;
  j["stopped_by"] = to_string(r.stop);
  if (!r.blocking.empty()) j["edges_left_by_what_keeps_them"] = counts(r.blocking);
  j["collapses"] = {
      {"tried", r.tried}, {"done", r.collapsed}, {"refused", counts(r.refused)}, {"seconds", r.seconds}};
  j["max_cost"] = r.max_cost;
  j["before"] = before;
  j["after"] = after;
  j["seconds"] = seconds;
  j["warnings"] = warnings;
  io::AtomicFile file(a.report);
  file.write(to_text(j));
  file.commit();
}

/// What can be known to go wrong before the work is done. \throw InputError
void check_paths(const DecimateArguments& a) {
  namespace fs = std::filesystem;
  (void)io::checked_output_path(a.output);
  const std::string extension = fs::path(a.output).extension().string();
  if (extension != ".obj" && extension != ".OBJ")
    throw InputError(a.output + ": only OBJ files are written; give a name that ends in .obj");
  if (a.report.empty()) return;
  (void)io::checked_output_path(a.report);
  std::error_code error;  // of a path that does not exist: it is no mesh then
  const fs::path report = fs::weakly_canonical(a.report, error);
  for (const std::string& mesh : {a.input, a.output})
    if (report == fs::weakly_canonical(mesh, error))
      throw InputError(a.report + ": the report would replace the mesh " + mesh + "; choose another name");
}

void run(const DecimateArguments& a) {
  const auto start = std::chrono::steady_clock::now();
  check_paths(a);
  SurfaceFile file = read_surface(a.input);
  TexturedSurface surface(file.input);
  const Json before = to_json(surface);

  DecimateOptions options = options_of(a, file.input.triangles.size());
  const bool show = !a.quiet && isatty(STDERR_FILENO);
  if (show)
    options.progress = [](std::size_t faces) { std::cerr << "\r" << faces << " faces   " << std::flush; };
  const DecimateResult result = decimate(surface, options);
  if (show) std::cerr << "\r";

  write_surface(a.output, surface, file, file.warnings);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!a.report.empty()) write_report(a, options, result, before, to_json(surface), seconds, file.warnings);
  if (a.quiet) return;
  for (const auto& w : file.warnings) std::cerr << "warning: " << w << '\n';
  std::cerr << result.faces_before << " faces -> " << result.faces_after << " in " << seconds
            << " s; stopped by: " << to_string(result.stop) << '\n';
  if (result.stop == DecimateResult::Stop::exhausted && options.faces > 0) {
    std::cerr << "warning: the target of " << options.faces
              << " faces cannot be reached. Edges left, by what keeps them:";
    for (const auto& [reason, count] : result.blocking) std::cerr << ' ' << reason << ' ' << count << ';';
    std::cerr << '\n';
  }
}

/// A number for which `holds`; else the message says what it must be.
CLI::Validator number(bool (*holds)(double), const std::string& must_be, const std::string& type) {
  const auto check = [=](std::string& s) {
    double x = 0;
    return CLI::detail::lexical_cast(s, x) && holds(x) ? std::string() : "must be " + must_be;
  };
  return CLI::Validator(check, type);
}

}  // namespace

void add_decimate_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("decimate", "Reduce the number of faces; texture seams stay intact.");
  auto a = std::make_shared<DecimateArguments>();
  command->add_option("IN", a->input, "textured OBJ (or PLY) file")->required();
  command->add_option("-o,--output", a->output, "OBJ file to write")->required();
  auto* targets = command->add_option_group("target", "exactly one");
  a->ratio_given =
      targets->add_option("--ratio", a->ratio, "share of the faces to keep, in (0, 1]")
          ->check(number([](double r) { return r > 0 && r <= 1; }, "in (0, 1], for instance 0.1", "R"));
  a->faces_given = targets->add_option("--faces", a->faces, "number of faces to keep")
                       ->check(number([](double n) { return n >= 1; }, "a whole number above 0", "N"));
  a->error_given =
      targets
          ->add_option(
              "--max-error", a->max_error,
              "largest cost of a collapse, relative to the diagonal of the bounding box (0.001 = 0.1%)")
          ->check(
              number([](double e) { return e > 0 && std::isfinite(e); }, "above 0, for instance 0.001", "E"));
  targets->require_option(1);
  command
      ->add_option("--cost", a->cost,
                   "what is collapsed first: quadric (distance to the planes merged so far) or "
                   "length (shortest edge)")
      ->check(CLI::IsMember({"quadric", "length"}))
      ->capture_default_str();
  command->add_option("--report", a->report, "write what was done, and what stood in the way, as JSON");
  command->add_flag("--quiet", a->quiet, "print errors only");
  command->footer(
      "Example:  multimesh decimate cow.obj -o small.obj --ratio 0.1 --report report.json\n\n"
      "Kept: the topology of the surface and of every chart, the graph of the seams, materials and groups of "
      "each\n"
      "face. No triangle of the texture flips or loses its area. Polygons become triangles; normals are left "
      "out.\n"
      "If topology does not allow the target, the file is written as small as it allows, a warning says what "
      "stands\n"
      "in the way, and the report counts it.");
  command->callback([a, &exit_code] {
    run(*a);
    exit_code = done;
  });
}

}  // namespace multimesh::tools
