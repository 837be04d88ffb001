// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/polylines.hpp"
#include "multimesh/files/surface_file.hpp"
#include "tools/command.hpp"
#include "tools/domain_json.hpp"
#include "tools/mesh_page.hpp"
#include "tools/periodic_arguments.hpp"
#include "tools/surface_json.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

struct InfoArguments {
  std::string input;
  io::SurfaceWeldOptions weld;
  PeriodicArguments periodic;
  ReportOptions report;
};

Json contents_json(const files::SurfaceFile& file) {
  const files::FileContents& c = file.contents;
  return {{"positions", c.positions},
          {"texcoords", c.texcoords},
          {"normals", c.normals},
          {"colors", c.colors},
          {"faces", c.faces},
          {"quads", c.quads},
          {"larger_polygons", c.larger_polygons},
          {"repeated_faces_left_out", c.repeated_faces},
          {"collapsed_faces_left_out", c.collapsed_faces},
          {"triangles", c.triangles},
          {"polylines", c.polylines},
          {"materials", c.materials},
          {"groups", c.groups},
          {"objects", c.objects},
          {"material_libraries", file.material_libraries}};
}

Json describe(const files::SurfaceFile& file, const TexturedSurface& surface) {
  Json j;
  j["file"] = file.path.string();
  j["contents"] = contents_json(file);
  const ManifoldReport m = report_manifoldness(file.input, surface);
  j["manifold"] = {{"as_given", m.edges_with_three_or_more == 0 && m.cut_vertices == 0},
                   {"edges_with_three_or_more_faces", m.edges_with_three_or_more},
                   {"edges_with_opposite_orientations", m.inconsistent_edges},
                   {"vertex_copies_made_to_cut_it", m.cut_vertices},
                   {"triangles_reversed", surface.cut_report().reversed_triangles}};
  j["joined"] = to_json(topology_of(surface));
  j["welded"] = to_json(file.weld);
  j["triangles_without_texcoords"] = surface.cut_report().triangles_without_texcoords;
  j["meshes"] = to_json(surface);
  return j;
}

void print_mesh(const char* name, const Json& m) {
  std::cout << "  " << name << ": " << m["vertices"] << " vertices, " << m["edges"] << " edges, "
            << m["faces"] << " triangles\n           " << m["components"]
            << (std::string_view(name) == "texture" ? " charts" : " components") << ", Euler characteristic "
            << m["euler_characteristic"] << ", " << m["boundary_loops"] << " boundary loops, genus "
            << m["genus"] << '\n';
}

void print(const Json& j) {
  const Json& c = j["contents"];
  std::cout << j["file"].get<std::string>() << '\n'
            << "  file:    " << c["positions"] << " v, " << c["texcoords"] << " vt, " << c["normals"]
            << " vn, " << c["faces"] << " faces (" << c["quads"] << " quads, " << c["larger_polygons"]
            << " larger), " << c["materials"].size() << " materials, " << c["groups"].size() << " groups, "
            << c["objects"].size() << " objects\n";
  if (c["repeated_faces_left_out"] != 0 || c["collapsed_faces_left_out"] != 0)
    std::cout << "  left out: " << c["repeated_faces_left_out"] << " repeated faces, "
              << c["collapsed_faces_left_out"] << " collapsed ones\n";
  const Json& w = j["welded"];
  if (w["coincident_vertices"] != 0)
    std::cout << "  coincident vertices: " << w["coincident_vertices"] << ", of which "
              << w["welded_vertices"] << " are joined\n";
  const Json& m = j["manifold"];
  std::cout << "  " << (m["as_given"].get<bool>() ? "manifold" : "not manifold, cut") << ": "
            << m["edges_with_three_or_more_faces"] << " edges with three or more faces, "
            << m["edges_with_opposite_orientations"] << " with opposite orientations, "
            << m["vertex_copies_made_to_cut_it"] << " vertex copies made\n";
  if (!m["as_given"].get<bool>()) {
    const Json& joined = j["joined"];
    std::cout << "  as given: " << joined["vertices"] << " vertices, " << joined["components"]
              << " components, Euler characteristic " << joined["euler_characteristic"] << ", "
              << joined["boundary_loops"] << " boundary loops\n";
  }
  print_mesh("surface", j["meshes"]["surface"]);
  if (j["meshes"]["texture"].is_null()) {
    std::cout << "  no texture coordinates\n";
  } else {
    print_mesh("texture", j["meshes"]["texture"]);
    if (j["triangles_without_texcoords"] != 0)
      std::cout << "           " << j["triangles_without_texcoords"]
                << " triangles without texture coordinates\n";
  }
  for (const char* name : {"seams", "features"})
    if (const Json& s = j["meshes"][name]; !s.is_null())
      std::cout << "  " << name << ": " << (std::string_view(name) == "seams" ? "  " : "") << s["edges"]
                << " edges in " << s["curves"] << " curves, " << s["ends"] << " ends, " << s["junctions"]
                << " junctions\n";
}

Json describe_curves(const io::PolygonSoup& soup, const std::string& path) {
  const files::PolylineReport r = files::report_polylines(soup);
  return {
      {"file", path},
      {"contents", {{"positions", soup.positions.size()}, {"polylines", soup.line_count()}, {"faces", 0}}},
      {"meshes",
       {{"curves",
         {{"vertices", r.vertices},
          {"edges", r.curves.edges},
          {"curves", r.curves.curves},
          {"ends", r.curves.ends},
          {"junctions", r.curves.junctions}}}}},
      {"edges_from_a_vertex_to_itself", r.collapsed}};
}

void print_curves(const Json& j) {
  const Json& c = j["meshes"]["curves"];
  std::cout << j["file"].get<std::string>() << "\n  file:    " << j["contents"]["positions"] << " v, "
            << j["contents"]["polylines"] << " polylines, no faces\n  curves:  " << c["vertices"]
            << " vertices, " << c["edges"] << " edges in " << c["curves"] << " curves, " << c["ends"]
            << " ends, " << c["junctions"] << " junctions\n";
}

Json contents_json(const files::DomainFile& file) {
  Json j;
  j["file"] = file.path.string();
  Json groups = Json::array();
  for (const auto& g : file.soup.groups)
    groups.push_back({{"dimension", g.dimension}, {"tag", g.tag}, {"name", g.name}});
  j["contents"] = {
      {"points", file.soup.points.size()},           {"vertices", file.soup.simplices[0].size()},
      {"edges", file.soup.simplices[1].size()},      {"triangles", file.soup.simplices[2].size()},
      {"tetrahedra", file.soup.simplices[3].size()}, {"groups", groups}};
  for (const auto& set : file.soup.tag_sets)
    j["contents"]["tags_of_several_groups"].push_back(
        {{"dimension", set.dimension}, {"tag", set.tag}, {"groups", set.groups}});
  return j;
}

void print_domain_file(const Json& j) {
  const Json& c = j["contents"];
  std::cout << j["file"].get<std::string>() << "\n  file:       " << c["points"]
            << " points; listed: " << c["tetrahedra"] << " tetrahedra, " << c["triangles"] << " triangles, "
            << c["edges"] << " edges, " << c["vertices"] << " vertices, " << c["groups"].size()
            << " named groups\n";
  if (c.contains("tags_of_several_groups"))
    for (const auto& set : c["tags_of_several_groups"])
      std::cout << "              tag " << set["tag"] << " of dimension " << set["dimension"]
                << " stands for the groups " << set["groups"].dump() << '\n';
  print_domain(j["meshes"]);
}

void finish(const std::vector<std::string>& warnings, void (*in_lines)(const Json&), RunReport& report) {
  if (!report.is_printed()) in_lines(report.json());
  report.finish(warnings);
}

void run_on_polygons(const InfoArguments& a, io::PolygonSoup soup, RunReport& report) {
  if (soup.face_count() == 0) {
    report.json() = describe_curves(soup, a.input);
    return finish(soup.warnings, print_curves, report);
  }
  const files::SurfaceFile file = files::to_surface(std::move(soup), a.input, {.weld = a.weld});
  report.json() = describe(file, TexturedSurface(file.input));
  if (report.wants_page()) show_mesh(report, html_mesh(file), a.input);
  finish(file.warnings, print, report);
}

void run_on_tetrahedra(const InfoArguments& a, files::DomainFile file, RunReport& report) {
  Json& j = report.json();
  j = contents_json(file);
  const TetDomain domain = files::take_domain(file);
  j["meshes"] = to_json(multimesh::report(domain));
  if (report.wants_page()) show_mesh(report, html_mesh(domain), a.input);
  finish(file.warnings, print_domain_file, report);
}

void print_tile(const Json& j) {
  const Json &p = j["periodic"], &glued = p["glued"];
  std::cout << j["file"].get<std::string>() << "\n  periodic along " << p["periods"].dump()
            << "\n  glued:  " << glued["vertices"] << " vertices, " << glued["edges"] << " edges, "
            << glued["triangles"] << " triangles, " << glued["tetrahedra"]
            << " tetrahedra, Euler characteristic " << glued["euler_characteristic"]
            << "; a proper complex\n  sides:  ";
  for (const Json& side : p["sides"])
    std::cout << (&side == &p["sides"].front() ? "" : ", ") << side["faces"] << " faces along "
              << side["vector"].get<std::string>();
  std::cout << (p["flat_sides"].get<bool>() ? "; flat" : "; not flat") << "\n  copies: " << p["copies"].dump()
            << " (vertices by number of copies), mismatch " << p["mismatch"]
            << "\n  inverted: " << p["inverted"] << '\n';
}

/// That it can be glued is all that a tile needs: else this throws.
void run_on_tile(const InfoArguments& a, RunReport& report) {
  const auto [file, domain] = read_periodic(a.input, a.periodic);
  const TileTopology t = topology_of(domain);
  Json& j = report.json();
  j = {{"file", a.input}, {"periodic", to_json(domain, t)}};
  Json& p = j["periodic"];
  p["mismatch"] = domain.report().largest_shift;
  p["surface"] = {{"euler_characteristic", t.surface_euler}, {"components", t.surface.components}};
  p["interfaces"] = {{"euler_characteristic", t.interface_euler}, {"components", t.interface.components}};
  for (const auto& [region, size] : t.sizes) p["regions"][std::to_string(region)] = size;
  finish(file.warnings, print_tile, report);
}

void run(const InfoArguments& a, RunReport& report) {
  if (a.periodic.is_given()) return run_on_tile(a, report);
  if (files::is_surface_format(a.input))
    return run_on_polygons(a, files::read_polygons(a.input, true), report);
  files::DomainFile file = files::read_simplices(a.input);
  if (file.has_tetrahedra()) return run_on_tetrahedra(a, std::move(file), report);
  run_on_polygons(a, files::polygons_of(file), report);
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("info", "Describe a file, mesh by mesh.");
  auto arguments = std::make_shared<InfoArguments>();
  command->add_option("FILE", arguments->input, files::all_formats)->required();
  add_weld_options(*command, arguments->weld);
  add_report_options(*command, arguments->report, "with the mesh in 3D and the numbers");
  add_old_json_flag(*command, arguments->report);
  auto* periodic = add_periodic_tile_options(*command, arguments->periodic);
  for (const char* other : {"--weld", "--report-html"}) periodic->excludes(command->get_option(other));
  command->footer(
      "A textured file is two meshes: the surface, by positions, and the texture, by texture\n"
      "coordinates. They have the same triangles and different vertices; the texture is cut open at\n"
      "the seams. A file of tetrahedra is three: the tetrahedra; the surface (their boundary, the\n"
      "interfaces between regions, and the listed triangles); and the curves (where sheets of the\n"
      "surface meet, and the listed edges). Input that is not manifold is cut, and the numbers of the\n"
      "meshes are those after the cut; the numbers of the surface as given come before them.\n\n"
      "With --periodic, the exit status is 1 if the sides of the tile do not match; the message names\n"
      "the point without a partner.");
  command->callback([arguments, command, &exit_code] {
    RunReport report(*command, arguments->report, {arguments->input});
    run(*arguments, report);
    exit_code = done;
  });
}

}  // namespace multimesh::tools
