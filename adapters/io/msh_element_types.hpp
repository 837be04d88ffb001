// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "adapters/io/cell_shape.hpp"

namespace multimesh::io {

/// The element types of Gmsh with a fixed number of nodes, by their numbers. \return nullptr for
/// others
inline const CellType* msh_element_type(std::int64_t number) {
  using enum CellShape;
  static constexpr std::array<std::pair<int, CellType>, 78> types = {{
      {1, {edge, 2, 2, "line"}},
      {2, {triangle, 3, 3, "triangle"}},
      {3, {quad, 4, 4, "quadrangle"}},
      {4, {tetrahedron, 4, 4, "tetrahedron"}},
      {5, {other_volume, 8, 8, "hexahedron"}},
      {6, {other_volume, 6, 6, "prism"}},
      {7, {other_volume, 5, 5, "pyramid"}},
      {8, {edge, 2, 3, "line"}},
      {9, {triangle, 3, 6, "triangle"}},
      {10, {quad, 4, 9, "quadrangle"}},
      {11, {tetrahedron, 4, 10, "tetrahedron"}},
      {12, {other_volume, 8, 27, "hexahedron"}},
      {13, {other_volume, 6, 18, "prism"}},
      {14, {other_volume, 5, 14, "pyramid"}},
      {15, {vertex, 1, 1, "point"}},
      {16, {quad, 4, 8, "quadrangle"}},
      {17, {other_volume, 8, 20, "hexahedron"}},
      {18, {other_volume, 6, 15, "prism"}},
      {19, {other_volume, 5, 13, "pyramid"}},
      {20, {triangle, 3, 9, "triangle"}},
      {21, {triangle, 3, 10, "triangle"}},
      {22, {triangle, 3, 12, "triangle"}},
      {23, {triangle, 3, 15, "triangle"}},
      {24, {triangle, 3, 15, "triangle"}},
      {25, {triangle, 3, 21, "triangle"}},
      {26, {edge, 2, 4, "line"}},
      {27, {edge, 2, 5, "line"}},
      {28, {edge, 2, 6, "line"}},
      {29, {tetrahedron, 4, 20, "tetrahedron"}},
      {30, {tetrahedron, 4, 35, "tetrahedron"}},
      {31, {tetrahedron, 4, 56, "tetrahedron"}},
      {32, {tetrahedron, 4, 22, "tetrahedron"}},
      {33, {tetrahedron, 4, 28, "tetrahedron"}},
      {36, {quad, 4, 16, "quadrangle"}},
      {37, {quad, 4, 25, "quadrangle"}},
      {38, {quad, 4, 36, "quadrangle"}},
      {39, {quad, 4, 12, "quadrangle"}},
      {40, {quad, 4, 16, "quadrangle"}},
      {41, {quad, 4, 20, "quadrangle"}},
      {42, {triangle, 3, 28, "triangle"}},
      {43, {triangle, 3, 36, "triangle"}},
      {44, {triangle, 3, 45, "triangle"}},
      {45, {triangle, 3, 55, "triangle"}},
      {46, {triangle, 3, 66, "triangle"}},
      {47, {quad, 4, 49, "quadrangle"}},
      {48, {quad, 4, 64, "quadrangle"}},
      {49, {quad, 4, 81, "quadrangle"}},
      {50, {quad, 4, 100, "quadrangle"}},
      {51, {quad, 4, 121, "quadrangle"}},
      {52, {triangle, 3, 18, "triangle"}},
      {53, {triangle, 3, 21, "triangle"}},
      {54, {triangle, 3, 24, "triangle"}},
      {55, {triangle, 3, 27, "triangle"}},
      {56, {triangle, 3, 30, "triangle"}},
      {57, {quad, 4, 24, "quadrangle"}},
      {58, {quad, 4, 28, "quadrangle"}},
      {59, {quad, 4, 32, "quadrangle"}},
      {60, {quad, 4, 36, "quadrangle"}},
      {61, {quad, 4, 40, "quadrangle"}},
      {62, {edge, 2, 7, "line"}},
      {63, {edge, 2, 8, "line"}},
      {64, {edge, 2, 9, "line"}},
      {65, {edge, 2, 10, "line"}},
      {66, {edge, 2, 11, "line"}},
      {71, {tetrahedron, 4, 84, "tetrahedron"}},
      {72, {tetrahedron, 4, 120, "tetrahedron"}},
      {73, {tetrahedron, 4, 165, "tetrahedron"}},
      {74, {tetrahedron, 4, 220, "tetrahedron"}},
      {75, {tetrahedron, 4, 286, "tetrahedron"}},
      {90, {other_volume, 6, 40, "prism"}},
      {91, {other_volume, 6, 75, "prism"}},
      {92, {other_volume, 8, 64, "hexahedron"}},
      {93, {other_volume, 8, 125, "hexahedron"}},
      {94, {other_volume, 8, 216, "hexahedron"}},
      {118, {other_volume, 5, 30, "pyramid"}},
      {119, {other_volume, 5, 55, "pyramid"}},
      {137, {tetrahedron, 4, 16, "tetrahedron"}},
      {140, {triangle, 3, 4, "triangle"}},
  }};
  for (const auto& [known, type] : types)
    if (known == number) return &type;
  return nullptr;
}

}  // namespace multimesh::io
