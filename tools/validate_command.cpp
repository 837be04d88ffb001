// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "multimesh/algorithms/surface_topology.hpp"
#include "multimesh/algorithms/tet_topology.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/polylines.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/validate.hpp"
#include "tools/command.hpp"
#include "tools/domain_json.hpp"
#include "tools/mesh_page.hpp"
#include "tools/weld_arguments.hpp"

namespace multimesh::tools {

namespace {

struct ValidateArguments {
  std::string input;
  io::SurfaceWeldOptions weld;
  ReportOptions report;
};

/// Facts, and problems; problems make the file invalid.
struct Findings {
  std::vector<std::string> facts, problems;
  std::vector<std::string> warnings;  ///< of the reader; also among the facts
  HtmlMesh page = {};

  explicit Findings(std::vector<std::string> of_reading)
      : facts(of_reading), warnings(std::move(of_reading)) {}

  void add(std::size_t n, const char* what) {
    if (n > 0) problems.push_back(std::to_string(n) + " " + what);
  }
  void add_tree(const MultiMesh& tree) {
    for (const std::string& p : validate(tree)) problems.push_back("internal: " + p);
  }
};

/// Triangles without area, by their positions.
std::size_t count_flat(const TexturedTriangles& t) {
  std::size_t flat = 0;
  for (const auto& c : t.triangles) {
    const auto p = [&](std::size_t i) { return t.positions[static_cast<std::size_t>(c[i].position)]; };
    const Vec3 normal = cross(p(1) - p(0), p(2) - p(0));
    flat += normal == Vec3(0, 0, 0);
  }
  return flat;
}

Findings examine(const TexturedTriangles& input, std::vector<std::string> warnings) {
  Findings f(std::move(warnings));
  const TexturedSurface surface(input);
  const ManifoldReport m = report_manifoldness(input, surface);
  f.add(m.edges_with_three_or_more, "edges have three or more triangles");
  f.add(m.inconsistent_edges, "edges have two triangles of opposite orientations");
  f.add(m.cut_vertices, "copies of vertices are needed to make it manifold");
  f.add(count_flat(input), "triangles have no area");
  f.add_tree(surface.tree());
  const std::size_t loops = topology_of(surface).boundary_loops;
  f.facts.push_back(loops == 0 ? "the surface is closed"
                               : "the surface has " + std::to_string(loops) + " boundary loops");
  return f;
}

Findings examine(files::DomainFile& file, bool page) {
  Findings f(std::move(file.warnings));
  f.add(file.soup.notes.doubled, "elements are listed again with the same points and tag");
  f.add(files::count_coincident(file.soup), "points are at the place of another one, which --weld 0 joins");
  const TaggedTetrahedra tets = files::take_tetrahedra(file);
  f.add(hanging_points(tets).size(),
        "points lie in the middle of an edge or a face of the boundary: the mesh does not conform there");
  f.add(topology_of(tets).crowded_faces, "faces have three or more tetrahedra");
  const TetDomain domain(tets);
  const TetDomainReport& r = domain.report();
  if (r.copied_vertices > 0)
    f.facts.push_back("the mesh touches itself; the commands make " + std::to_string(r.copied_vertices) +
                      " copies of points there, which are one again in what they write");
  f.add(r.reversed_tets, "tetrahedra are oriented against the others, or have negative volume");
  f.add(r.inverted_tets, "tetrahedra have no or negative volume when oriented like the others");
  f.add(r.missing_triangles, "listed triangles are no face of a tetrahedron");
  f.add(r.missing_edges, "listed edges are no edge of a tetrahedron");
  f.add(r.missing_points, "listed points are no vertex of a tetrahedron");
  f.add_tree(domain.tree());
  if (page) f.page = html_mesh(domain);
  return f;
}

/// Coincident vertices are a problem if only a missing link separates them.
void add_weld(const io::SurfaceWeldReport& weld, Findings& f) {
  f.add(weld.redundant,
        "vertices repeat another one, so that the surface comes apart there; they are joined");
  f.add(weld.copied_faces, "faces are copies of an earlier one");
  if (const std::size_t n = weld.coincident - weld.redundant; n > 0)
    f.facts.push_back(std::to_string(n) + " other vertices coincide: along seams, or where parts touch");
}

Findings examine_curves(const io::PolygonSoup& soup) {
  Findings f(soup.warnings);
  const files::PolylineReport r = files::report_polylines(soup);
  f.add(r.collapsed, "edges go from a vertex to itself");
  f.facts.push_back("no faces; " + std::to_string(r.curves.edges) + " edges in " +
                    std::to_string(r.curves.curves) + " curves");
  return f;
}

Findings examine(io::PolygonSoup soup, const ValidateArguments& a) {
  if (soup.face_count() == 0) return examine_curves(soup);
  files::SurfaceFile file = files::to_surface(std::move(soup), a.input, {.weld = a.weld});
  Findings f = examine(file.input, std::move(file.warnings));
  add_weld(file.weld, f);
  f.add(file.contents.repeated_faces, "faces repeat an earlier one");
  f.add(file.contents.collapsed_faces, "faces have fewer than three distinct vertices");
  if (!a.report.html.empty()) f.page = html_mesh(file);
  return f;
}

Findings examine(const ValidateArguments& a) {
  if (files::is_surface_format(a.input)) return examine(files::read_polygons(a.input, true), a);
  files::DomainFile file = files::read_simplices(a.input);
  if (file.has_tetrahedra()) return examine(file, !a.report.html.empty());
  return examine(files::polygons_of(file), a);
}

void print(const std::string& path, const Findings& f) {
  std::cout << path << ": " << (f.problems.empty() ? "valid" : "not valid") << '\n';
  for (const std::string& p : f.problems) std::cout << "  problem: " << p << '\n';
  for (const std::string& p : f.facts) std::cout << "  note: " << p << '\n';
}

bool run(const ValidateArguments& a, RunReport& report) {
  Findings f = examine(a);
  const bool is_valid = f.problems.empty();
  report.json() = {{"file", a.input}, {"valid", is_valid}, {"problems", f.problems}, {"notes", f.facts}};
  if (report.wants_page()) show_mesh(report, std::move(f.page), a.input);
  if (!report.is_printed()) print(a.input, f);
  report.finish(f.warnings, true);  // they are among the notes
  return is_valid;
}

}  // namespace

void add_validate_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("validate", "Check whether a file's meshes are manifold, oriented and consistent.");
  auto a = std::make_shared<ValidateArguments>();
  command->add_option("FILE", a->input, files::all_formats)->required();
  add_weld_options(*command, a->weld);
  add_report_options(*command, a->report, "with the mesh in 3D and what was found");
  add_old_json_flag(*command, a->report);
  command->footer(
      "Exit status 0: valid; 1: not valid, or the file cannot be read. Copies and reversals that are\n"
      "reported as needed are made by the other commands. Intersections of triangles are not checked.");
  command->callback([a, command, &exit_code] {
    RunReport report(*command, a->report, {a->input});
    const bool is_valid = run(*a, report);
    exit_code = is_valid ? done : refused;
  });
}

}  // namespace multimesh::tools
