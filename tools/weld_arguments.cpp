// SPDX-License-Identifier: BSD-3-Clause
#include "tools/weld_arguments.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/number_check.hpp"

namespace multimesh::tools {

void add_weld_options(CLI::App& command, io::SurfaceWeldOptions& o) {
  const auto distance = [](const char* type) {
    return number([](double d) { return d >= 0 && std::isfinite(d); }, "0 or more, for instance 1e-6", type);
  };
  auto* weld =
      command.add_option("--weld", o.tolerance,
                         "at open edges, join vertices at most this far apart, in the units of the file "
                         "(default 0: those at equal coordinates)");
  weld->check(distance("DISTANCE"))->group("Vertices at one place");
  command.add_flag("!--no-weld", o.positions, "keep vertices at one place separate, as in the file")
      ->excludes(weld)
      ->group("Vertices at one place");
  command
      .add_option(
          "--uv-weld", o.texcoord_tolerance,
          "join texture coordinates at one vertex at most this far apart; relative to their size above 1")
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

}  // namespace multimesh::tools
