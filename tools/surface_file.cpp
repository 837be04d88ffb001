// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surface_file.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "adapters/io/mesh_reader.hpp"
#include "adapters/io/mtl.hpp"
#include "adapters/io/obj_writer.hpp"
#include "multimesh/error.hpp"
#include "multimesh/version.hpp"

namespace multimesh::tools {

namespace {

OpenMesh::Vec3d vec(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}
OpenMesh::Vec2d vec(const std::array<double, 2>& p) {
  return {p[0], p[1]};
}

bool repeats_vertex(const std::array<io::PolygonSoup::Corner, 3>& t) {
  return t[0].v == t[1].v || t[1].v == t[2].v || t[2].v == t[0].v;
}

void add_count(std::vector<std::string>& warnings, std::size_t count, const std::string& what) {
  if (count > 0) warnings.push_back(std::to_string(count) + " " + what);
}

/// A number per face: equal for equal materials. Empty if the file has no sections.
std::vector<Index> material_numbers(const io::PolygonSoup& soup) {
  std::map<std::string, Index> number;
  std::vector<Index> of_faces;
  for (const std::uint32_t section : soup.face_section)
    of_faces.push_back(
        number.try_emplace(soup.sections[section].material, static_cast<Index>(number.size())).first->second);
  return of_faces;
}

void convert(SurfaceFile& file) {
  for (const auto& p : file.soup.positions) file.input.positions.push_back(vec(p));
  for (const auto& p : file.soup.texcoords) file.input.texcoords.push_back(vec(p));
  const std::vector<Index> materials = material_numbers(file.soup);
  io::TriangleSoup kept;
  std::size_t repeated = 0, partly = 0;
  for (std::size_t t = 0; t < file.triangles.triangles.size(); ++t) {
    const auto& corners = file.triangles.triangles[t];
    if (repeats_vertex(corners)) {
      ++repeated;
      continue;
    }
    const auto with = std::count_if(corners.begin(), corners.end(), [](const auto& c) { return c.vt >= 0; });
    partly += with == 1 || with == 2;
    std::array<TexturedTriangles::Corner, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = {corners[i].v, with == 3 ? corners[i].vt : -1};
    file.input.triangles.push_back(triangle);
    if (!materials.empty()) file.input.labels.push_back(materials[file.triangles.polygon[t]]);
    kept.triangles.push_back(corners);
    kept.polygon.push_back(file.triangles.polygon[t]);
  }
  file.triangles = std::move(kept);
  add_count(file.warnings, repeated, "triangles name a vertex twice; left out");
  add_count(file.warnings, partly, "triangles have texture coordinates on some corners only; they lose them");
}

}  // namespace

SurfaceFile read_surface(const std::filesystem::path& path) {
  SurfaceFile file{path, io::read_mesh(path), {}, {}, {}};
  file.warnings = file.soup.warnings;
  file.triangles = io::triangulate(file.soup);
  convert(file);
  if (file.input.triangles.empty()) throw InputError(path.string() + ": no triangle is left");
  return file;
}

void write_surface(const std::filesystem::path& path, const TexturedSurface& surface, const SurfaceFile& file,
                   std::vector<std::string>& warnings) {
  std::vector<Index> source;
  const TexturedTriangles result = surface.triangles(source);
  io::PolygonSoup out;
  for (const auto& p : result.positions) out.positions.push_back({p[0], p[1], p[2]});
  for (const auto& p : result.texcoords) out.texcoords.push_back({p[0], p[1]});
  out.sections = file.soup.sections;

  // In the order of the input's faces, so that sections stay together.
  std::vector<std::size_t> order(result.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return source[x] < source[y]; });
  for (const std::size_t t : order) {
    for (const auto& c : result.triangles[t]) out.corners.push_back({c.position, c.texcoord, -1});
    out.face_begin.push_back(static_cast<std::uint32_t>(out.corners.size()));
    const std::uint32_t polygon = file.triangles.polygon[source[t]];
    out.face_section.push_back(file.soup.face_section.empty() ? 0 : file.soup.face_section[polygon]);
  }
  if (out.sections.empty()) out.sections.emplace_back();
  if (!file.soup.normals.empty()) warnings.push_back("normals are left out; viewers compute their own");
  if (!file.soup.colors.empty()) warnings.push_back("vertex colours are left out");
  out.material_libraries =
      io::relocate_material_libraries(file.soup.material_libraries, file.path, path, warnings);
  io::write_obj(path, out, {.header = {std::string("multimesh ") + version}});
}

}  // namespace multimesh::tools
