// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/msh_content.hpp"

#include <algorithm>

#include "adapters/io/msh_element_types.hpp"

namespace multimesh::io {
namespace {

bool is_tagged(std::int32_t tag) {
  return tag != 0;
}

}  // namespace

void MshContent::add_point(std::uint64_t number, const std::array<double, 3>& point) {
  out.add_point(point, in.where(number));
  if (!numbers_.add(number))
    out.fail(in.where(number), "there are two nodes of number " + std::to_string(number) + "; renumber them");
}

std::uint32_t MshContent::point(std::uint64_t number, std::uint64_t where) const {
  std::uint32_t index = 0;
  if (!numbers_.find(number, index))
    out.fail(where, "node " + std::to_string(number) + " is named, but the section $Nodes" +
                        (numbers_.size() == 0 ? " does not come before this one" : " does not have it") +
                        "; correct or remove the element");
  return index;
}

const CellType& MshContent::element_type(std::int64_t number, std::uint64_t where) const {
  if (const CellType* type = msh_element_type(number)) return *type;
  out.fail(where, "element type " + std::to_string(number) +
                      " is not known; save the mesh with Gmsh, with tetrahedra and triangles only");
}

void MshContent::add_element(const CellType& type, std::span<const std::uint32_t> nodes,
                             std::int32_t physical, std::int32_t entity, std::uint64_t where) {
  add_cell(out, type, nodes, physical, where);
  if (type.shape == CellShape::quad)
    polygon_entity_tags_.push_back(entity);
  else
    entity_tags_[static_cast<std::size_t>(dimension_of(type.shape))].push_back(entity);
}

void MshContent::choose_tags() {
  for (std::size_t k = 0; k < 4; ++k) {
    auto& tags = out.soup().simplices[k].tags;
    const bool quads = k == 2;
    if (std::ranges::any_of(tags, is_tagged)) continue;
    if (quads && std::ranges::any_of(out.polygon_tags(), is_tagged)) continue;
    tags = entity_tags_[k];
    if (quads) out.polygon_tags() = polygon_entity_tags_;
    out.notes().entity_tags += static_cast<std::size_t>(std::ranges::count_if(tags, is_tagged));
  }
}

}  // namespace multimesh::io
