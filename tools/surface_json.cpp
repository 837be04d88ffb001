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

Json to_json(const TexturedSurface& surface) {
  Json j;
  j["surface"] = to_json(report(surface.tree().mesh(NodeId::root)));
  j["texture"] = nullptr;
  j["seams"] = nullptr;
  if (surface.texture()) {
    j["texture"] = to_json(report(surface.tree().mesh(*surface.texture())));
    j["texture"]["charts"] = j["texture"]["components"];
  }
  if (surface.seams()) {
    const SeamReport s = report_seams(surface);
    j["seams"] = {{"edges", s.edges}, {"curves", s.curves}, {"ends", s.ends}, {"junctions", s.junctions}};
  }
  return j;
}

std::string to_text(const Json& j) {
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace multimesh::tools
