// SPDX-License-Identifier: BSD-3-Clause
// The cost of a collapse: sums that are kept up to date against sums made anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "multimesh/validate.hpp"
#include "test/algorithms/cost_cases.hpp"

namespace multimesh::test {
namespace {

using decimation::CollapseCost;
using decimation::CollapsePlan;

/// How far two plans are apart, relative to the edge, its copies in the texture, and what costs are made of.
struct Difference {
  double cost = 0, position = 0, texcoord = 0;
};

Difference difference(const TexturedSurface& surface, const CollapsePlan& x, const CollapsePlan& y,
                      double area) {
  const double edge = (surface.positions()[x.a] - surface.positions()[x.b]).norm();
  Difference d;
  d.cost = std::abs(x.cost - y.cost) / (std::max(x.cost, y.cost) + 1e-6 * area * edge * edge);
  d.position = (x.position - y.position).norm() / edge;
  for (std::size_t i = 0; i < x.n_copies; ++i) {
    const auto& uv = surface.texcoords(x.copy_list[i].set);
    const double scale = (uv[x.copy_list[i].a] - uv[x.copy_list[i].b]).norm() + 1e-3;
    d.texcoord = std::max(d.texcoord, (x.copy_list[i].texcoord - y.copy_list[i].texcoord).norm() / scale);
  }
  return d;
}

/// The area of the triangles around the ends of an edge.
double area_around(const TexturedSurface& surface, Dart e) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  double area = 0;
  for (const Dart end : {e, root.reorder(e, exchange_ends)}) {
    DartBuffer star;
    root.star(end, 0, star);
    for (const Dart d : star) {
      std::array<Index, 4> v{};
      root.vertices(d, v.data());
      const auto& p = surface.positions();
      area += cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]).norm() / 2;
    }
  }
  return area;
}

bool same_copies(const CollapsePlan& x, const CollapsePlan& y) {
  const auto sorted = [](const CollapsePlan& plan) {
    std::vector<std::array<std::size_t, 3>> list;
    for (const auto& c : plan.copies()) list.push_back({c.set, c.a, c.b});
    return list;
  };
  return sorted(x) == sorted(y);
}

class KeptSums : public ::testing::TestWithParam<CostCase> {
 protected:
  TexturedSurface surface{GetParam().input, GetParam().options};
  DecimateOptions options = memoryless();

  void collapse_and_compare(const std::function<std::size_t(CollapseDriver&, std::size_t wanted)>& collapse) {
    CollapseDriver driver(surface, options);
    const std::size_t wanted = surface.live_triangles() / 12;
    std::size_t done = 0;
    for (int round = 0; round < 4; ++round) {
      SCOPED_TRACE("round " + std::to_string(round));
      done += collapse(driver, wanted);
      ASSERT_NO_FATAL_FAILURE(compare(driver));
    }
    EXPECT_GT(done, wanted) << "nearly everything was refused: the test says little";
    EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  }

  void compare(const CollapseDriver& driver) {
    const Mesh& root = driver.root();
    const FreshCost fresh(surface, options);
    const CollapseCost& anew = fresh.cost;
    for (Index v = 0; v < root.capacity(0); ++v)
      ASSERT_TRUE(!root.is_live(0, v) || driver.ranks().rank(v) == fresh.ranks.rank(v)) << "vertex " << v;
    compared = off = 0;
    for (const Dart e : edges_of(root)) {
      const auto kept = driver.cost().plan(e), made = anew.plan(e);
      ASSERT_EQ(kept.has_value(), made.has_value());
      const double area = area_around(surface, e);
      if (kept) {
        ASSERT_NO_FATAL_FAILURE(compare(*kept, *made, area));
      }
      for (const double t : {0.0, 0.3, 1.0})
        ASSERT_NO_FATAL_FAILURE(compare(driver.cost().plan_at(e, t), anew.plan_at(e, t), area));
    }
    // A triangle that was a sliver in the texture for a time leaves roundings behind.
    EXPECT_LE(off, compared / 50 + 2) << "of " << compared;
  }

  void compare(const CollapsePlan& kept, const CollapsePlan& made, double area) {
    ASSERT_TRUE(same_copies(kept, made));
    const Difference d = difference(surface, kept, made, area);
    const double most = std::max({d.cost, d.position, d.texcoord, std::abs(kept.t - made.t)});
    ASSERT_LT(most, 0.05) << "edge " << made.a << ", " << made.b;
    ++compared;
    off += most > 1e-7;
  }

  std::size_t compared = 0, off = 0;
};

TEST_P(KeptSums, EqualSumsMadeAnewAfterTheCheapestCollapses) {
  collapse_and_compare([](CollapseDriver& driver, std::size_t n) { return driver.collapse_cheapest(n); });
}

TEST_P(KeptSums, EqualSumsMadeAnewAfterRandomCollapses) {
  std::mt19937 random(5);
  collapse_and_compare(
      [&](CollapseDriver& driver, std::size_t n) { return driver.collapse_some(n, random); });
}

TEST_P(KeptSums, EqualSumsMadeAnewWithHeavyTextureAndCurves) {
  options.uv_weight = 2;
  options.curve_weight = 30;
  options.seam_weight = 7;
  options.uv_curve_weight = 20;
  std::mt19937 random(6);
  collapse_and_compare(
      [&](CollapseDriver& driver, std::size_t n) { return driver.collapse_some(n, random); });
}

INSTANTIATE_TEST_SUITE_P(CollapseCost, KeptSums, ::testing::ValuesIn(cost_cases()),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace multimesh::test
