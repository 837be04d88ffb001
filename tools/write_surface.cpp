// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "adapters/io/mtl.hpp"
#include "adapters/io/obj_writer.hpp"
#include "multimesh/algorithms/corner_normals.hpp"
#include "multimesh/version.hpp"
#include "tools/surface_file.hpp"

namespace multimesh::tools {

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

}  // namespace

void write_surface(const std::filesystem::path& path, const TexturedSurface& surface, const SurfaceFile& file,
                   std::vector<std::string>& warnings) {
  std::vector<Index> source;
  const TexturedTriangles result = surface.triangles(source);
  const CornerNormals normals = surface.has_normals() ? corner_normals(surface) : CornerNormals();
  io::PolygonSoup out;
  out.positions = numbers<3>(result.positions);
  out.texcoords = numbers<2>(result.texcoords);
  out.colors = numbers<3>(result.colors);
  out.normals = numbers<3>(normals.normals);
  out.sections = file.sections;
  for (const std::size_t t : by_source(source)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& c = result.triangles[t][i];
      out.corners.push_back({c.position, c.texcoord, normals.corners.empty() ? -1 : normals.corners[t][i]});
    }
    out.face_begin.push_back(static_cast<std::uint32_t>(out.corners.size()));
    out.face_section.push_back(file.section.empty() ? 0 : file.section[source[t]]);
  }
  out.material_libraries =
      io::relocate_material_libraries(file.material_libraries, file.path, path, warnings, file.follow_paths);
  if (!file.materials.empty())
    out.material_libraries.push_back(io::write_material_library(file.materials, file.path, path, warnings));
  io::write_obj(path, out, {.header = {std::string("multimesh ") + version}});
}

}  // namespace multimesh::tools
