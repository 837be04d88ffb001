// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

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

Json contents_json(const SurfaceFile& file) {
  const FileContents& c = file.contents;
  return {{"positions", c.positions},
          {"texcoords", c.texcoords},
          {"normals", c.normals},
          {"colors", c.colors},
          {"faces", c.faces},
          {"quads", c.quads},
          {"larger_polygons", c.larger_polygons},
          {"triangles", c.triangles},
          {"materials", c.materials},
          {"groups", c.groups},
          {"objects", c.objects},
          {"material_libraries", file.material_libraries}};
}

Json describe(const SurfaceFile& file, const TexturedSurface& surface) {
  Json j;
  j["file"] = file.path.string();
  j["contents"] = contents_json(file);
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
  for (const char* name : {"seams", "features"})
    if (const Json& s = j["meshes"][name]; !s.is_null())
      std::cout << "  " << name << ": " << (std::string_view(name) == "seams" ? "  " : "") << s["edges"]
                << " edges in " << s["curves"] << " curves, " << s["ends"] << " ends, " << s["junctions"]
                << " junctions\n";
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
