// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "multimesh/mesh.hpp"

/// Random sets of simplices of a mesh as tags, by simplex index.
namespace multimesh::test {

/// A random simple path of edges, closed or open: a walk that does not visit a vertex twice.
std::vector<bool> random_path(const Mesh& mesh, std::size_t length, std::mt19937& random);

/// About one vertex of `share`, at least one; those that are in a facet.
std::function<bool(Index)> random_points(const Mesh& mesh, unsigned seed, unsigned share = 6);

/// Two random paths.
std::function<bool(Index)> random_seams(const Mesh& mesh, unsigned seed);

/// The triangles between some tetrahedra around a random one and the others; on the boundary of the mesh,
/// too, if asked.
std::vector<bool> random_frontier(const Mesh& mesh, std::size_t tets, bool with_boundary,
                                  std::mt19937& random);

/// Facets connected across their sides, so many if there are.
std::vector<bool> random_lump(const Mesh& mesh, std::size_t size, std::mt19937& random);

}  // namespace multimesh::test
