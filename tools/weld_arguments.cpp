// SPDX-License-Identifier: BSD-3-Clause
#include "tools/weld_arguments.hpp"

#include <cmath>

#include "tools/number_check.hpp"

namespace multimesh::tools {

namespace {

/// The next power of ten, for instance 1e-05.
std::string rounded_up(double x) {
  Json text = std::pow(10.0, std::ceil(std::log10(x)));
  return text.dump();
}

}  // namespace

void add_weld_options(CLI::App& command, io::SurfaceWeldOptions& o) {
  const auto distance = [](const char* type) {
    return number([](double d) { return d >= 0 && std::isfinite(d); }, "0 or more, for instance 1e-6", type);
  };
  auto* weld = command.add_option("--weld", o.tolerance,
                                  "open edges: vertices as near as this are one, in the units of the file "
                                  "(default 0: those at equal coordinates)");
  weld->check(distance("DISTANCE"))->group("Vertices at one place");
  command.add_flag("!--no-weld", o.positions, "keep vertices at one place apart, as they are in the file")
      ->excludes(weld)
      ->group("Vertices at one place");
  command
      .add_option("--uv-weld", o.texcoord_tolerance,
                  "texture coordinates at one vertex as near as this are one; relative to their size above 1")
      ->check(distance("DISTANCE"))
      ->capture_default_str()
      ->group("Vertices at one place");
}

Json to_json(const io::SurfaceWeldOptions& o) {
  return {{"weld", o.positions ? Json(o.tolerance) : Json()}, {"uv_weld", o.texcoord_tolerance}};
}

Json to_json(const io::SurfaceWeldReport& r) {
  return {{"coincident_vertices", r.coincident},
          {"welded_vertices", r.welded},
          {"welded_without_need", r.redundant},
          {"faces_left_out_as_copies", r.copied_faces},
          {"blended_colors", r.blended_colors},
          {"welded_texcoords", r.texcoords},
          {"vertices_with_near_texcoords", r.near_texcoords}};
}

std::vector<std::string> weld_warnings(const io::SurfaceWeldReport& r, const io::SurfaceWeldOptions& o) {
  std::vector<std::string> w;
  const auto add = [&](std::size_t n, const std::string& what) {
    if (n > 0) w.push_back(std::to_string(n) + " " + what);
  };
  add(r.welded, std::string(o.tolerance > 0 ? "vertices as near as the tolerance to another one"
                                            : "vertices at exactly the place of another one") +
                    " are joined with it; --no-weld keeps them apart");
  add(r.copied_faces, "faces are copies of an earlier one at the same place; left out");
  add(r.blended_colors, "vertices are joined with one of another colour; they have the mean colour now");
  add(r.texcoords,
      "corners have texture coordinates that differ from others at their vertex by rounding only; "
      "they are joined");
  if (r.near_texcoords > r.textured_vertices / 100)  // a few are chance
    add(r.near_texcoords,
        "vertices have texture coordinates that are nearly equal, but seams; if they are meant "
        "to be equal, which hinders a run much, join them by --uv-weld " +
            rounded_up(r.near_texcoord_distance));
  return w;
}

}  // namespace multimesh::tools
