// SPDX-License-Identifier: BSD-3-Clause
// subdivide IN.obj OUT.obj LEVELS: every triangle becomes four, by the midpoints of its edges in space and in
// the texture. Same surface, same charts and seams, 4^LEVELS times as many faces. Materials and normals are
// left out.
#include <charconv>
#include <exception>
#include <iostream>
#include <string_view>
#include <unordered_map>

#include "test/benchmark/plain_obj.hpp"

namespace multimesh::bench {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Appends the midpoints to `points`. A seam edge has two edges of the texture over it, and two midpoints
/// there.
template <std::size_t n>
std::vector<Triangle> subdivide(const std::vector<Triangle>& faces,
                                std::vector<std::array<double, n>>& points) {
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints;
  midpoints.reserve(faces.size() * 3 / 2 + 1);
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    if (a == PlainObj::none || b == PlainObj::none) return PlainObj::none;
    if (a > b) std::swap(a, b);
    const auto fresh = static_cast<std::uint32_t>(points.size());
    const auto [it, is_new] = midpoints.try_emplace(std::uint64_t{a} << 32 | b, fresh);
    if (is_new) {
      std::array<double, n> middle;
      for (std::size_t k = 0; k < n; ++k) middle[k] = (points[a][k] + points[b][k]) / 2;
      points.push_back(middle);
    }
    return it->second;
  };
  std::vector<Triangle> result;
  result.reserve(4 * faces.size());
  for (const auto& [a, b, c] : faces) {
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    result.insert(result.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

int levels_of(std::string_view text) {
  int levels = -1;
  std::from_chars(text.data(), text.data() + text.size(), levels);
  return levels;
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) try {
  using namespace multimesh::bench;
  const int levels = argc == 4 ? levels_of(argv[3]) : -1;
  if (levels < 0) {
    std::cerr << "Usage: subdivide IN.obj OUT.obj LEVELS\n";
    return 2;
  }
  PlainObj obj = read_plain_obj(argv[1]);
  for (int i = 0; i < levels; ++i) {
    obj.faces = subdivide(obj.faces, obj.positions);
    obj.uv_faces = subdivide(obj.uv_faces, obj.texcoords);
  }
  write_plain_obj(argv[2], obj);
} catch (const std::exception& e) {
  std::cerr << "subdivide: " << e.what() << '\n';
  return 1;
}
