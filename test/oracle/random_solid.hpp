// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "oracle/random_surface.hpp"

namespace multimesh::oracle {

enum class Solid { kBall, kSphere, kSolidTorus, kShell, kTorus };
inline constexpr int kNumberOfSolids = 5;

/// A small triangulation: one tetrahedron; the boundary of a 4-simplex; a ring of 3 prisms (9); a
/// tetrahedron's surface times an interval (12); the 3-torus of 15 vertices (90). Consistently oriented.
Complex base_solid(Solid kind);

/// A random triangulation: the base solid, splits until some tetrahedra more than wanted, and collapses that
/// satisfy the link condition. Has about `facets` facets, or as many as the base has.
Complex random_solid(Solid kind, std::size_t facets, std::mt19937_64& rng);

/// Random triangles of a complex of dimension 3, at least one: the surfaces of lumps of tetrahedra, links of
/// vertices, walks across edges, single ones.
SimplexSet random_triangles(const Complex& mesh, std::mt19937_64& rng);

/// Some tetrahedra around a random one, connected across triangles.
SimplexSet random_lump(const Complex& mesh, std::mt19937_64& rng);

}  // namespace multimesh::oracle
