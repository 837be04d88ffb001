// SPDX-License-Identifier: BSD-3-Clause
#include "test/tetgen/tet_facts.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace multimesh::test {

TetFacts facts_of(const tetgen::TetrahedraList& mesh) {
  TetFacts facts;
  facts.least = std::numeric_limits<double>::infinity();
  facts.most = -facts.least;
  std::map<std::array<Index, 3>, std::array<int, 2>> sides;  // per orientation of the sorted corners
  std::vector<bool> used(mesh.points.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto c = mesh.tets.facet(t);
    std::array<tetgen::Point, 3> e{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) e[k][i] = mesh.points[c[k + 1]][i] - mesh.points[c[0]][i];
    const double volume = (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
                          6;
    facts.volume += volume;
    facts.least = std::min(facts.least, volume), facts.most = std::max(facts.most, volume);
    for (const Index v : c) used[v] = true;
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<Index, 3> face{};
      for (std::size_t i = 0; i < 3; ++i) face[i] = c[(k + 1 + i) % 4];
      // Leaving out every other corner of a cycle changes the orientation; so does each exchange.
      bool side = k % 2 == 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i + 1; j < 3; ++j)
          if (face[i] > face[j]) side = !side;
      std::sort(face.begin(), face.end());
      ++sides[face][side];
    }
  }
  for (const auto& [face, count] : sides) {
    if (count[0] > 1 || count[1] > 1) ++facts.bad_faces;
    if (count[0] + count[1] == 1) ++facts.border_faces;
  }
  facts.unused_points = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  return facts;
}

}  // namespace multimesh::test
