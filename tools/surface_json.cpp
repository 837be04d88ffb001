// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surface_json.hpp"

#include <nlohmann/json.hpp>

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

Json to_json(const SurfaceTopology& t) {
  return {{"vertices", t.vertices},
          {"edges", t.edges},
          {"faces", t.faces},
          {"components", t.components},
          {"euler_characteristic", t.euler_characteristic},
          {"boundary_loops", t.boundary_loops},
          {"edges_with_three_or_more_faces", t.crowded_edges}};
}

namespace {

Json texture_json(const MeshReport& r) {
  Json j = to_json(r);
  j["charts"] = r.components;
  return j;
}

Json curves_json(const std::optional<CurveReport>& r) {
  if (!r) return nullptr;
  return {{"edges", r->edges}, {"curves", r->curves}, {"ends", r->ends}, {"junctions", r->junctions}};
}

}  // namespace

Json to_json(const SurfaceReport& r) {
  Json j;
  j["surface"] = to_json(r.surface);
  j["texture"] = r.texture ? texture_json(*r.texture) : Json();
  j["seams"] = curves_json(r.seams);
  j["features"] = curves_json(r.features);
  for (const UvSetReport& set : r.more_uv_sets)
    j["more_uv_sets"].push_back({{"texture", texture_json(set.texture)}, {"seams", curves_json(set.seams)}});
  return j;
}

Json to_json(const TexturedSurface& surface) {
  return to_json(report(surface));
}

std::string to_text(const Json& j) {
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace multimesh::tools
