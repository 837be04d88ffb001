// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surface_json.hpp"

namespace multimesh::tools {

Json to_json(const MeshReport& r) {
  Json j{{"vertices", r.vertices}, {"edges", r.edges}};
  if (r.dimension == 2) j["faces"] = r.faces;
  j["components"] = r.components;
  j["euler_characteristic"] = r.euler_characteristic;
  j[r.dimension == 2 ? "boundary_loops" : "end_points"] = r.boundary;
  if (r.dimension == 2) j["genus"] = r.genus;
  return j;
}

Json to_json(const SurfaceReport& r) {
  Json j;
  j["surface"] = to_json(r.surface);
  j["texture"] = nullptr;
  j["seams"] = nullptr;
  if (r.texture) {
    j["texture"] = to_json(*r.texture);
    j["texture"]["charts"] = r.texture->components;
  }
  if (r.seams)
    j["seams"] = {{"edges", r.seams->edges},
                  {"curves", r.seams->curves},
                  {"ends", r.seams->ends},
                  {"junctions", r.seams->junctions}};
  return j;
}

Json to_json(const TexturedSurface& surface) {
  return to_json(report(surface));
}

std::string to_text(const Json& j) {
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace multimesh::tools
