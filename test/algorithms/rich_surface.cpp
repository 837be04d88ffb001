// SPDX-License-Identifier: BSD-3-Clause
#include "test/algorithms/rich_surface.hpp"

#include <cmath>
#include <map>
#include <random>

#include "multimesh/files/surface_file.hpp"

namespace multimesh::test {

const TexturedTriangles& spot() {
  static const TexturedTriangles surface = [] {
    TexturedTriangles s = files::read_surface(MULTIMESH_EXAMPLE_DATA "/spot/spot.obj").input;
    s.labels.clear();  // it has one material
    return s;
  }();
  return surface;
}

Vec3 centroid(const TexturedTriangles& s, std::size_t t) {
  Vec3 sum(0, 0, 0);
  for (const auto& c : s.triangles[t]) sum += s.positions[static_cast<std::size_t>(c.position)];
  return sum / 3.0;
}

void add_uv_set(TexturedTriangles& s, const Unwrap& unwrap, const std::function<bool(std::size_t)>& has) {
  TexturedTriangles::UvSet set;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    auto& corners = set.corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = has(t) ? static_cast<std::int32_t>(set.texcoords.size()) : -1;
      set.texcoords.push_back(unwrap(t, s.positions[static_cast<std::size_t>(s.triangles[t][i].position)]));
    }
  }
  s.more_uv_sets.push_back(std::move(set));
}

TexturedTriangles only_uv_set(const TexturedTriangles& surface, std::size_t set) {
  TexturedTriangles s = surface;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) s.triangles[t][i].texcoord = surface.texcoord(set, t, i);
  s.texcoords = surface.texcoords_of(set);
  s.more_uv_sets.clear();
  return s;
}

void jitter(TexturedTriangles& s, double by, unsigned seed) {
  std::mt19937 random(seed);
  const auto corner = [&](std::size_t i) {
    return s.positions[static_cast<std::size_t>(s.triangles[0][i].position)];
  };
  const double most = by * (corner(0) - corner(1)).norm();
  std::uniform_real_distribution<double> shift(-most, most);
  for (Vec3& p : s.positions)
    for (int i = 0; i < 3; ++i) p[i] += shift(random);
}

TexturedTriangles waves(double high) {
  TexturedTriangles s = two_charts().input;
  for (Vec3& p : s.positions) p[2] = high * std::sin(p[0] * 0.5 + 0.1 * p[1]) * std::cos(p[1] * 0.4);
  return s;
}

TexturedTriangles cube(int n) {
  TexturedTriangles s;
  std::map<std::array<int, 3>, std::int32_t> numbers;
  const auto number = [&](int axis, int high, int i, int j) {
    std::array<int, 3> p{};
    const auto a = static_cast<std::size_t>(axis);
    p[a] = high * n;
    p[(a + 1) % 3] = i;
    p[(a + 2) % 3] = j;
    const auto [at, is_new] = numbers.emplace(p, static_cast<std::int32_t>(s.positions.size()));
    if (is_new) s.positions.push_back({double(p[0]), double(p[1]), double(p[2])});
    return at->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int high = 0; high < 2; ++high)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int x, int y) {
            return TexturedTriangles::Corner{number(axis, high, i + x, j + y)};
          };
          std::array a{corner(0, 0), corner(1, 0), corner(1, 1)}, b{corner(0, 0), corner(1, 1), corner(0, 1)};
          if (!high) std::swap(a[0], a[1]), std::swap(b[0], b[1]);
          s.triangles.push_back(a);
          s.triangles.push_back(b);
        }
  return s;
}

namespace {

/// The face of the cube that a triangle lies in: 2 axis + (1 if high).
std::size_t face_of(const TexturedTriangles& s, std::size_t t, int n) {
  const Vec3 c = centroid(s, t);
  for (int axis = 0; axis < 3; ++axis)
    for (const int high : {0, 1})
      if (std::abs(c[axis] - high * n) < 1e-9) return static_cast<std::size_t>(2 * axis + high);
  return 0;
}

}  // namespace

void unwrap_to_faces(TexturedTriangles& s, int n) {
  add_texture(s, [&](std::size_t t, const Vec3& p) {
    const std::size_t face = face_of(s, t, n);
    const int axis = static_cast<int>(face) / 2;
    return Vec2(p[(axis + 1) % 3], p[(axis + 2) % 3]) / n + Vec2(2.0 * static_cast<double>(face), 0);
  });
}

//        +---+
//        | +y|          y up, x to the right on the front (+z); the faces to its left and right, above,
//        below,
//    +---+---+---+---+  and the back beside the right one
//    | -x| +z| +x| -z|
//    +---+---+---+---+
//        | -y|
//        +---+
void unwrap_to_cross(TexturedTriangles& s, int n) {
  add_texture(s, [&](std::size_t t, const Vec3& p) {
    const double x = p[0] / n, y = p[1] / n, z = p[2] / n;
    switch (face_of(s, t, n)) {
      case 0:
        return Vec2(z - 1, y);
      case 1:
        return Vec2(2 - z, y);
      case 2:
        return Vec2(x, z - 1);
      case 3:
        return Vec2(x, 2 - z);
      case 4:
        return Vec2(3 - x, y);
      default:
        return Vec2(x, y);
    }
  });
}

}  // namespace multimesh::test
