// SPDX-License-Identifier: BSD-3-Clause
// Quadratic forms against what they are sums of.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "test/algorithms/collapse_driver.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

using namespace decimation;

class RandomVectors {
 public:
  Vec3 operator()(double size = 1) { return Vec3(d_(r_), d_(r_), d_(r_)) * size; }
  Vec3 unit() { return (*this)().normalized(); }
  double weight() { return 1.5 + d_(r_); }

 private:
  std::mt19937 r_{20261125};
  std::uniform_real_distribution<double> d_{-1, 1};
};

TEST(PositionForm, MinimumIsWhereTheDerivativeVanishes) {
  RandomVectors random;
  for (int trial = 0; trial < 100; ++trial) {
    PositionForm a;
    for (int i = 0; i < 4; ++i) a.add(PositionForm::plane(random.unit(), random.weight()), 1);
    const Vec3 f = random(), x = minimum(a, f);
    EXPECT_LT((a.times(x) + f).norm(), 1e-9 * (1 + x.norm()) * a.trace());
  }
  EXPECT_EQ(minimum({}, random()), Vec3(0, 0, 0)) << "a singular form has none";
}

// Vertices that move and merge, as in a run, against the planes themselves.
TEST(PlanesForm, SumsDistancesFromPlanesThroughMovesAndMerges) {
  RandomVectors random;
  struct Plane {
    Vec3 n;
    double offset, weight;
  };
  struct Vertex {
    Vec3 position;
    PlanesForm form;
    std::vector<Plane> planes;
  };
  std::vector<Vertex> vertices(16);
  for (Vertex& v : vertices) {
    v.position = random(10);
    for (int i = 0; i < 6; ++i) {
      const Plane p{random.unit(), 0, random.weight()};
      v.planes.push_back({p.n, dot(p.n, v.position), p.weight});
      v.form.add_plane(p.n, p.weight);
    }
  }
  while (vertices.size() > 1) {
    Vertex gone = vertices.back();
    vertices.pop_back();
    Vertex& kept = vertices[vertices.size() / 2];
    const Vec3 place = (kept.position + gone.position) * 0.5 + random(0.1);
    kept.form.move(place - kept.position);
    gone.form.move(place - gone.position);
    kept.form.merge(gone.form);
    kept.position = place;
    kept.planes.insert(kept.planes.end(), gone.planes.begin(), gone.planes.end());
    const Vec3 x = random(0.5);
    double sum = 0, scale = 0;
    for (const Plane& p : kept.planes) {
      const double d = dot(p.n, place + x) - p.offset;
      sum += p.weight * d * d;
      scale += p.weight;
    }
    EXPECT_NEAR(kept.form(x), sum, 1e-5 * (sum + scale)) << "single precision";
  }
}

// At the start, the planes of the input are those of the surface.
TEST(Memory, CountsTheInputsPlanesByItsWeight) {
  TexturedSurface surface(sphere_with_charts().input);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  const auto cost_of = [&](double memory, Dart e) {
    DecimateOptions options;
    options.uv_weight = 0;
    options.memory_weight = memory;
    return FreshCost(surface, options).cost.plan_at(e, 0.5).cost;
  };
  for (const Index e : {0U, 100U, 1000U, 2000U}) {
    const Dart d = root.dart_of(1, e);
    const double without = cost_of(0, d);
    EXPECT_GT(without, 0);
    EXPECT_NEAR(cost_of(0.5, d), 1.5 * without, 1e-4 * without) << "edge " << e;
  }
}

}  // namespace
}  // namespace multimesh::test
