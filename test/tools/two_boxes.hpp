// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace multimesh::tools::test {

/// Two boxes of 3 x 6 x 6 cubes side by side, regions 1 and 2, as MEDIT text.
inline std::string two_boxes() {
  constexpr int n = 6;
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n343\n";
  for (int i = 0; i < 343; ++i)
    text += std::to_string(i / 49) + " " + std::to_string(i / 7 % 7) + " " + std::to_string(i % 7) + " 0\n";
  text += "Tetrahedra\n" + std::to_string(6 * n * n * n) + "\n";
  const auto number = [](std::array<int, 3> p) { return std::to_string(49 * p[0] + 7 * p[1] + p[2] + 1); };
  for (int c = 0; c < n * n * n; ++c)
    for (const std::array<int, 3>& order : std::initializer_list<std::array<int, 3>>{
             {0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}) {
      std::array<int, 3> p{c / n / n, c / n % n, c % n};
      const int region = p[0] < 3 ? 1 : 2;
      text += number(p);
      for (const int axis : order) ++p[static_cast<std::size_t>(axis)], text += " " + number(p);
      text += " " + std::to_string(region) + "\n";
    }
  return text + "End\n";
}

}  // namespace multimesh::tools::test
