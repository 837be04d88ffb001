// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <set>

#include "multimesh/error.hpp"
#include "tools/command.hpp"
#include "tools/surface_file.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

namespace {

struct InfoArguments {
  std::string input;
  bool json = false;
};

Json describe(const SurfaceFile& file, const TexturedSurface& surface) {
  Json j;
  j["file"] = file.path.string();
  const auto& soup = file.soup;
  std::size_t ngons = 0, quads = 0;
  std::set<std::string> materials, groups, objects;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    quads += soup.face(f).size() == 4;
    ngons += soup.face(f).size() > 4;
    if (soup.face_section.empty()) continue;
    const auto& section = soup.sections[soup.face_section[f]];
    materials.insert(section.material), groups.insert(section.group), objects.insert(section.object);
  }
  for (auto* names : {&materials, &groups, &objects}) names->erase("");
  j["contents"] = {{"positions", soup.positions.size()},
                   {"texcoords", soup.texcoords.size()},
                   {"normals", soup.normals.size()},
                   {"colors", soup.colors.size()},
                   {"faces", soup.face_count()},
                   {"quads", quads},
                   {"larger_polygons", ngons},
                   {"triangles", file.input.triangles.size()},
                   {"materials", materials},
                   {"groups", groups},
                   {"objects", objects},
                   {"material_libraries", soup.material_libraries}};
  const ManifoldReport m = report_manifoldness(file.input, surface);
  j["manifold"] = {{"as_given", m.edges_with_three_or_more == 0 && m.cut_vertices == 0},
                   {"edges_with_three_or_more_faces", m.edges_with_three_or_more},
                   {"edges_with_opposite_orientations", m.inconsistent_edges},
                   {"vertex_copies_made_to_cut_it", m.cut_vertices},
                   {"triangles_reversed", surface.cut_report().reversed_triangles}};
  j["triangles_without_texcoords"] = surface.cut_report().triangles_without_texcoords;
  j["meshes"] = to_json(surface);
  j["warnings"] = file.warnings;
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
  const Json& m = j["manifold"];
  std::cout << "  " << (m["as_given"].get<bool>() ? "manifold" : "not manifold, cut") << ": "
            << m["edges_with_three_or_more_faces"] << " edges with three or more faces, "
            << m["edges_with_opposite_orientations"] << " with opposite orientations, "
            << m["vertex_copies_made_to_cut_it"] << " vertex copies made\n";
  print_mesh("surface", j["meshes"]["surface"]);
  if (j["meshes"]["texture"].is_null()) {
    std::cout << "  no texture coordinates\n";
  } else {
    print_mesh("texture", j["meshes"]["texture"]);
    if (j["triangles_without_texcoords"] != 0)
      std::cout << "           " << j["triangles_without_texcoords"]
                << " triangles without texture coordinates\n";
  }
  if (const Json& s = j["meshes"]["seams"]; !s.is_null())
    std::cout << "  seams:   " << s["edges"] << " edges in " << s["curves"] << " curves, " << s["ends"]
              << " ends, " << s["junctions"] << " junctions\n";
  for (const auto& w : j["warnings"]) std::cerr << "warning: " << w.get<std::string>() << '\n';
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("info", "What is in a file, mesh by mesh.");
  auto arguments = std::make_shared<InfoArguments>();
  command->add_option("FILE", arguments->input, "OBJ or PLY file")->required();
  command->add_flag("--json", arguments->json, "print JSON");
  command->footer(
      "A textured file is two meshes: the surface, by positions, and the texture, by texture coordinates. "
      "They\n"
      "have the same triangles and different vertices; the seams are where the texture is cut open. Input "
      "that is\n"
      "not manifold is cut, and the numbers are those of the cut meshes.");
  command->callback([arguments, &exit_code] {
    const SurfaceFile file = read_surface(arguments->input);
    const TexturedSurface surface(file.input);
    const Json j = describe(file, surface);
    if (arguments->json) {
      std::cout << to_text(j);
    } else {
      print(j);
    }
    if (!std::cout.flush()) throw InputError("standard output: writing failed");
    exit_code = done;
  });
}

}  // namespace multimesh::tools
