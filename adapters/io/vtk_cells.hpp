// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/io/simplex_builder.hpp"

namespace multimesh::io {

/// The cells of an unstructured grid of VTK, as both of its formats store them.
struct VtkCells {
  std::vector<std::int64_t> connectivity;  ///< points of all cells, one after the other
  std::vector<std::int64_t> ends;          ///< \#C: where in connectivity a cell ends
  std::vector<std::int64_t> types;         ///< \#C
  std::vector<std::int32_t> tags;          ///< \#C, or empty
};

/// The kinds of cells of a data set PolyData, in the order of its cell data, by their names in the legacy and
/// in the XML format, with the corresponding cell type of an unstructured grid.
struct VtkPolyKind {
  std::string_view section, element;
  std::int64_t type;
};
constexpr std::array<VtkPolyKind, 4> vtk_poly_kinds = {{{"vertices", "Verts", 2},
                                                        {"lines", "Lines", 4},
                                                        {"polygons", "Polys", 7},
                                                        {"triangle_strips", "Strips", 6}}};

/// Passes the cells to the builder: points are counted from `first_point`, cells from `first_cell` in
/// messages. Poly-lines and poly-vertices become edges and vertices, strips triangles. \throw InputError for
/// ends that do not ascend, unknown types, volumes other than tetrahedra.
void add_vtk_cells(SimplexBuilder& builder, const VtkCells& cells, std::uint32_t first_point,
                   std::uint64_t first_cell);

/// Chooses the array of whole numbers that holds the tags: one with a usual name (tag, region, material,
/// medit:ref, gmsh:physical, …), otherwise the first.
class VtkTagChoice {
 public:
  /// \return whether this array is the choice so far
  bool offer(std::string_view name);
  const std::string& name() const { return name_; }
  bool has_choice() const { return chosen_; }

 private:
  std::string name_;
  std::size_t rank_ = 0;
  bool chosen_ = false;
};

}  // namespace multimesh::io
