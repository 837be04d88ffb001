// SPDX-License-Identifier: BSD-3-Clause
// The cost of a collapse: the least of the deviation against brute force from its
// definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "test/algorithms/cost_cases.hpp"

namespace multimesh::test {
namespace {

using decimation::CollapseCost;
using decimation::CollapsePlan;
using decimation::Rank;

/// The deviation of a merged vertex by its definition, triangle by triangle.
class Definition {
 public:
  Definition(const TexturedSurface& surface, const DecimateOptions& options)
      : surface_(surface), options_(options), tree_(surface.tree()), root_(tree_.mesh(NodeId::root)) {}

  double deviation(Dart e, const CollapsePlan& plan) {
    trace_ = 0;
    double sum = 0;
    for (const bool at_a : {true, false}) {
      const Dart end = at_a ? e : root_.reorder(e, exchange_ends);
      DartBuffer star;
      root_.star(end, 0, star);
      for (const Dart d : star) sum += of_triangle(d, plan, at_a);
    }
    const Vec3 edge = surface_.positions()[plan.a] - surface_.positions()[plan.b];
    return sum + 1e-8 * trace_ * edge.squared_norm();
  }
  /// Of the forms in position at both ends.
  double trace() const { return trace_; }

 private:
  struct Copy {
    std::array<Index, 4> v{};
    Vec3 du, dv;
    Dart dart;
  };

  // Corner 0 of d is the one that moves.
  double of_triangle(Dart d, const CollapsePlan& plan, bool at_a) {
    std::array<Index, 4> v{};
    root_.vertices(d, v.data());
    const auto& p = surface_.positions();
    const Vec3 e = p[v[1]] - p[v[0]], f = p[v[2]] - p[v[0]];
    const double area = cross(e, f).norm() / 2;
    if (area == 0) return 0;
    const Vec3 normal = cross(e, f) / (2 * area), x = plan.position - p[v[0]];
    const double distance = dot(normal, x);
    double sum = area / 3 * distance * distance;
    trace_ += area / 3;
    for (const Dart side : {d, root_.switch_dart(d, 1)}) sum += of_curve(side, normal, x);
    for (std::size_t k = 0; k < surface_.textures().size(); ++k) {
      const NodeId node = surface_.textures()[k];
      const Mesh& texture = tree_.mesh(node);
      const Dart copy = tree_.facet_copy(node, d);
      if (copy == no_dart) continue;
      std::array<Index, 4> c{};
      texture.vertices(copy, c.data());
      const auto& uv = surface_.texcoords(k);
      const Vec2 r = uv[c[1]] - uv[c[0]], s = uv[c[2]] - uv[c[0]];
      const double determinant = r[0] * s[1] - r[1] * s[0];
      if (std::abs(determinant) < 1e-13) continue;
      Vec2 y(0, 0);
      for (const auto& moved : plan.copies())
        if (moved.set == k && (at_a ? moved.a : moved.b) == c[0]) y = moved.texcoord - uv[c[0]];
      // y = alpha r + beta s is the content of the point alpha e + beta f.
      const double alpha = (y[0] * s[1] - y[1] * s[0]) / determinant;
      const double beta = (r[0] * y[1] - r[1] * y[0]) / determinant;
      const Vec3 content = e * alpha + f * beta;
      sum += options_.uv_weight * area / 3 * (x - normal * distance - content).squared_norm();
      trace_ += options_.uv_weight * area / 3 * 2;
      for (const Dart side : {copy, texture.switch_dart(copy, 1)}) {
        if (!texture.is_boundary(side, 1)) continue;
        const Vec3 along = side == copy ? e : f;
        const double off = dot(cross(normal, along).normalized(), content);
        sum += options_.uv_weight * options_.uv_curve_weight * along.squared_norm() * off * off;
      }
    }
    return sum;
  }

  double of_curve(Dart side, const Vec3& normal, const Vec3& x) {
    CurveKinds seams = no_curve;
    for (std::size_t k = 0; k < surface_.textures().size(); ++k) seams |= seam_of(k);
    const CurveKinds kinds = surface_.curve_kinds(side);
    const bool boundary = root_.is_boundary(side, 1);
    if (!boundary && kinds == no_curve) return 0;
    const double weight = boundary || (kinds & ~seams) != 0 ? options_.curve_weight : options_.seam_weight;
    const auto& p = surface_.positions();
    const Vec3 along = p[root_.vertex(side)] - p[root_.vertex(root_.reorder(side, exchange_ends))];
    const double off = dot(cross(normal, along).normalized(), x);
    trace_ += weight * along.squared_norm();
    return weight * along.squared_norm() * off * off;
  }

  const TexturedSurface& surface_;
  const DecimateOptions& options_;
  const MultiMesh& tree_;
  const Mesh& root_;
  double trace_ = 0;
};

class Least : public ::testing::TestWithParam<CostCase> {
 protected:
  TexturedSurface surface{GetParam().input, GetParam().options};
  DecimateOptions options = memoryless();

  void run() {
    CollapseDriver driver(surface, options);
    std::mt19937 random(11);
    (void)driver.collapse_some(surface.live_triangles() / 20, random);
    const FreshCost fresh(surface, options);
    const CollapseCost& anew = fresh.cost;
    std::size_t n = 0;
    for (const Dart e : edges_of(driver.root())) {
      const auto plan = anew.plan(e);
      if (!plan) continue;
      if (driver.ranks().rank(plan->a) == Rank::fixed && driver.ranks().rank(plan->b) == Rank::fixed)
        continue;  // never collapsed
      compare(e, *plan, driver, anew, random);
      if (HasFailure()) return;
      ++n;
    }
    EXPECT_GT(n, 100U);
    EXPECT_LE(not_least, n / 50) << "of " << n << "; at slivers of the texture the place is not sought";
  }

  void compare(Dart e, const CollapsePlan& plan, const CollapseDriver& driver, const CollapseCost& anew,
               std::mt19937& random) {
    Definition definition(surface, options);
    const double edge = (surface.positions()[plan.a] - surface.positions()[plan.b]).norm();
    const double here = definition.deviation(e, plan), unit = definition.trace() * edge * edge;
    ASSERT_NEAR(plan.cost, here, 1e-5 * here + 1e-12 * unit);
    if (driver.ranks().rank(plan.a) != driver.ranks().rank(plan.b)) return;  // its place is given
    for (const double t : {0.0, 0.4, 1.0}) {
      const CollapsePlan on_edge = anew.plan_at(e, t);
      const double there = definition.deviation(e, on_edge);
      ASSERT_NEAR(on_edge.cost, there, 1e-5 * there + 1e-12 * unit) << t;
    }
    std::uniform_real_distribution<double> size(-1, 1);
    const Vec3 middle = (surface.positions()[plan.a] + surface.positions()[plan.b]) * 0.5;
    for (int i = 0; i < 12; ++i) {
      const double much = std::pow(10.0, -i % 4);
      CollapsePlan other = plan;
      if (i % 3 != 1)
        for (int k = 0; k < 3; ++k) other.position[k] += much * edge * size(random);
      for (auto& c : other.copies()) {
        const auto& uv = surface.texcoords(c.set);
        const double scale = (uv[c.a] - uv[c.b]).norm();
        if (i % 3 != 0) c.texcoord += Vec2(size(random), size(random)) * (much * scale);
      }
      // The best place is that of the deviation and a small pull to the middle.
      const double pull = 1e-8 * definition.trace() * (other.position - middle).squared_norm();
      if (plan.cost > definition.deviation(e, other) + pull + 1e-5 * here + 1e-12 * unit) {
        ++not_least;
        break;
      }
    }
  }

  std::size_t not_least = 0;
};

TEST_P(Least, IsThatOfTheDefinition) {
  run();
}

TEST_P(Least, IsThatOfTheDefinitionWithOtherWeights) {
  options.uv_weight = 1.5;
  options.curve_weight = 4;
  options.seam_weight = 2;
  options.uv_curve_weight = 0.7;
  run();
}

INSTANTIATE_TEST_SUITE_P(CollapseCost, Least, ::testing::ValuesIn(cost_cases()),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace multimesh::test
