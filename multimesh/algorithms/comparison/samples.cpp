// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/samples.hpp"

#include <cmath>
#include <random>

namespace multimesh::comparison {

namespace {

/// Uniform in [0, 1). The standard fixes the engine's numbers, not those of its distributions.
double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

double area(const TexturedTriangles& s, const Corners& t) {
  const Vec3& a = position(s, t[0]);
  return cross(position(s, t[1]) - a, position(s, t[2]) - a).norm() / 2;
}

}  // namespace

std::vector<Sample> sample(const TexturedTriangles& surface, std::size_t count, std::uint64_t seed) {
  std::vector<double> up_to;
  up_to.reserve(surface.triangles.size());
  double total = 0;
  for (const Corners& t : surface.triangles) up_to.push_back(total += area(surface, t));
  std::vector<Sample> samples;
  if (!(total > 0)) return samples;
  samples.reserve(count);
  std::mt19937_64 engine(seed);
  Index triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(i) + uniform(engine)) / static_cast<double>(count) * total;
    while (triangle + 1 < up_to.size() && up_to[triangle] <= at) ++triangle;
    const double r = std::sqrt(uniform(engine)), s = uniform(engine);
    samples.push_back({triangle, {1 - r, r * (1 - s), r * s}});
  }
  return samples;
}

}  // namespace multimesh::comparison
