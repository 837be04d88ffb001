// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "multimesh/operations.hpp"
#include "multimesh/permutation.hpp"
#include "oracle/complex.hpp"
#include "test/support/trees.hpp"

/// Conversions between the library and the oracles, which know only plain lists of facets.
namespace multimesh::test {

/// The live facets of a mesh, with its vertex indices.
oracle::Complex complex_of(const Mesh& mesh);

/// All meshes, in the order of tree.nodes(), and the vertex maps to their parents.
oracle::Tree oracle_tree(const MultiMesh& tree);

/// The facets with consistent orientation; nothing if that needs a cut.
std::optional<FacetList> oriented(const oracle::Complex& complex);

/// The same tree in the library, with the same vertex indices, and a position on each root vertex. Nothing
/// if a mesh is not orientable.
std::unique_ptr<Tree> tree_from(const oracle::Tree& tree);

/// A live dart of the mesh whose first vertices are these; no_dart if there is none.
Dart find_dart(const Mesh& mesh, std::span<const Index> vertices);
inline Dart find_dart(const Mesh& mesh, std::initializer_list<Index> vertices) {
  return find_dart(mesh, std::span(vertices.begin(), vertices.size()));
}

/// One dart per live k-simplex.
DartBuffer simplices_of(const Mesh& mesh, int k);

/// All darts of live facets.
DartBuffer all_darts(const Mesh& mesh);

/// (node, a, b) for each copy of a root edge, in the order in which operations list them.
struct EdgeCopy {
  std::size_t node;  ///< position in tree.nodes()
  int a, b;
};
std::vector<EdgeCopy> edge_copies(const MultiMesh& tree, Dart root_edge);

/// Facets as sets of vertices, and vertex images: two trees are the same if these are equal. `renamed`: per
/// node, vertices that are counted under other names.
struct PlainTree {
  std::vector<oracle::SimplexSet> facets;
  std::vector<std::map<int, int>> images;
  friend bool operator==(const PlainTree&, const PlainTree&) = default;
};
PlainTree plain(const oracle::Tree& tree, const std::vector<std::map<int, int>>& renamed = {});

/// The trees that exhaustive tests run over: of every kind the oracle knows, small.
std::unique_ptr<Tree> random_small_tree(std::uint64_t seed, std::size_t most_facets = 16);
/// The same below a tetrahedral mesh.
std::unique_ptr<Tree> random_small_solid_tree(std::uint64_t seed, std::size_t most_facets = 16);

}  // namespace multimesh::test
