// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// What the periodic links of a soup say, as plain lists: with them as PeriodicOptions a tile is glued as its
/// file has it.
struct PeriodicPairs {
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< (slave, master), each once
  std::vector<std::array<double, 3>> translations;  ///< from master to slave, of each link that has points
};

/// \throw InputError naming the entity if a link is no translation (its affine map, or the points without
/// one)
PeriodicPairs periodic_pairs(const SimplexSoup& soup);

/// Faces on the boundary of a mesh and their copies: corner i of one lies a translation from corner i of the
/// other.
struct PeriodicFaces {
  std::string name;                          ///< of the translation: "x", "x+y"
  std::array<double, 3> translation{};       ///< from master to slave
  std::vector<std::uint32_t> master, slave;  ///< dimension + 1 corners per face
};

/// Adds a periodic link for each, between entities of numbers that are not in use. Faces that the soup lists
/// keep their tags; the others are added, in groups of new tags named "periodic NAME" and "periodic NAME
/// copy", since Gmsh drops links of entities without elements in version 2.2. `dimension`: of the faces.
/// Cost: linear
void add_periodic_faces(SimplexSoup& soup, int dimension, const std::vector<PeriodicFaces>& sides);

}  // namespace multimesh::io
