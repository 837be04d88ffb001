// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/msh_content.hpp"

#include <algorithm>
#include <numeric>

#include "adapters/io/msh_element_types.hpp"

namespace multimesh::io {
namespace {

bool is_tagged(std::int32_t tag) {
  return tag != 0;
}

/// Ascending if the numbers are 1 to n, each once; otherwise in file order.
std::vector<std::size_t> order_of(std::span<const std::uint64_t> numbers) {
  const std::size_t n = numbers.size();
  std::vector<std::size_t> order(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t number = numbers[i];
    if (number < 1 || number > n || order[number - 1] != n) {
      std::iota(order.begin(), order.end(), std::size_t{0});
      return order;
    }
    order[number - 1] = i;
  }
  return order;
}

}  // namespace

void MshContent::add_point(std::uint64_t number, const std::array<double, 3>& point, std::uint64_t where) {
  out.add_point(point, where);
  if (!numbers_.add(number))
    out.fail(where, "there are two nodes of number " + std::to_string(number) + "; renumber them");
}

void MshContent::add_points(std::span<const std::uint64_t> numbers,
                            std::span<const std::array<double, 3>> points,
                            std::span<const std::uint64_t> where) {
  const std::vector<std::size_t> order = order_of(numbers);
  out.reserve_points(numbers.size());
  for (const std::size_t i : order) add_point(numbers[i], points[i], where[i]);
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
  if (type.shape == CellShape::quad) return polygon_entity_tags_.push_back(entity);
  const auto k = static_cast<std::size_t>(dimension_of(type.shape));
  entity_tags_[k].push_back(entity);
  numbers_of_[k].push_back(number_);
}

void MshContent::sort_elements() {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<std::uint64_t>& numbers = numbers_of_[k];
    if (std::ranges::is_sorted(numbers)) continue;
    std::vector<std::size_t> order(numbers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return numbers[i]; });
    out.reorder(static_cast<int>(k), order);
  }
}

void MshContent::finish() {
  choose_tags();
  sort_elements();
  if (has_partitions)
    out.warn("the partitions are dropped" +
             (border_elements == 0 ? std::string()
                                   : ", and " + std::to_string(border_elements) + " elements between them"));
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
