// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// A geometrical entity of an MSH file.
struct MshEntity {
  std::int32_t physical = 0;  ///< the tag of its simplices; 0: none
  std::array<double, 3> low{}, high{};
  bool is_empty = true;

  void add(const std::array<double, 3>& point);
};

/// The entities of one dimension, and the entity in which each simplex is written.
struct MshEntities {
  std::map<std::int32_t, MshEntity> by_number;
  std::vector<std::int32_t> of_simplex;
};

/// The entities with which a soup is written, by dimension. An entity has the number of its simplices' tag.
/// Entities that periodic links name have the number given there, and hold the simplices all of whose corners
/// are among their points. If those have different tags, or the number is another entity's, unused numbers
/// are taken. Cost: O(n log n)
std::array<MshEntities, 4> msh_entities(const SimplexSoup& soup);

}  // namespace multimesh::io
