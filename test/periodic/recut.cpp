// SPDX-License-Identifier: BSD-3-Clause
#include "test/periodic/recut.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "test/periodic/tiles.hpp"

namespace multimesh::test {

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  // columns

int pick(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}
double real(std::mt19937& random, double low, double high) {
  return low + (high - low) * double(random() % 10001) / 10000;
}

Vector combine(const Matrix& m, const Vector& c) {
  Vector sum{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += c[k] * m[k][i];
  return sum;
}

/// Not far from orthogonal, of different lengths.
Matrix oblique(int d, std::mt19937& random) {
  Matrix m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
    for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i)
      m[k][i] = i == k ? real(random, 0.7, 1.5) : real(random, -0.2, 0.2);
  return m;
}

/// Columns of integers with determinant 1 that mix the periods.
std::array<LatticeVector, 3> unimodular(int d, std::mt19937& random) {
  std::array<LatticeVector, 3> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int step = 0; step < 2; ++step) {
    const auto i = static_cast<std::size_t>(pick(random, 0, d - 1));
    const auto j = (i + static_cast<std::size_t>(pick(random, 1, d - 1))) % static_cast<std::size_t>(d);
    m[i] = random() % 2 ? m[i] + m[j] : m[i] - m[j];
  }
  return m;
}

/// How far a facet is moved, by its middle in units of the grid's periods.
class Mover {
 public:
  Mover(int d, Recut how, std::mt19937& random) : d_(d), how_(how) {
    axis_ = static_cast<std::size_t>(pick(random, 0, d - 1));
    second_ = (axis_ + 1) % static_cast<std::size_t>(d);
    for (auto& v : block_)
      for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) v[i] = pick(random, -1, 1);
  }

  LatticeVector operator()(const Vector& middle) const {
    LatticeVector back{};
    if (how_ == Recut::rows) {
      back[second_] = middle[axis_] > 0.5 && middle[second_] > 0.5 ? -1 : 0;
    } else if (how_ == Recut::plane) {
      back[axis_] = middle[axis_] + 0.6 * middle[second_] > 1.1 ? -1 : 0;
    } else {
      std::size_t block = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(d_); ++i) block = 2 * block + (middle[i] > 0.5);
      return block_[block];
    }
    return back;
  }

 private:
  int d_;
  Recut how_;
  std::size_t axis_ = 0, second_ = 0;
  std::array<LatticeVector, 8> block_{};
};

}  // namespace

RecutTorus recut_torus(int d, Index n, Recut how, std::mt19937& random) {
  const PeriodicTile grid = d == 2 ? square_tile(n, n) : cube_tile(n);
  const Matrix periods = oblique(d, random);
  const Mover move(d, how, random);
  RecutTorus torus;
  torus.tile.facets.dimension = d;
  // Vertices by their places in the grid, so that parts that come to lie side by side are joined there.
  std::map<LatticeVector, Index> vertex;
  std::vector<std::size_t> order(grid.facets.size());
  for (std::size_t f = 0; f < order.size(); ++f) order[f] = f;
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t f : order) {
    Vector middle{};
    for (const Index v : grid.facets.facet(f))
      for (std::size_t i = 0; i < 3; ++i) middle[i] += grid.points[v][i] / (d + 1);
    const LatticeVector by = move(middle);
    for (const Index v : grid.facets.facet(f)) {
      LatticeVector place{};
      Vector c{};
      for (std::size_t i = 0; i < 3; ++i) {
        place[i] = static_cast<int>(std::lround(grid.points[v][i] * n)) + static_cast<int>(n) * by[i];
        c[i] = double(place[i]) / n;
      }
      const auto [entry, is_new] = vertex.try_emplace(place, static_cast<Index>(torus.tile.points.size()));
      torus.tile.facets.corners.push_back(entry->second);
      if (is_new) torus.tile.points.push_back(combine(periods, c));
    }
  }
  torus.options.axes = {true, true, d == 3};
  torus.options.periods.emplace();
  const auto basis = unimodular(d, random);
  for (std::size_t k = 0; k < 3; ++k)
    (*torus.options.periods)[k] =
        combine(periods, {double(basis[k][0]), double(basis[k][1]), double(basis[k][2])});
  const std::size_t v = d == 2 ? n * n : n * n * n;
  torus.simplices = d == 2 ? std::array<std::size_t, 4>{v, 3 * v, 2 * v, 0}
                           : std::array<std::size_t, 4>{v, 7 * v, 12 * v, 6 * v};
  return torus;
}

}  // namespace multimesh::test
