// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/vtk_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "adapters/io/cell_shape.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

using enum CellShape;

constexpr int empty_cell = 0, poly_vertex = 2, poly_line = 4, strip = 6, pixel = 8;

/// The number of nodes is that of the cell itself.
constexpr std::array<std::pair<int, CellType>, 36> types = {{
    {1, {vertex, 1, 0, "vertex"}},
    {3, {edge, 2, 0, "line"}},
    {5, {triangle, 3, 0, "triangle"}},
    {7, {polygon, 3, 0, "polygon"}},
    {9, {quad, 4, 0, "quad"}},
    {10, {tetrahedron, 4, 0, "tetrahedron"}},
    {11, {other_volume, 8, 0, "voxel"}},
    {12, {other_volume, 8, 0, "hexahedron"}},
    {13, {other_volume, 6, 0, "wedge"}},
    {14, {other_volume, 5, 0, "pyramid"}},
    {15, {other_volume, 5, 0, "prism"}},
    {16, {other_volume, 6, 0, "prism"}},
    {21, {edge, 2, 0, "line"}},
    {22, {triangle, 3, 0, "triangle"}},
    {23, {quad, 4, 0, "quad"}},
    {24, {tetrahedron, 4, 0, "tetrahedron"}},
    {25, {other_volume, 8, 0, "hexahedron"}},
    {26, {other_volume, 6, 0, "wedge"}},
    {27, {other_volume, 5, 0, "pyramid"}},
    {28, {quad, 4, 0, "quad"}},
    {29, {other_volume, 8, 0, "hexahedron"}},
    {30, {quad, 4, 0, "quad"}},
    {32, {other_volume, 6, 0, "wedge"}},
    {33, {other_volume, 8, 0, "hexahedron"}},
    {34, {triangle, 3, 0, "triangle"}},
    {35, {edge, 2, 0, "line"}},
    {42, {other_volume, 4, 0, "polyhedron"}},
    {68, {edge, 2, 0, "line"}},
    {69, {triangle, 3, 0, "triangle"}},
    {70, {quad, 4, 0, "quad"}},
    {71, {tetrahedron, 4, 0, "tetrahedron"}},
    {72, {other_volume, 8, 0, "hexahedron"}},
    {73, {other_volume, 6, 0, "wedge"}},
    {74, {other_volume, 5, 0, "pyramid"}},
    {76, {triangle, 3, 0, "triangle"}},
    {78, {tetrahedron, 4, 0, "tetrahedron"}},
}};

const CellType* find_type(std::int64_t number) {
  for (const auto& [known, type] : types)
    if (known == number) return &type;
  return nullptr;
}

class CellAdder {
 public:
  CellAdder(SimplexBuilder& builder, std::uint32_t first_point) : builder_(builder), first_(first_point) {}

  void points(std::span<const std::int64_t> numbers, std::uint64_t where) {
    nodes_.clear();
    for (const std::int64_t number : numbers) {
      const bool is_index = number >= 0 && number <= std::numeric_limits<std::uint32_t>::max();
      nodes_.push_back(builder_.point_index(is_index ? number + first_ : number, where));
    }
  }

  void add(std::int64_t type_number, std::int32_t tag, std::uint64_t where) {
    if (type_number == empty_cell) return builder_.left_out("empty cells");
    if (type_number == poly_vertex) return pieces(1, tag, where);
    if (type_number == poly_line) return pieces(2, tag, where);
    if (type_number == strip) return pieces(3, tag, where);
    const CellType* type = find_type(type_number);
    if (type_number == pixel && nodes_.size() == 4) {
      std::swap(nodes_[2], nodes_[3]);
      type = find_type(9);
    }
    if (type == nullptr)
      builder_.fail(where, "cell type " + std::to_string(type_number) +
                               " of VTK is not read; use tetrahedra, triangles, lines and vertices");
    if (nodes_.size() < type->corners)
      builder_.fail(where, "the cell has " + std::to_string(nodes_.size()) + " points, too few for a " +
                               type->name + "; correct or remove it");
    add_cell(builder_, *type, nodes_, tag, where);
  }

 private:
  /// Consecutive points; in a strip every second triangle has the opposite orientation.
  void pieces(std::size_t size, std::int32_t tag, std::uint64_t where) {
    for (std::size_t i = 0; i + size <= nodes_.size(); ++i) {
      std::array<std::uint32_t, 3> corners{};
      std::copy_n(nodes_.begin() + static_cast<std::ptrdiff_t>(i), size, corners.begin());
      if (size == 3 && i % 2 == 1) std::swap(corners[0], corners[1]);
      builder_.add(static_cast<int>(size) - 1, std::span(corners).first(size), tag, where);
    }
  }

  SimplexBuilder& builder_;
  std::uint32_t first_;
  std::vector<std::uint32_t> nodes_;
};

}  // namespace

void add_vtk_cells(SimplexBuilder& builder, const VtkCells& cells, std::uint32_t first_point,
                   std::uint64_t first_cell) {
  CellAdder adder(builder, first_point);
  std::int64_t begin = 0;
  for (std::size_t c = 0; c < cells.types.size(); ++c) {
    const std::int64_t end = cells.ends[c];
    const std::uint64_t where = first_cell + c;
    if (end < begin || end > static_cast<std::int64_t>(cells.connectivity.size()))
      builder.fail(where, "the cell ends at entry " + std::to_string(end) +
                              " of the connectivity, which is out of range; save the mesh again");
    const auto numbers = std::span(cells.connectivity)
                             .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    adder.points(numbers, where);
    adder.add(cells.types[c], cells.tags.empty() ? 0 : cells.tags[c], where);
    begin = end;
  }
}

bool VtkTagChoice::offer(std::string_view name) {
  constexpr std::array<std::string_view, 18> usual = {
      "tag",         "tags",     "gmsh:physical", "medit:ref", "cell_tags", "region",
      "regions",     "regionid", "region_id",     "material",  "materials", "materialid",
      "materialids", "matid",    "label",         "labels",    "domain",    "gmsh:geometrical"};
  const auto rank = static_cast<std::size_t>(std::ranges::find(usual, lower_case(name)) - usual.begin());
  if (chosen_ && rank >= rank_) return false;
  chosen_ = true;
  rank_ = rank;
  name_ = name;
  return true;
}

}  // namespace multimesh::io
