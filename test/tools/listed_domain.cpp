// SPDX-License-Identifier: BSD-3-Clause
#include "test/tools/listed_domain.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <set>

namespace multimesh::tools::test {

using io::SimplexSoup;

SimplexSoup kuhn_cube(std::uint32_t n) {
  SimplexSoup soup;
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (x * (n + 1) + y) * (n + 1) + z;
  };
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    soup.points.push_back({static_cast<double>(i / (n + 1) / (n + 1)) / n,
                           static_cast<double>(i / (n + 1) % (n + 1)) / n,
                           static_cast<double>(i % (n + 1)) / n});
  const std::array<std::array<std::uint32_t, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  for (std::uint32_t c = 0; c < n * n * n; ++c)
    for (const auto& order : orders) {
      std::array<std::uint32_t, 3> p = {c / n / n, c / n % n, c % n};
      soup.simplices[3].corners.push_back(at(p[0], p[1], p[2]));
      for (const std::uint32_t axis : order) {
        ++p[axis];
        soup.simplices[3].corners.push_back(at(p[0], p[1], p[2]));
      }
      soup.simplices[3].tags.push_back(0);
    }
  return soup;
}

SimplexSoup random_domain(unsigned seed) {
  std::mt19937 random(seed);
  SimplexSoup soup = kuhn_cube(2 + seed % 2);
  auto& tets = soup.simplices[3];
  const int regions = seed % 4;  // none, one, several
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const double x = soup.points[tets.corners[4 * t]][0];
    tets.tags[t] = regions == 0 ? 0 : 1 + static_cast<int>(x * 3) % regions;
  }
  std::set<std::vector<std::uint32_t>> listed;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < 12 && seed % 3 != k; ++i) {
      const std::size_t t = random() % tets.size(), left_out = random() % 4;
      std::vector<std::uint32_t> corners;
      for (std::size_t c = 0; corners.size() <= k; ++c)
        if (c != left_out) corners.push_back(tets.corners[4 * t + c]);
      std::ranges::sort(corners);
      if (!listed.insert(corners).second) continue;
      auto& block = soup.simplices[k];
      block.corners.insert(block.corners.end(), corners.begin(), corners.end());
      block.tags.push_back(static_cast<std::int32_t>(random() % 4) + (seed % 5 == 0 ? 0 : 1));
    }
  soup.groups = {{3, 1, "some rock"}, {2, 2, "wall"}, {1, 3, "wire"}, {0, 1, "pin"}};
  if (seed % 2 == 0) soup.tag_sets = {{3, 2, {21, 22}}, {2, 3, {2, 31}}, {1, 1, {3, 41}}};
  return soup;
}

}  // namespace multimesh::tools::test
