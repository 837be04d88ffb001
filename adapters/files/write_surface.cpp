// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/mtl.hpp"
#include "multimesh/domains/corner_normals.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/hash.hpp"
#include "multimesh/io/obj_writer.hpp"
#include "multimesh/io/polygon_writer.hpp"
#include "multimesh/version.hpp"

namespace multimesh::files {

namespace {

template <std::size_t n, class From>
std::vector<std::array<double, n>> numbers(const std::vector<From>& list) {
  std::vector<std::array<double, n>> result(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) std::copy_n(list[i].data(), n, result[i].begin());
  return result;
}

/// Triangles in the order of the input's faces, so that sections stay together.
std::vector<std::size_t> by_source(const std::vector<Index>& source) {
  std::vector<std::size_t> order(source.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return source[x] < source[y]; });
  return order;
}

/// Makes each combination of position, texture coordinate and normal a vertex of its own, as far as the file
/// had such vertices.
class SplitVertices {
 public:
  SplitVertices(io::PolygonSoup& soup, const io::SurfaceWeldReport& weld) : soup_(soup), weld_(weld) {}

  void run() {
    io::PolygonSoup from;
    from.positions.swap(soup_.positions);
    from.colors.swap(soup_.colors);
    std::unordered_map<std::array<std::uint64_t, 3>, std::int32_t, ArrayHash> number;
    for (auto& c : soup_.corners) {
      const std::array key{word(c.v), word(weld_.split_by_texcoord ? c.vt : -1),
                           word(weld_.split_by_normal ? c.vn : -1)};
      const auto [it, is_new] = number.try_emplace(key, static_cast<std::int32_t>(soup_.positions.size()));
      if (is_new) {
        soup_.positions.push_back(from.positions[static_cast<std::size_t>(c.v)]);
        if (!from.colors.empty()) soup_.colors.push_back(from.colors[static_cast<std::size_t>(c.v)]);
      }
      c.v = it->second;
    }
    if (weld_.split_by_texcoord && weld_.texcoords_by_vertex)
      renumber(soup_.texcoords, &io::PolygonSoup::Corner::vt);
    if (weld_.split_by_normal && weld_.normals_by_vertex)
      renumber(soup_.normals, &io::PolygonSoup::Corner::vn);
  }

 private:
  static std::uint64_t word(std::int32_t i) { return static_cast<std::uint64_t>(i); }

  /// One value per vertex, under the vertex's number, if every corner has one.
  template <std::size_t N>
  void renumber(std::vector<std::array<double, N>>& values, std::int32_t io::PolygonSoup::Corner::*index) {
    if (std::ranges::any_of(soup_.corners, [&](const auto& c) { return c.*index < 0; })) return;
    std::vector<std::array<double, N>> by_vertex(soup_.positions.size());
    for (auto& c : soup_.corners) {
      by_vertex[static_cast<std::size_t>(c.v)] = values[static_cast<std::size_t>(c.*index)];
      c.*index = c.v;
    }
    values.swap(by_vertex);
  }

  io::PolygonSoup& soup_;
  const io::SurfaceWeldReport& weld_;
};

/// The lists of the soup, without its faces.
io::PolygonSoup values_of(const TexturedTriangles& surface, const CornerNormals& normals) {
  io::PolygonSoup out;
  out.positions = numbers<3>(surface.positions);
  out.texcoords = numbers<2>(surface.texcoords);
  out.colors = numbers<3>(surface.colors);
  out.normals = numbers<3>(normals.normals);
  return out;
}

void add_face(io::PolygonSoup& out, const TexturedTriangles& surface, const CornerNormals& normals,
              std::size_t t, std::uint32_t section) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& c = surface.triangles[t][i];
    out.corners.push_back({c.position, c.texcoord, normals.corners.empty() ? -1 : normals.corners[t][i]});
  }
  out.face_begin.push_back(static_cast<std::uint32_t>(out.corners.size()));
  out.face_section.push_back(section);
}

/// `file`: where its materials come from.
std::vector<std::string> write(const std::filesystem::path& path, io::PolygonSoup& out,
                               const SurfaceFile& file, std::size_t uv_sets) {
  std::vector<std::string> warnings;
  if (uv_sets > 1)
    warnings.push_back(path.string() + ": only the first of " + std::to_string(uv_sets) +
                       " sets of texture coordinates is written");
  if (io::format_extension(path) == ".obj") {
    out.material_libraries = io::relocate_material_libraries(file.material_libraries, file.path, path,
                                                             warnings, file.follow_paths);
    if (!file.materials.empty())
      out.material_libraries.push_back(io::write_material_library(file.materials, file.path, path, warnings));
    io::write_obj(path, out, {.header = {std::string("multimesh ") + version}});
  } else {
    for (std::string& w : io::write_polygons(path, out)) warnings.push_back(std::move(w));
  }
  return warnings;
}

}  // namespace

std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedSurface& surface,
                                       const SurfaceFile& file) {
  std::vector<Index> source;
  const TexturedTriangles result = surface.triangles(source);
  const CornerNormals normals = surface.has_normals() ? corner_normals(surface) : CornerNormals();
  io::PolygonSoup out = values_of(result, normals);
  out.sections = file.sections;
  for (const std::size_t t : by_source(source))
    add_face(out, result, normals, t, file.section.empty() ? 0 : file.section[source[t]]);
  if (file.weld.split_by_texcoord || file.weld.split_by_normal) SplitVertices(out, file.weld).run();
  return write(path, out, file, result.uv_sets());
}

std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedTriangles& surface) {
  check(surface);
  io::PolygonSoup out = values_of(surface, {});
  out.sections.emplace_back();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) add_face(out, surface, {}, t, 0);
  return write(path, out, {}, surface.uv_sets());
}

}  // namespace multimesh::files
