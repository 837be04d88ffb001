// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <random>
#include <utility>

#include "multimesh/domains/tet_domain.hpp"

namespace multimesh::test {

/// Some of the tetrahedra of a grid of n^3 cubes, six each; its points may be moved a little.
class RandomSolid {
 public:
  explicit RandomSolid(unsigned seed) : random_(seed) {
    n_ = 2 + static_cast<int>(random_() % 2);
    const bool by_tets = random_() % 2, moved = random_() % 2, regions = random_() % 3 == 0;
    share_ = 3 + static_cast<unsigned>(random_() % 6);
    for (int k = 0; k <= n_; ++k)
      for (int j = 0; j <= n_; ++j)
        for (int i = 0; i <= n_; ++i)
          list_.points.push_back({i + jitter(moved), j + jitter(moved), k + jitter(moved)});
    for (int k = 0; k < n_; ++k)
      for (int j = 0; j < n_; ++j)
        for (int i = 0; i < n_; ++i) add_cube({i, j, k}, by_tets, regions);
    while (list_.tets.corners.empty()) add_cube({0, 0, 0}, false, false);
    list_.tets.vertices = static_cast<Index>(list_.points.size());
  }
  const TaggedTetrahedra& list() const { return list_; }

 private:
  double jitter(bool moved) { return moved ? (static_cast<double>(random_() % 1001) - 500) / 4000 : 0; }
  bool is_taken() { return random_() % 10 < share_; }

  void add_cube(std::array<int, 3> cube, bool by_tets, bool regions) {
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const bool whole = is_taken();
    const int region = regions ? 1 + static_cast<int>(random_() % 2) : 1;
    for (const auto& order : orders) {
      if (!(by_tets ? is_taken() : whole)) continue;
      std::array<int, 3> c = cube;
      std::array<Index, 4> v{number(c)};
      for (std::size_t s = 0; s < 3; ++s) {
        ++c[static_cast<std::size_t>(order[s])];
        v[s + 1] = number(c);
      }
      if ((order[1] - order[0] + 3) % 3 != 1) std::swap(v[2], v[3]);
      list_.tets.corners.insert(list_.tets.corners.end(), v.begin(), v.end());
      list_.regions.push_back(region);
    }
  }
  Index number(const std::array<int, 3>& c) const {
    return static_cast<Index>((c[2] * (n_ + 1) + c[1]) * (n_ + 1) + c[0]);
  }

  std::mt19937 random_;
  int n_;
  unsigned share_;
  TaggedTetrahedra list_;
};

}  // namespace multimesh::test
