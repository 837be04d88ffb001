// SPDX-License-Identifier: BSD-3-Clause
// Units do not matter: a model of another size, at another place, with other texture coordinates, is
// decimated by the same collapses.
#include <gtest/gtest.h>

#include <cmath>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

struct Left {
  TexturedTriangles surface;
  std::vector<Index> source;
  DecimateResult result;
};

Left decimated(const TexturedTriangles& input, double ratio, const DecimateOptions& more = {}) {
  TexturedSurface surface(input);
  DecimateOptions options = more;
  options.faces = static_cast<std::size_t>(ratio * static_cast<double>(input.triangles.size()));
  Left left;
  left.result = decimate(surface, options);
  left.surface = surface.triangles(left.source);
  return left;
}

template <class F, class G>
TexturedTriangles mapped(TexturedTriangles s, const F& in_space, const G& in_texture) {
  for (Vec3& p : s.positions) p = in_space(p);
  for (Vec2& p : s.texcoords) p = in_texture(p);
  return s;
}

class DecimateScale : public ::testing::TestWithParam<MadeSurface> {
 protected:
  const TexturedTriangles& input() const { return GetParam().input; }

  void expect_no_bit_changed(double scale) const {
    SCOPED_TRACE(scale);
    const auto in_space = [scale](const Vec3& p) { return Vec3(-p[0], -p[1], p[2]) * scale; };
    const auto in_texture = [](const Vec2& p) { return Vec2(-p[0], -p[1]) / 128.0; };
    DecimateOptions bounded;
    bounded.max_normal_deviation = 0.5;
    bounded.max_aspect_ratio = 15;
    for (const DecimateOptions& options : {DecimateOptions{}, bounded}) {
      const Left plain = decimated(input(), 0.1, options);
      const Left scaled = decimated(mapped(input(), in_space, in_texture), 0.1, options);
      EXPECT_GT(plain.result.collapsed, 0U);
      EXPECT_EQ(scaled.source, plain.source);
      EXPECT_EQ(scaled.result.tried, plain.result.tried);
      EXPECT_EQ(scaled.result.max_cost, plain.result.max_cost);
      const TexturedTriangles expected = mapped(plain.surface, in_space, in_texture);
      EXPECT_EQ(scaled.surface.positions, expected.positions);
      EXPECT_EQ(scaled.surface.texcoords, expected.texcoords);
    }
  }
};

std::vector<MadeSurface> surfaces() {
  std::vector<MadeSurface> all = made_surfaces();
  all.push_back({"Spot", spot(), {}, {}});
  all.push_back({"Waves", waves(), {}, {}});
  return all;
}

// Scaling by a power of two and a half turn are exact in floating point, and so must be everything that
// follows.
TEST_P(DecimateScale, PowersOfTwoChangeNoBit) {
  for (const double scale : {1024.0, 0x1p-30, 0x1p60, 0x1p-110, 0x1p110}) expect_no_bit_changed(scale);
}

TEST_P(DecimateScale, PowersOfTwoOfTheTextureChangeNoCollapse) {
  const auto same = [](const Vec3& p) { return p; };
  for (const double scale : {0x1p-100, 0x1p100}) {
    const auto in_texture = [scale](const Vec2& p) { return p * scale; };
    const Left plain = decimated(input(), 0.1), scaled = decimated(mapped(input(), same, in_texture), 0.1);
    EXPECT_EQ(scaled.source, plain.source) << scale;
  }
}

INSTANTIATE_TEST_SUITE_P(Made, DecimateScale, ::testing::ValuesIn(surfaces()),
                         [](const auto& p) { return p.param.name; });

/// A turn about (1, 2, 2) / 3 by 50 degrees.
Vec3 turned(const Vec3& p) {
  const Vec3 axis(1 / 3.0, 2 / 3.0, 2 / 3.0);
  const double c = std::cos(0.8727), s = std::sin(0.8727);
  return p * c + cross(axis, p) * s + axis * (dot(axis, p) * (1 - c));
}

// Rounding differs here, and would decide between edges of equal cost: jittered surfaces have none.
TEST(DecimateScale, ASimilarityOfSpaceAndOneOfTheTextureChangeNoCollapse) {
  const auto in_space = [](const Vec3& p) { return turned(p) * 1000.0 + Vec3(300, -2000, 50); };
  const auto in_texture = [](const Vec2& p) {
    return Vec2(0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1]) * 0.01 + Vec2(0.3, -0.1);
  };
  for (MadeSurface made : {sphere_with_charts(), slit(), polar_annulus(), half_without()}) {
    jitter(made.input, 0.1, 3);
    DecimateOptions exact;
    exact.memory_weight = 0;  // its single precision would have to be allowed for
    const Left plain = decimated(made.input, 0.2, exact);
    const TexturedTriangles scaled_input = mapped(made.input, in_space, in_texture);
    const Left scaled = decimated(scaled_input, 0.2, exact);
    ASSERT_EQ(scaled.source, plain.source) << made.name;
    EXPECT_EQ(scaled.result.tried, plain.result.tried);
    const auto in_unit = [](const Left& left, const TexturedTriangles& of) {
      return left.result.max_cost * bounding_box_diagonal(of.positions);  // which turning the model changes
    };
    EXPECT_NEAR(in_unit(scaled, scaled_input) / 1000, in_unit(plain, made.input), 1e-8);
    const TexturedTriangles expected = mapped(plain.surface, in_space, in_texture);
    ASSERT_EQ(scaled.surface.positions.size(), expected.positions.size()) << made.name;
    double off = 0;
    for (std::size_t v = 0; v < expected.positions.size(); ++v)
      off = std::max(off, (scaled.surface.positions[v] - expected.positions[v]).norm());
    EXPECT_LT(off, 1e-6 * 1000) << made.name;
  }
}

// An affine map of the texture is not a similarity, but measurements in space are independent of it.
TEST(DecimateScale, AnAffineMapOfTheTextureChangesNoCollapse) {
  const auto in_space = [](const Vec3& p) { return p; };
  const auto in_texture = [](const Vec2& p) {
    return Vec2(3 * p[0] + 0.5 * p[1] + 7, 0.2 * p[0] + 0.1 * p[1] - 2);
  };
  for (MadeSurface made : {sphere_with_charts(), slit(), half_without()}) {
    jitter(made.input, 0.1, 3);
    EXPECT_EQ(decimated(mapped(made.input, in_space, in_texture), 0.2).source,
              decimated(made.input, 0.2).source)
        << made.name;
  }
}

}  // namespace
}  // namespace multimesh::test
