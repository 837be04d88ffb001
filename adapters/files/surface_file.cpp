// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/surface_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

#include "adapters/io/naming.hpp"
#include "adapters/io/polygons_to_simplices.hpp"
#include "adapters/io/soup_check.hpp"
#include "multimesh/domains/shading.hpp"
#include "multimesh/domains/turn_reversed.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/triangulate.hpp"

namespace multimesh::files {

namespace {

bool repeats_vertex(const std::array<io::PolygonSoup::Corner, 3>& t) {
  return t[0].v == t[1].v || t[1].v == t[2].v || t[2].v == t[0].v;
}

void add_count(std::vector<std::string>& warnings, std::size_t count, const std::string& what) {
  if (count > 0) warnings.push_back(std::to_string(count) + " " + what);
}

/// Converts a list, and frees its memory.
template <class To, class From>
std::vector<To> taken(std::vector<From>& list) {
  std::vector<To> result;
  result.reserve(list.size());
  for (const auto& p : list) {
    if constexpr (std::tuple_size_v<From> == 3) {
      result.push_back({p[0], p[1], p[2]});
    } else {
      result.push_back({p[0], p[1]});
    }
  }
  std::vector<From>().swap(list);
  return result;
}

FileContents contents(const io::PolygonSoup& soup) {
  FileContents c;
  c.positions = soup.positions.size();
  c.texcoords = soup.texcoords.size();
  c.normals = soup.normals.size();
  c.colors = soup.colors.size();
  c.faces = soup.face_count();
  c.polylines = soup.line_count();
  c.repeated_faces = soup.notes.repeated_faces;
  c.collapsed_faces = soup.notes.collapsed_faces;
  std::vector<bool> used(soup.sections.size(), false);
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    c.quads += soup.face(f).size() == 4;
    c.larger_polygons += soup.face(f).size() > 4;
    if (!soup.face_section.empty()) used[soup.face_section[f]] = true;
  }
  for (std::size_t s = 0; s < used.size(); ++s) {
    if (!used[s]) continue;
    c.materials.insert(soup.sections[s].material);
    c.groups.insert(soup.sections[s].group);
    c.objects.insert(soup.sections[s].object);
  }
  for (auto* names : {&c.materials, &c.groups, &c.objects}) names->erase("");
  return c;
}

/// A number per section, equal for equal materials. For formats with tags, their groups count as materials.
std::vector<Index> material_numbers(const std::vector<io::PolygonSoup::Section>& sections, bool has_tags) {
  std::map<std::string, Index> number;
  std::vector<Index> of_sections;
  for (const auto& s : sections)
    of_sections.push_back(
        number.try_emplace(has_tags ? s.group : s.material, static_cast<Index>(number.size())).first->second);
  return of_sections;
}

using Normals = std::vector<std::array<std::int32_t, 3>>;

bool any_normal(const Normals& corners) {
  return std::any_of(corners.begin(), corners.end(), [](const auto& c) {
    return std::any_of(c.begin(), c.end(), [](std::int32_t n) { return n >= 0; });
  });
}

/// The triangles with three different vertices. `normals`: their indices, if the file has normals.
void take_triangles(io::PolygonSoup& soup, SurfaceFile& file, Normals& normals) {
  const io::TriangleSoup triangles = io::triangulate(soup);
  decltype(soup.corners)().swap(soup.corners);
  const std::vector<Index> materials = material_numbers(soup.sections, !is_surface_format(file.path));
  file.input.triangles.reserve(triangles.triangles.size());
  std::size_t repeated = 0, partly = 0;
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
    const auto& corners = triangles.triangles[t];
    if (repeats_vertex(corners)) {
      ++repeated;
      continue;
    }
    const auto with = std::count_if(corners.begin(), corners.end(), [](const auto& c) { return c.vt >= 0; });
    partly += with == 1 || with == 2;
    auto& triangle = file.input.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = {corners[i].v, with == 3 ? corners[i].vt : -1};
    if (!soup.normals.empty()) normals.push_back({corners[0].vn, corners[1].vn, corners[2].vn});
    if (soup.face_section.empty()) continue;
    file.section.push_back(soup.face_section[triangles.polygon[t]]);
    file.input.labels.push_back(materials[file.section.back()]);
  }
  add_count(file.warnings, repeated, "triangles name a vertex twice; left out");
  add_count(file.warnings, partly, "triangles have texture coordinates on some corners only; they lose them");
}

/// The next power of ten, for instance 1e-05.
std::string rounded_up(double x) {
  std::ostringstream text;
  text << std::pow(10.0, std::ceil(std::log10(x)));
  return text.str();
}

/// What was joined, and what may have to be joined, in sentences.
std::vector<std::string> weld_warnings(const io::SurfaceWeldReport& r, const io::SurfaceWeldOptions& o) {
  std::vector<std::string> w;
  const auto add = [&](std::size_t n, const std::string& what) {
    if (n > 0) w.push_back(std::to_string(n) + " " + what);
  };
  add(r.welded, std::string(o.tolerance > 0 ? "vertices as near as the tolerance to another one"
                                            : "vertices at exactly the place of another one") +
                    " are joined with it; --no-weld keeps them apart");
  add(r.copied_faces, "faces are copies of an earlier one at the same place; left out");
  add(r.blended_colors, "vertices are joined with one of another colour; they have the mean colour now");
  add(r.texcoords,
      "corners have texture coordinates that differ from others at their vertex by rounding only; "
      "they are joined");
  if (r.near_texcoords > r.textured_vertices / 100)  // a few are chance
    add(r.near_texcoords,
        "vertices have texture coordinates that are nearly equal, but seams; if they are meant "
        "to be equal, which hinders a run much, join them by --uv-weld " +
            rounded_up(r.near_texcoord_distance));
  return w;
}

}  // namespace

io::PolygonSoup polygons_of(const DomainFile& file) {
  if (file.soup.points.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError(file.path.string() + ": more than 2147483647 points are too many for a surface");
  if (file.soup.simplices[2].size() + file.soup.simplices[1].size() == 0)
    throw InputError(file.path.string() + ": has no tetrahedra, triangles or edges");
  io::PolygonSoup soup = io::to_grouped_polygons(file.soup);
  soup.warnings = file.warnings;
  io::clean_faces(soup, file.path.string(), false);
  return soup;
}

io::PolygonSoup read_polygons(const std::filesystem::path& path, bool keep_lines) {
  if (is_surface_format(path)) return io::read_mesh(path, {.keep_lines = keep_lines});
  DomainFile file = read_simplices(path);
  if (file.has_tetrahedra())
    throw InputError(path.string() + ": has tetrahedra; give a surface, or use `multimesh improve`");
  if (file.soup.simplices[2].size() == 0 && !keep_lines)
    throw InputError(path.string() + ": has points or lines but no triangle; give a surface");
  if (const std::size_t pairs = count_periodic_pairs(file.soup); pairs > 0)
    file.warnings.push_back(
        "the mesh is periodic ($Periodic, " + std::to_string(pairs) +
        " pairs of points); it is taken as any other, and its sides need not match afterwards");
  return polygons_of(file);
}

// Lists of the soup are freed one by one as the triangles replace them: otherwise both together would be the
// largest thing in memory for a while.
SurfaceFile to_surface(io::PolygonSoup soup, const std::filesystem::path& path,
                       const SurfaceReadOptions& options) {
  SurfaceFile file;
  file.path = path;
  file.follow_paths = options.follow_paths;
  file.contents = contents(soup);
  file.weld = io::weld_surface(soup, options.weld, path.string());
  file.warnings = std::move(soup.warnings);
  for (std::string& w : weld_warnings(file.weld, options.weld)) file.warnings.push_back(std::move(w));
  file.material_libraries = std::move(soup.material_libraries);
  file.materials = std::move(soup.materials);
  Normals normal_corners;
  take_triangles(soup, file, normal_corners);
  file.contents.triangles = file.input.triangles.size();
  if (file.input.triangles.empty()) throw InputError(path.string() + ": no triangle is left");
  file.sections = std::move(soup.sections);
  if (file.sections.empty()) file.sections.emplace_back();
  file.input.positions = taken<Vec3>(soup.positions);
  file.input.texcoords = taken<Vec2>(soup.texcoords);
  file.input.colors = taken<Vec3>(soup.colors);
  io::naming(path, [&] { check_size(file.input); });
  if (any_normal(normal_corners)) {
    const auto normals = taken<Vec3>(soup.normals);
    file.input.shading = shading(file.input, normals, normal_corners);
  }
  return file;
}

SurfaceFile read_surface(const std::filesystem::path& path, const SurfaceReadOptions& options) {
  return to_surface(read_polygons(path), path, options);
}

TexturedSurface take_surface(SurfaceFile& file, const TexturedSurfaceOptions& options) {
  std::optional<TexturedSurface> surface;
  io::naming(file.path, [&] { surface.emplace(file.input, options); });
  if (const std::size_t turned = turn_reversed(*surface, file.input); turned > 0) {
    surface.emplace(file.input, options);
    add_count(file.warnings, turned, "triangles were turned round to agree with their neighbours");
  }
  file.input = TexturedTriangles();
  return std::move(*surface);
}

}  // namespace multimesh::files
