// SPDX-License-Identifier: BSD-3-Clause
// Atlases whose charts touch: the deviation is measured within the chart, not to the other end of the model,
// which the neighbour in the atlas shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "test/compare/plane.hpp"

namespace multimesh::test {
namespace {

/// The unit square in side x side charts, each in a randomly drawn cell of the atlas, with a gap around it
/// relative to the cell.
class Atlas {
 public:
  Atlas(int side, double gap, unsigned seed)
      : side_(side), gap_(gap), cell_(static_cast<std::size_t>(side * side)) {
    for (std::size_t i = 0; i < cell_.size(); ++i) cell_[i] = static_cast<int>(i);
    std::mt19937 random(seed);
    std::shuffle(cell_.begin(), cell_.end(), random);
  }

  /// Each chart enlarged in the atlas by a factor around its middle.
  TexturedTriangles surface(int columns_per_chart, double swollen) const {
    const int n = side_ * columns_per_chart;
    return plane({0, 1, 0, 1, n, n}, [&](const Vec3& p, const Vec3& centroid) {
      const int i = static_cast<int>(centroid[0] * side_), j = static_cast<int>(centroid[1] * side_);
      const int cell = cell_[static_cast<std::size_t>(i * side_ + j)];
      const Vec2 middle(0.5, 0.5), inside = Vec2(p[0] * side_ - i, p[1] * side_ - j);
      const Vec2 at = middle + (inside - middle) * swollen * (1 - gap_);
      return (at + Vec2(cell / side_, cell % side_)) / side_;
    });
  }

 private:
  int side_;
  double gap_;
  std::vector<int> cell_;
};

SurfaceComparison compared(const TexturedTriangles& original, const TexturedTriangles& other) {
  CompareOptions options;
  options.samples = 5000;
  options.per_vertex = true;
  return compare_surfaces(original, other, options);
}

TEST(ComparePackedAtlas, MeasuresWithinTheChart) {
  for (const int side : {2, 3, 7, 12})
    for (const double gap : {0.0, 1e-6, 0.02})
      for (const double swollen : {1.0, 1.001, 1.05, 1.2}) {
        SCOPED_TRACE(std::to_string(side) + " charts a side, gap " + std::to_string(gap) + ", swollen by " +
                     std::to_string(swollen));
        const Atlas atlas(side, gap, static_cast<unsigned>(side));
        const auto c = compared(atlas.surface(6, 1), atlas.surface(2, swollen));
        // From the middle of a chart to its corner it is 1 / side / sqrt(2), of a diagonal of sqrt(2).
        const double most = (swollen - 1) * 0.5 / side + 5e-5;
        EXPECT_LE(c.texture->deviation.max, most);
        EXPECT_LE(*std::max_element(c.vertex_deviation.begin(), c.vertex_deviation.end()), most);
        EXPECT_LE(c.texture->crack.max, 2 * most);
        if (swollen == 1.0) {
          EXPECT_LT(c.texture->outside_own, 0.001);
        } else {
          EXPECT_NEAR(c.texture->outside_own, 1 - 1 / (swollen * swollen), 0.03);
        }
      }
}

TEST(ComparePackedAtlas, AWrongChartIsStillSeen) {
  // The texture coordinates of two charts exchanged: each shows what belongs to the other.
  const Atlas atlas(4, 0, 1);
  const TexturedTriangles original = atlas.surface(4, 1);
  TexturedTriangles other = original;
  const auto chart = [](const TexturedTriangles& s, std::size_t t) {
    Vec3 middle(0, 0, 0);
    for (const auto& c : s.triangles[t]) middle += s.positions[static_cast<std::size_t>(c.position)] / 3;
    return std::pair(static_cast<int>(middle[0] * 4), static_cast<int>(middle[1] * 4));
  };
  std::vector<std::size_t> one, two;
  for (std::size_t t = 0; t < other.triangles.size(); ++t) {
    if (chart(other, t) == std::pair(0, 0)) one.push_back(t);
    if (chart(other, t) == std::pair(3, 3)) two.push_back(t);
  }
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      std::swap(other.triangles[one[i]][k].texcoord, other.triangles[two[i]][k].texcoord);
  const auto c = compared(original, other);
  EXPECT_NEAR(c.texture->deviation.max, 0.75, 1e-3) << "three quarters of the diagonal";
  EXPECT_NEAR(c.texture->deviation.mean, 0.75 * 2 / 16, 0.01);
}

}  // namespace
}  // namespace multimesh::test
