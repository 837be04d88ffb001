// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/html_mesh.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// A page holds this many triangles. If both meshes have more, `before` is left out; if `after` alone has
/// more, both are. The page says so.
constexpr std::size_t max_html_triangles = 1'000'000;

/// Textures of a page, all files together; those beyond are left out, and the page says so.
constexpr std::size_t max_html_texture_bytes = std::size_t{64} << 20U;

/// An error of the mesh after, shown by colours.
struct HtmlError {
  std::string name;  ///< `Distance`, for instance
  /// Per position of `after`, at least 0 and relative to the bounding-box diagonal (0.01 = 1 %).
  std::vector<double> values;
};

/// How many elements of each mesh have a quality between two bounds.
struct HtmlHistogram {
  std::string name;
  std::vector<double> bounds;  ///< one more than there are bins
  std::vector<std::size_t> before, after;
};

/// Two meshes side by side, or one, and numbers.
struct HtmlReport {
  std::string title;
  HtmlMesh before = {};  ///< without triangles: there is only one mesh
  HtmlMesh after = {};
  std::vector<HtmlError> errors = {};
  std::vector<HtmlHistogram> histograms = {};
  std::vector<Vec3> periods = {};  ///< if the meshes are tiles: the page can repeat them, two along each
  /// Shown as tables. Known fields: `before` and `after`, as made by to_json for a surface; `comparison`;
  /// `seconds`, `stopped_by`, `warnings`. All others are shown by their names.
  Json numbers = Json::object();
};

/// False in a build without the viewer (MULTIMESH_WITH_VIEWER).
bool can_write_html_report();

/// \throw InputError saying how to get the viewer, in a build without it. Programs should call it before the
/// work.
void require_html_report();

/// Writes one file that needs nothing else: three.js, meshes and textures are in it. Complete or not at all.
/// \return the notes on the page: what it does not show, and why.
/// \throw InputError if it cannot be written, or as require_html_report(). \throw UsageError for an error or
/// a material list of the wrong length, or an error that is not a number.
std::vector<std::string> write_html_report(const std::filesystem::path& path, const HtmlReport& report);

}  // namespace multimesh::tools
