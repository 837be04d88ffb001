// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "adapters/io/atomic_file.hpp"
#include "multimesh/error.hpp"
#include "multimesh/version.hpp"
#include "tools/html_blocks.hpp"
#include "tools/html_text.hpp"
#include "tools/html_textures.hpp"
#include "tools/viewer/viewer_bundle.hpp"

namespace multimesh::tools {

namespace {

/// Allows only scripts and styles of the page itself and embedded images, and nothing from elsewhere.
constexpr std::string_view head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
)";

void check(const HtmlReport& report) {
  for (const HtmlMesh* mesh : {&report.before, &report.after}) {
    const std::size_t triangles = mesh->surface.triangles.size();
    if (!mesh->material.empty() && mesh->material.size() != triangles)
      throw UsageError("HTML report: a mesh has " + std::to_string(triangles) + " triangles, but " +
                       std::to_string(mesh->material.size()) + " materials of triangles");
    if (std::ranges::any_of(mesh->material, [&](Index m) { return m >= mesh->materials.size(); }))
      throw UsageError("HTML report: a triangle has a material that is not in the list");
  }
  const std::size_t positions = report.after.surface.positions.size();
  for (const HtmlError& error : report.errors) {
    if (error.values.size() != positions)
      throw UsageError("HTML report: " + std::to_string(error.values.size()) + " values of " + error.name +
                       " for " + std::to_string(positions) + " positions");
    if (!std::ranges::all_of(error.values, [](double e) { return std::isfinite(e) && e >= 0; }))
      throw UsageError("HTML report: a value of " + error.name + " is negative or not a number");
  }
}

/// Which meshes the page contains; a note says which it does not.
struct Contents {
  bool before, after;
};

bool has_before(const HtmlReport& report) {
  return !report.before.surface.triangles.empty();
}

Contents contents(const HtmlReport& report, Json& notes) {
  const std::size_t after = report.after.surface.triangles.size();
  const std::size_t both = report.before.surface.triangles.size() + after;
  const std::string limit = "a page holds " + std::to_string(max_html_triangles) + " faces";
  if (after > max_html_triangles) {
    notes.push_back("The meshes are left out, for " + limit + ", and this one alone has " +
                    std::to_string(after) + ".");
    return {false, false};
  }
  if (both > max_html_triangles)
    notes.push_back("The mesh before is left out, for " + limit + ", and both have " + std::to_string(both) +
                    ".");
  return {has_before(report) && both <= max_html_triangles, true};
}

Json describe(const HtmlMesh& mesh, bool included, HtmlTextures& textures) {
  Json materials = Json::array();
  for (const files::Material& m : mesh.materials) {
    Json texture = nullptr;
    if (included && !m.texture.empty()) texture = textures.number(m.texture);
    materials.push_back({{"name", m.name}, {"color", m.color}, {"texture", texture}});
  }
  if (materials.empty())
    materials.push_back({{"name", ""}, {"color", files::Material().color}, {"texture", nullptr}});
  return {{"caption", mesh.caption},
          {"triangles", mesh.surface.triangles.size()},
          {"included", included},
          {"materials", std::move(materials)}};
}

void write_bundle(io::AtomicFile& file, std::span<const std::string_view> pieces) {
  for (const std::string_view piece : pieces) file.write(piece);
}

Json histograms(const HtmlReport& report) {
  Json all = Json::array();
  for (const HtmlHistogram& h : report.histograms)
    all.push_back({{"name", h.name}, {"bounds", h.bounds}, {"before", h.before}, {"after", h.after}});
  return all;
}

/// In the units of the meshes in the page.
Json periods(const HtmlReport& report) {
  const double size = common_frame(report.before.surface, report.after.surface).size;
  Json all = Json::array();
  for (const Vec3& v : report.periods) all.push_back({v[0] / size, v[1] / size, v[2] / size});
  return all;
}

Json write_page(io::AtomicFile& file, const HtmlReport& report, const ViewerBundle& bundle) {
  Json notes = Json::array();
  const Contents shown = contents(report, notes);
  HtmlTextures textures(max_html_texture_bytes);
  Json before = has_before(report) ? describe(report.before, shown.before, textures) : Json();
  Json meshes = {{"before", std::move(before)}, {"after", describe(report.after, shown.after, textures)}};
  std::vector<std::string> more = textures.notes();
  for (const HtmlMesh* mesh : {&report.before, &report.after})
    for (const std::string& note : mesh->notes)
      if (std::ranges::find(more, note) == more.end()) more.push_back(note);
  for (std::string& note : more) notes.push_back(std::move(note));

  file.write(head);
  file.write("<title>" + html_escaped(report.title) + "</title>\n<style>");
  write_bundle(file, bundle.style);
  file.write("</style>\n</head>\n<body>\n");
  write_bundle(file, bundle.page);
  Json errors = Json::array();
  for (const HtmlError& error : report.errors) errors.push_back(error.name);
  const Json all = {{"title", report.title},
                    {"generator", std::string("multimesh ") + version},
                    {"meshes", std::move(meshes)},
                    {"textures", textures.names()},
                    {"notes", notes},
                    {"errors", std::move(errors)},
                    {"histograms", histograms(report)},
                    {"periods", periods(report)},
                    {"numbers", report.numbers}};
  file.write("<script type=\"application/json\" id=\"report\">" + json_for_html(all) + "</script>\n");
  const HtmlFrame frame = common_frame(report.before.surface, report.after.surface);
  if (shown.before) write_blocks(file, "before", report.before, frame);
  if (shown.after) {
    write_blocks(file, "after", report.after, frame);
    for (std::size_t i = 0; i < report.errors.size(); ++i)
      write_numbers(file, "after-error-" + std::to_string(i), report.errors[i].values);
  }
  for (std::size_t i = 0; i < textures.uris().size(); ++i)
    write_block(file, "texture-" + std::to_string(i), textures.uris()[i]);
  file.write("<script>");
  write_bundle(file, bundle.script);
  file.write("</script>\n</body>\n</html>\n");
  return notes;
}

}  // namespace

bool can_write_html_report() {
  return viewer_bundle() != nullptr;
}

void require_html_report() {
  if (!can_write_html_report())
    throw InputError(
        "HTML reports: this multimesh was built without the viewer. Install Node.js with npm "
        "(scripts/setup-debian.sh does), and build with -DMULTIMESH_WITH_VIEWER=ON");
}

std::vector<std::string> write_html_report(const std::filesystem::path& path, const HtmlReport& report) {
  require_html_report();
  check(report);
  io::AtomicFile file(path);
  const Json notes = write_page(file, report, *viewer_bundle());
  file.commit();
  return notes.get<std::vector<std::string>>();
}

}  // namespace multimesh::tools
