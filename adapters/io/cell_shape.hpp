// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "adapters/io/simplex_builder.hpp"

namespace multimesh::io {

/// How we treat a cell of a file, whatever its order: its corners come first in every format that we read.
enum class CellShape : std::uint8_t {
  vertex,
  edge,
  triangle,
  quad,
  polygon,
  tetrahedron,
  other_volume,
  empty
};

/// One type of cell of a format.
struct CellType {
  CellShape shape = CellShape::empty;
  std::uint8_t corners = 0;  ///< 0 = any number (polygons)
  std::uint16_t nodes = 0;   ///< corners and the others; 0 = any number
  const char* name = "";
};

/// Dimension of the simplices that a cell of this shape becomes; 3 for volumes.
constexpr int dimension_of(CellShape shape) {
  switch (shape) {
    case CellShape::vertex:
      return 0;
    case CellShape::edge:
      return 1;
    case CellShape::triangle:
    case CellShape::quad:
    case CellShape::polygon:
      return 2;
    default:
      return 3;
  }
}

/// Passes the corners of a cell to the builder. `nodes` are all its points. \throw InputError for a volume
/// that is not a tetrahedron.
inline void add_cell(SimplexBuilder& builder, const CellType& type, std::span<const std::uint32_t> nodes,
                     std::int32_t tag, std::uint64_t where) {
  if (type.shape == CellShape::other_volume)
    builder.fail(where, std::string("the element is a ") + type.name +
                            "; of volumes only tetrahedra are read, split the mesh into tetrahedra");
  if (type.shape == CellShape::polygon) return builder.add_polygon(nodes, tag, where);
  const auto corners = nodes.first(type.corners);
  if (nodes.size() > type.corners) ++builder.notes().high_order;
  if (type.shape == CellShape::quad) return builder.add_polygon(corners, tag, where);
  builder.add(dimension_of(type.shape), corners, tag, where);
}

}  // namespace multimesh::io
