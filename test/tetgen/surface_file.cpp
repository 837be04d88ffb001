// SPDX-License-Identifier: BSD-3-Clause
#include "test/tetgen/surface_file.hpp"

#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace multimesh::test {

using tetgen::Point;

namespace {

/// Polygons as fans.
void add_polygon(ClosedSurface& surface, const std::vector<Index>& corners) {
  for (std::size_t k = 2; k < corners.size(); ++k)
    surface.triangles.corners.insert(surface.triangles.corners.end(),
                                     {corners[0], corners[k - 1], corners[k]});
}

ClosedSurface read_off(std::istream& in) {
  ClosedSurface surface;
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0;
  in >> word >> points >> faces >> edges;
  surface.points.resize(points);
  for (Point& p : surface.points) in >> p[0] >> p[1] >> p[2];
  for (std::size_t f = 0; f < faces; ++f) {
    std::size_t size = 0;
    in >> size;
    std::vector<Index> corners(size);
    for (Index& c : corners) in >> c;
    std::getline(in, word);
    add_polygon(surface, corners);
  }
  return surface;
}

ClosedSurface read_obj(std::istream& in) {
  ClosedSurface surface;
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "v") {
      Point p{};
      words >> p[0] >> p[1] >> p[2];
      surface.points.push_back(p);
    } else if (word == "f") {
      std::vector<Index> corners;
      while (words >> word) corners.push_back(static_cast<Index>(std::stoul(word)) - 1);
      add_polygon(surface, corners);
    }
    word.clear();
  }
  return surface;
}

ClosedSurface read_stl(const std::string& bytes) {
  ClosedSurface surface;
  std::map<Point, Index> seen;
  const auto add = [&](float x, float y, float z) {
    // Adding 0 makes -0 equal to 0 in the file's text too.
    const Point p{x + 0.0, y + 0.0, z + 0.0};
    const auto [at, is_new] = seen.try_emplace(p, static_cast<Index>(surface.points.size()));
    if (is_new) surface.points.push_back(p);
    surface.triangles.corners.push_back(at->second);
  };
  std::uint32_t count = 0;
  if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() == 84 + std::size_t{50} * count) {
    for (std::size_t t = 0; t < count; ++t) {
      float c[9];
      std::memcpy(c, bytes.data() + 84 + 50 * t + 12, sizeof c);
      for (std::size_t k = 0; k < 9; k += 3) add(c[k], c[k + 1], c[k + 2]);
    }
    return surface;
  }
  std::istringstream in(bytes);
  for (std::string word; in >> word;) {
    if (word != "vertex") continue;
    float x = 0, y = 0, z = 0;
    in >> x >> y >> z;
    add(x, y, z);
  }
  return surface;
}

}  // namespace

ClosedSurface read_surface(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  const std::string kind = path.extension().string();
  ClosedSurface surface;
  if (kind == ".off") {
    surface = read_off(in);
  } else if (kind == ".obj") {
    surface = read_obj(in);
  } else {
    std::ostringstream bytes;
    bytes << in.rdbuf();
    surface = read_stl(bytes.str());
  }
  surface.triangles.vertices = static_cast<Index>(surface.points.size());
  return surface;
}

}  // namespace multimesh::test
