// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// The periodic links of a soup as plain lists. Used as PeriodicOptions, they glue a tile as its file
/// specifies.
struct PeriodicPairs {
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< (slave, master), each once
  std::vector<std::array<double, 3>> translations;  ///< from master to slave, of each link that has points
};

/// \throw InputError naming the entity if a link is not a translation (its affine map, or without one its
/// points)
PeriodicPairs periodic_pairs(const SimplexSoup& soup);

/// Faces on the boundary of a mesh and their copies: corner i of one lies a translation from corner i of the
/// other.
struct PeriodicFaces {
  std::string name;                          ///< of the translation: "x", "x+y"
  std::array<double, 3> translation{};       ///< from master to slave
  std::vector<std::uint32_t> master, slave;  ///< dimension + 1 corners per face
};

/// Adds a periodic link for each, between entities with unused numbers. Faces that the soup lists keep their
/// tags. The others are added, in groups with new tags named "periodic NAME" and "periodic NAME copy",
/// because in version 2.2 Gmsh drops links of entities without elements. `dimension`: of the faces. Cost:
/// linear
void add_periodic_faces(SimplexSoup& soup, int dimension, const std::vector<PeriodicFaces>& sides);

}  // namespace multimesh::io
