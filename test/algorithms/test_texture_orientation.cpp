// SPDX-License-Identifier: BSD-3-Clause
// No triangle of a texture flips, however small: charts that are graded over many orders of magnitude.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "multimesh/algorithms/decimate.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

__extension__ using Quad = __float128;

/// Exact enough: differences of doubles and their products have at most 108 of 113 digits where the points
/// are of one order of magnitude.
int sign(const TexturedTriangles& s, std::size_t t) {
  const auto at = [&](std::size_t i) {
    return s.texcoords[static_cast<std::size_t>(s.triangles[t][i].texcoord)];
  };
  const Vec2 a = at(0), b = at(1), c = at(2);
  const Quad det = (Quad(b[0]) - a[0]) * (Quad(c[1]) - a[1]) - (Quad(b[1]) - a[1]) * (Quad(c[0]) - a[0]);
  return (det > 0) - (det < 0);
}

struct Grading {
  const char* name;
  Vec2 (*uv)(const Vec3&);  ///< of a point in [0, 1]^2
};

constexpr Grading gradings[] = {
    {"power", [](const Vec3& p) { return Vec2(std::pow(p[0], 12), p[1] * std::pow(p[0], 6)); }},
    {"strip", [](const Vec3& p) { return Vec2(p[0], 1e-13 * p[1]); }},
    {"far away", [](const Vec3& p) { return Vec2(1000 + 1e-9 * p[0], 1000 + 1e-9 * p[1]); }},
    {"corner", [](const Vec3& p) { return Vec2(std::exp(-30 * p[0]) * p[0], std::exp(-30 * p[0]) * p[1]); }},
    {"needle", [](const Vec3& p) { return Vec2(p[0] + p[1], p[0] + p[1] * (1 + 1e-12)); }}};

TexturedTriangles graded(const Grading& grading, unsigned seed, bool far_triangle) {
  TexturedTriangles s = waves(0.3);
  jitter(s, 0.2, seed);
  Vec3 low = s.positions[0], high = low;
  for (const Vec3& p : s.positions) low = min(low, p), high = max(high, p);
  s.texcoords.clear();
  for (const Vec3& p : s.positions)
    s.texcoords.push_back(grading.uv(
        {0.01 + 0.98 * (p[0] - low[0]) / (high[0] - low[0]), (p[1] - low[1]) / (high[1] - low[1]), 0}));
  for (auto& t : s.triangles)
    for (auto& c : t) c.texcoord = c.position;
  if (far_triangle) {  // of a chart of its own: it makes the diagonal of the texture large
    const auto v = static_cast<std::int32_t>(s.positions.size()),
               vt = static_cast<std::int32_t>(s.texcoords.size());
    for (int i = 0; i < 3; ++i) {
      s.positions.push_back(high + Vec3(i == 1, i == 2, 1));
      s.texcoords.push_back({i == 1 ? 1e5 : 0, i == 2 ? 1e5 : 0});
    }
    s.triangles.push_back({{{v, vt}, {v + 1, vt + 1}, {v + 2, vt + 2}}});
    if (!s.labels.empty()) s.labels.push_back(0);
  }
  return s;
}

TEST(TextureOrientation, NoTriangleFlipsWhateverItsSize) {
  std::size_t small = 0;
  for (const Grading& grading : gradings)
    for (unsigned seed = 0; seed < 3; ++seed)
      for (const bool far_triangle : {false, true}) {
        SCOPED_TRACE(std::string(grading.name) + ", seed " + std::to_string(seed));
        const TexturedTriangles input = graded(grading, seed, far_triangle);
        std::size_t negative_before = 0;
        for (std::size_t t = 0; t < input.triangles.size(); ++t) negative_before += sign(input, t) <= 0;
        for (const double ratio : {0.5, 0.2, 0.05}) {
          TexturedSurface surface(input);
          DecimateOptions options;
          options.faces = static_cast<std::size_t>(ratio * static_cast<double>(input.triangles.size()));
          small += decimate(surface, options).collapsed;
          std::vector<Index> source;
          const TexturedTriangles out = surface.triangles(source);
          std::size_t wrong = 0;
          for (std::size_t t = 0; t < out.triangles.size(); ++t)
            wrong += sign(out, t) != sign(input, source[t]) && sign(out, t) <= 0;
          if (negative_before == 0) {
            EXPECT_EQ(wrong, 0U) << ratio;
          }
        }
      }
  EXPECT_GT(small, 1000U) << "collapses there must be";
}

}  // namespace
}  // namespace multimesh::test
