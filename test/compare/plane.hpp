// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>

#include "multimesh/algorithms/compare.hpp"

namespace multimesh::test {

/// A part of the plane z = 0, and how it is cut.
struct Part {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  int columns = 8, rows = 8;
};

/// 2 * columns * rows triangles. `uv` gives the texture coordinates of a point as a corner of a triangle with
/// this centroid; equal values are written once per corner.
inline TexturedTriangles plane(const Part& part,
                               const std::function<Vec2(const Vec3& p, const Vec3& centroid)>& uv) {
  TexturedTriangles s;
  for (int i = 0; i <= part.columns; ++i)
    for (int j = 0; j <= part.rows; ++j)
      s.positions.push_back({part.x0 + (part.x1 - part.x0) * i / part.columns,
                             part.y0 + (part.y1 - part.y0) * j / part.rows, 0});
  const auto add = [&](const std::array<std::int32_t, 3>& v) {
    Vec3 centroid(0, 0, 0);
    for (const auto i : v) centroid += s.positions[static_cast<std::size_t>(i)] / 3;
    std::array<TexturedTriangles::Corner, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = {v[i], static_cast<std::int32_t>(s.texcoords.size())};
      s.texcoords.push_back(uv(s.positions[static_cast<std::size_t>(v[i])], centroid));
    }
    s.triangles.push_back(t);
  };
  for (int i = 0; i < part.columns; ++i)
    for (int j = 0; j < part.rows; ++j) {
      const int a = i * (part.rows + 1) + j, b = a + part.rows + 1;
      add({a, b, b + 1});
      add({a, b + 1, a + 1});
    }
  return s;
}

/// One chart, texture coordinates = (x, y) / 4.
inline TexturedTriangles plane(const Part& part = {}) {
  return plane(part, [](const auto& p, const auto&) { return Vec2(p[0] / 4, p[1] / 4); });
}

}  // namespace multimesh::test
