// SPDX-License-Identifier: BSD-3-Clause
#include "tools/domain_json.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>

namespace multimesh::tools {

namespace {

template <class Counts>
Json tags_json(const Counts& counts, const char* what) {
  Json list = Json::array();
  for (const auto& [tag, n] : counts) list.push_back({{"tag", tag}, {what, n}});
  return list;
}

}  // namespace

Json to_json(const DomainReport& r) {
  Json j;
  const TetTopology& t = r.tets;
  j["tetrahedra"] = {{"vertices", t.vertices},
                     {"edges", t.edges},
                     {"faces", t.faces},
                     {"tetrahedra", t.tets},
                     {"components", t.components},
                     {"components_by_faces", t.face_components},
                     {"handles", t.handles},
                     {"cavities", t.cavities},
                     {"euler_characteristic", t.euler_characteristic},
                     {"pinched_edges", t.pinched_edges},
                     {"boundary_components", t.boundary_components},
                     {"boundary_euler_characteristic", t.boundary_euler_characteristic}};
  Json regions = Json::array();
  for (const auto& [tag, region] : r.regions)
    regions.push_back({{"tag", tag}, {"tetrahedra", region.tets}, {"volume", region.volume}});
  j["regions"] = std::move(regions);
  j["quality"] = {{"inverted_tetrahedra", r.inverted_tets},
                  {"smallest_dihedral_angle_degrees", r.min_dihedral * 180 / std::numbers::pi}};
  j["surface"] = r.surface ? to_json(*r.surface) : Json();
  j["patches"] = tags_json(r.patches, "triangles");
  j["curves"] = r.curves ? to_json(*r.curves) : Json();
  j["curve_tags"] = tags_json(r.curve_tags, "edges");
  j["fixed_points"] = r.fixed_points;
  j["fixed_point_tags"] = tags_json(r.fixed_tags, "points");
  return j;
}

namespace {

void print_tags(const Json& list, const char* what, const char* count) {
  constexpr std::size_t most = 12;
  if (list.size() < 2) return;
  std::cout << "              " << list.size() << ' ' << what << ':';
  for (std::size_t i = 0; i < std::min(most, list.size()); ++i)
    std::cout << (i == 0 ? " " : ", ") << list[i]["tag"] << " (" << list[i][count] << ')';
  std::cout << (list.size() > most ? ", ...\n" : "\n");
}

}  // namespace

void print_domain(const Json& j) {
  const Json& t = j["tetrahedra"];
  std::cout << "  tetrahedra: " << t["vertices"] << " vertices, " << t["edges"] << " edges, " << t["faces"]
            << " faces, " << t["tetrahedra"] << " tetrahedra\n              " << t["components"]
            << " components, " << t["handles"] << " handles, " << t["cavities"]
            << " cavities, Euler characteristic " << t["euler_characteristic"] << "\n              "
            << j["quality"]["inverted_tetrahedra"] << " inverted, smallest dihedral angle "
            << j["quality"]["smallest_dihedral_angle_degrees"].get<double>() << " degrees\n";
  print_tags(j["regions"], "regions", "tetrahedra");
  if (const Json& s = j["surface"]; !s.is_null()) {
    std::cout << "  surface:    " << s["vertices"] << " vertices, " << s["edges"] << " edges, " << s["faces"]
              << " triangles\n              " << s["components"] << " sheets, Euler characteristic "
              << s["euler_characteristic"] << ", " << s["boundary_loops"] << " boundary loops, genus "
              << s["genus"] << '\n';
    print_tags(j["patches"], "patches", "triangles");
  }
  if (const Json& c = j["curves"]; !c.is_null()) {
    std::cout << "  curves:     " << c["edges"] << " edges in " << c["components"] << " chains and loops, "
              << c["end_points"] << " ends of chains\n";
    print_tags(j["curve_tags"], "tags", "edges");
  }
  if (const Json& points = j["fixed_points"]; points != 0) {
    std::cout << "  points:     " << points << " fixed\n";
    print_tags(j["fixed_point_tags"], "tags", "points");
  }
}

}  // namespace multimesh::tools
