// SPDX-License-Identifier: BSD-3-Clause
// Triangles oriented against their neighbours are reversed; then the result is as if they had not been.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/domains/shading.hpp"
#include "multimesh/domains/turn_reversed.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

/// Exchanges the last two corners, like a program that writes a triangle with the opposite orientation: its
/// normals then point to its back.
void turn(TexturedTriangles& s, std::size_t t) {
  std::swap(s.triangles[t][1], s.triangles[t][2]);
  for (auto& set : s.more_uv_sets) std::swap(set.corners[t][1], set.corners[t][2]);
  if (s.shading.empty()) return;
  const unsigned old = s.shading[t];
  s.shading[t] = static_cast<std::uint8_t>((old & 2U) | (old & 1U) << 2U | (old & 4U) >> 2U | (old & 24U));
  s.shading[t] ^= normals_behind;
}

/// Three in ten, by chance. \return how many
std::size_t turn_some(TexturedTriangles& s, unsigned seed) {
  std::mt19937 random(seed);
  std::size_t turned = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (random() % 10 < 3) turn(s, t), ++turned;
  return turned;
}

void expect_same(const TexturedTriangles& a, const TexturedTriangles& b) {
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(a.triangles[t][i].position, b.triangles[t][i].position);
      EXPECT_EQ(a.triangles[t][i].texcoord, b.triangles[t][i].texcoord);
      for (std::size_t set = 1; set < a.uv_sets(); ++set)
        EXPECT_EQ(a.texcoord(set, t, i), b.texcoord(set, t, i));
    }
  EXPECT_EQ(a.shading, b.shading);
}

/// Two of them beside each other, which share nothing.
TexturedTriangles twice(const TexturedTriangles& s) {
  TexturedTriangles both = s;
  const auto by = static_cast<std::int32_t>(s.positions.size());
  for (const auto& p : s.positions) both.positions.push_back(p + Vec3(100, 0, 0));
  for (auto t : s.triangles) {
    for (auto& c : t) c.position += by;
    both.triangles.push_back(t);
  }
  return both;
}

std::vector<MadeSurface> surfaces() {
  std::vector<MadeSurface> all = {one_chart(),     two_charts(),   mirrored_chart(),     half_without(),
                                  polar_annulus(), tiled_torus(),  sphere_with_charts(), book(),
                                  pinched(),       self_touching()};
  all.push_back({"Spot", spot(), {}, {}});
  all.push_back({"TwoSpheres", twice(sphere_with_charts().input), {}, {}});
  MadeSurface shaded = two_charts();
  shaded.name = "Shaded";
  std::mt19937 random(5);
  for (std::size_t t = 0; t < shaded.input.triangles.size(); ++t)
    shaded.input.shading.push_back(static_cast<std::uint8_t>(random() % 32));
  add_uv_set(shaded.input, [](std::size_t, const Vec3& p) { return Vec2(p[1], p[0]); });
  all.push_back(std::move(shaded));
  return all;
}

class TurnReversed : public ::testing::TestWithParam<MadeSurface> {};

TEST_P(TurnReversed, GivesTheInputWhoseTrianglesAgree) {
  const TexturedTriangles& right = GetParam().input;
  for (unsigned seed = 0; seed < 5; ++seed) {
    TexturedTriangles given = right;
    const std::size_t turned = turn_some(given, seed);
    const std::size_t found = turn_reversed(TexturedSurface(given), given);
    EXPECT_EQ(found, turned);
    expect_same(given, right);
  }
}

TEST_P(TurnReversed, ThenDecimationIsThatOfTheInputWhoseTrianglesAgree) {
  const auto decimated = [](const TexturedTriangles& input, std::vector<Index>& source) {
    TexturedSurface surface(input);
    DecimateOptions options;
    options.faces = input.triangles.size() / 4;
    (void)decimate(surface, options);
    return surface.triangles(source);
  };
  TexturedTriangles given = GetParam().input;
  turn_some(given, 9);
  (void)turn_reversed(TexturedSurface(given), given);
  std::vector<Index> source, expected_source;
  const TexturedTriangles out = decimated(given, source),
                          expected = decimated(GetParam().input, expected_source);
  EXPECT_EQ(source, expected_source);
  EXPECT_EQ(out.positions, expected.positions);
  EXPECT_EQ(facts(out), facts(expected));
}

INSTANTIATE_TEST_SUITE_P(Made, TurnReversed, ::testing::ValuesIn(surfaces()),
                         [](const auto& p) { return p.param.name; });

TEST(TurnReversed, WhatAgreesIsLeftAlone) {
  for (const MadeSurface& made : surfaces()) {
    TexturedTriangles input = made.input;
    EXPECT_EQ(turn_reversed(TexturedSurface(input), input), 0U) << made.name;
  }
}

}  // namespace
}  // namespace multimesh::test
