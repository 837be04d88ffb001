// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/surface_file.hpp"
#include "tools/command.hpp"
#include "tools/comparison_json.hpp"
#include "tools/comparison_page.hpp"
#include "tools/follow_paths.hpp"
#include "tools/run_report.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

struct CompareArguments {
  std::string original, other;
  ReportOptions report;
  CompareOptions options;
  io::SurfaceWeldOptions weld;
  bool follow_paths = false;
};

/// Lines of a table: a name, then numbers in columns.
class Table {
 public:
  template <class... Cells>
  void line(const char* name, const Cells&... cells) {
    std::cout << "  " << std::left << std::setw(24) << name;
    (cell(cells), ...);
    std::cout << '\n';
  }

 private:
  template <class T>
  void cell(const T& value) {
    std::cout << std::right << std::setw(14) << value;
  }
};

void print_counts(Table& table, const CountedSurface& a, const CountedSurface& b) {
  table.line("", "original", "other");
  table.line("triangles", a.triangles, b.triangles);
  if (a.untextured + b.untextured > 0) table.line("without texture", a.untextured, b.untextured);
  table.line("flipped in texture", a.flipped, b.flipped);
  table.line("without area there", a.zero_area, b.zero_area);
  const SurfaceReport &x = *a.meshes, &y = *b.meshes;
  table.line("components", x.surface.components, y.surface.components);
  table.line("boundary loops", x.surface.boundary, y.surface.boundary);
  table.line("genus", x.surface.genus, y.surface.genus);
  const auto both = [&](const char* name, auto value) { table.line(name, value(x), value(y)); };
  both("charts", [](const SurfaceReport& r) { return r.texture ? r.texture->components : 0; });
  both("their boundary loops", [](const SurfaceReport& r) { return r.texture ? r.texture->boundary : 0; });
  both("seam edges", [](const SurfaceReport& r) { return r.seams ? r.seams->edges : 0; });
  both("seam ends", [](const SurfaceReport& r) { return r.seams ? r.seams->ends : 0; });
  both("seam junctions", [](const SurfaceReport& r) { return r.seams ? r.seams->junctions : 0; });
}

void print(const CompareArguments& a, const SurfaceComparison& c) {
  std::cout << "original: " << a.original << "\nother:    " << a.other << "\n\n" << std::setprecision(4);
  Table table;
  print_counts(table, c.original, c.other);
  std::cout << "\nrelative to the diagonal of the original's bounding box, " << c.diagonal << ":\n";
  table.line("", "rms", "mean", "95 %", "max");
  table.line("distance", c.rms, "", "", c.hausdorff);
  table.line("  other to original", c.to_original.rms, "", "", c.to_original.max);
  table.line("  original to other", c.from_original.rms, "", "", c.from_original.max);
  if (!c.texture) {
    std::cout << "\ntextures are not compared: "
              << (c.original.untextured == c.original.triangles ? "the original has none\n"
                                                                : "the other surface has none\n");
    return;
  }
  const TextureComparison& t = *c.texture;
  table.line("texture deviation", t.deviation.rms, t.deviation.mean, t.deviation.p95, t.deviation.max);
  table.line("seam crack", t.crack.rms, "", "", t.crack.max);
  std::cout << "\n";
  table.line("colours, PSNR in dB", t.color_psnr);
  table.line("outside of the texture", t.outside);
  table.line("  of its own chart", t.outside_own);
}

/// The counts of one side, in the form of the reports: of its meshes and of its triangles.
Json side(Json counts) {
  Json meshes = counts["meshes"];
  counts.erase("meshes");
  counts.update(meshes);
  return counts;
}

HtmlReport page_of(const files::SurfaceFile& original, const files::SurfaceFile& other,
                   const SurfaceComparison& comparison) {
  const Json j = to_json(comparison);
  return comparison_page(original.path.filename().string() + " and " + other.path.filename().string(),
                         html_mesh(original), html_mesh(other), comparison,
                         {{"before", side(j["original"])}, {"after", side(j["other"])}});
}

void run(const CompareArguments& a, RunReport& report) {
  const files::SurfaceReadOptions how{a.weld, a.follow_paths};
  const files::SurfaceFile original = files::read_surface(a.original, how),
                           other = files::read_surface(a.other, how);
  CompareOptions options = a.options;
  options.per_vertex = report.wants_page();
  const SurfaceComparison comparison = compare_surfaces(original.input, other.input, options);
  report.json() = {{"original_file", a.original}, {"other_file", a.other}, {"samples", a.options.samples}};
  report.json().update(to_json(comparison));
  if (report.wants_page()) report.show(page_of(original, other, comparison));
  if (!report.is_printed()) print(a, comparison);
  std::vector<std::string> warnings;
  for (const files::SurfaceFile* file : {&original, &other})
    for (const auto& w : file->warnings) warnings.push_back(file->path.string() + ": " + w);
  report.finish(warnings);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("compare", "How far a decimated surface, and its texture, are from the original.");
  auto a = std::make_shared<CompareArguments>();
  command->add_option("ORIGINAL", a->original, std::string("surface: ") + files::all_formats)->required();
  command->add_option("OTHER", a->other, "surface to compare, drawn with the original's texture image")
      ->required();
  command->add_option("--samples", a->options.samples, "points per surface")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 27))
      ->capture_default_str();
  command->add_option("--threads", a->options.threads, "0: one per core; the results do not depend on it")
      ->check(CLI::Range(0U, 1024U))
      ->capture_default_str();
  add_weld_options(*command, a->weld);
  add_report_options(*command, a->report, "with both surfaces in 3D and the measured errors");
  add_old_json_flag(*command, a->report);
  add_follow_paths(*command, a->follow_paths);
  command->footer(
      "Example:  multimesh compare cow.obj small.obj\n\n"
      "distance: between the surfaces, both ways. texture deviation: from a point to the place of the\n"
      "original whose texel it shows. seam crack: between the places shown at the two sides of a\n"
      "seam. colours: the difference seen if a smooth pattern is painted on the original. The exit\n"
      "status does not depend on how far apart they are.");
  command->callback([a, command, &exit_code] {
    RunReport report(*command, a->report, {a->original, a->other});
    run(*a, report);
    exit_code = done;
  });
}

}  // namespace multimesh::tools
