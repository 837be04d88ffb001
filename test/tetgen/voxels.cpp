// SPDX-License-Identifier: BSD-3-Clause
#include "test/tetgen/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace multimesh::test {

using tetgen::Point;
using Voxel = std::array<int, 3>;

namespace {

Voxel next(Voxel v, int axis, int step = 1) {
  v[static_cast<std::size_t>(axis)] += step;
  return v;
}

/// Points of a grid, each once.
class GridPoints {
 public:
  explicit GridPoints(std::vector<Point>& points) : points_(points) {}
  Index operator()(const Voxel& v) {
    const auto [at, is_new] = number_.try_emplace(v, static_cast<Index>(points_.size()));
    if (is_new) points_.push_back({v[0] * 0.5, v[1] * 0.25, v[2] * 1.0});
    return at->second;
  }

 private:
  std::vector<Point>& points_;
  std::map<Voxel, Index> number_;
};

}  // namespace

Voxels::Voxels(int size, std::vector<int> materials) : size_(size), materials_(std::move(materials)) {}

Voxels Voxels::random(int size, int materials, double filled, std::mt19937& random) {
  std::vector<int> all(static_cast<std::size_t>(size * size * size));
  std::bernoulli_distribution is_filled(filled);
  std::uniform_int_distribution<int> one(1, materials);
  for (int& m : all) m = is_filled(random) ? one(random) : 0;
  return {size, all};
}

int Voxels::index(const Voxel& v) const {
  for (const int x : v)
    if (x < 0 || x >= size_) return -1;
  return (v[2] * size_ + v[1]) * size_ + v[0];
}

int Voxels::material(const Voxel& v) const {
  const int i = index(v);
  return i < 0 ? 0 : materials_[static_cast<std::size_t>(i)];
}

Voxel Voxels::voxel_at(const Point& p) const {
  return {static_cast<int>(std::floor(p[0] / 0.5)), static_cast<int>(std::floor(p[1] / 0.25)),
          static_cast<int>(std::floor(p[2]))};
}

void Voxels::add_walls(double share, std::mt19937& random) {
  std::bernoulli_distribution is_one(share);
  for (int z = 0; z < size_; ++z)
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Voxel v{x, y, z};
          if (material(v) != 0 && material(v) == material(next(v, axis)) && is_one(random)) add_wall(v, axis);
        }
}

bool Voxels::is_wall(const Voxel& v, int axis) const {
  return material(v) != material(next(v, axis)) || walls_.contains({v, axis});
}

Voxels::Surface Voxels::surface(Listing listing, std::mt19937& random) const {
  Surface s;
  GridPoints point(s.points);
  std::map<int, std::vector<std::array<Index, 3>>> by_solid;
  std::vector<std::pair<int, std::array<Index, 3>>> all;
  const auto add = [&](int m, const std::array<Index, 3>& t) {
    by_solid[m].push_back(t);
    all.emplace_back(m, t);
  };
  std::bernoulli_distribution coin(0.5);
  for (int z = -1; z < size_; ++z)
    for (int y = -1; y < size_; ++y)
      for (int x = -1; x < size_; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Voxel v{x, y, z}, far = next(v, axis);
          if (!is_wall(v, axis)) continue;
          const Voxel u = next(far, (axis + 1) % 3), w = next(far, (axis + 2) % 3),
                      uw = next(u, (axis + 2) % 3);
          const Index a = point(far), b = point(u), c = point(uw), d = point(w);
          // Normals along the axis, away from v; the other way round for its neighbour.
          for (const std::array<Index, 3>& t : {std::array{a, b, c}, std::array{a, c, d}}) {
            const std::array<Index, 3> back{t[1], t[0], t[2]};
            const int here = material(v), there = material(far);
            if (listing == Listing::once) {
              add(here != 0 ? here : there, coin(random) ? t : back);
            } else {
              if (here != 0) add(here, t);
              if (there != 0) add(there, back);
              if (here == 0 && there == 0) add(0, t);
            }
          }
        }
  const auto append = [&](int m, const std::array<Index, 3>& t) {
    s.triangles.corners.insert(s.triangles.corners.end(), t.begin(), t.end());
    s.material.push_back(m);
  };
  if (listing == Listing::by_solid)
    for (const auto& [m, triangles] : by_solid)
      for (const auto& t : triangles) append(m, t);
  else
    for (const auto& [m, t] : all) append(m, t);
  s.triangles.vertices = static_cast<Index>(s.points.size());
  return s;
}

std::vector<int> Voxels::parts() const {
  std::vector<int> part(materials_.size(), -1);
  const auto fill = [&](Voxel start, int number) {
    std::set<Voxel> seen{start};
    std::vector<Voxel> queue{start};
    while (!queue.empty()) {
      const Voxel v = queue.back();
      queue.pop_back();
      if (index(v) >= 0) part[static_cast<std::size_t>(index(v))] = number;
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          const Voxel n = next(v, axis, step);
          if (std::any_of(n.begin(), n.end(), [&](int x) { return x < -1 || x > size_; })) continue;
          if (!is_wall(step > 0 ? v : n, axis) && seen.insert(n).second) queue.push_back(n);
        }
    }
  };
  fill({-1, -1, -1}, 0);
  int number = 0;
  for (int i = 0; i < static_cast<int>(part.size()); ++i)
    if (part[static_cast<std::size_t>(i)] < 0)
      fill({i % size_, i / size_ % size_, i / size_ / size_}, ++number);
  return part;
}

}  // namespace multimesh::test
