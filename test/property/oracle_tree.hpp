// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "multimesh/operations.hpp"
#include "oracle/collapse.hpp"
#include "oracle/complex.hpp"
#include "oracle/split.hpp"

/// Conversions between the library's trees and those of the brute-force judges, which know only vertices.
namespace multimesh::test {

/// The tree as meshes and maps of the library: node i becomes NodeId i, facet j facet j, and the vertex of
/// rank r in its mesh vertex r. The random numbers choose what must not matter: the orientation of every
/// component of every child (a mirrored chart), and which of two parent facets carries an anchor.
///
/// \return nothing if a mesh is not orientable, which OpenMesh cannot hold. \pre tree_error(tree) is empty
std::optional<MultiMesh> to_multimesh(const oracle::Tree& tree, std::mt19937_64& rng);

/// The live facets of every mesh by their vertex indices, and the images of vertices through the anchors.
/// \pre nodes have been added parents first and none was removed
/// \throw std::logic_error if two facets give a vertex different images
oracle::Tree to_oracle(const MultiMesh& tree);

/// Which facets, maps or vertices two trees do not have in common, whatever their order; empty if equal.
std::string tree_difference(const oracle::Tree& expected, const oracle::Tree& actual);

/// Per node: vertex -> its other name; vertices that are not in it keep theirs.
using Renaming = std::vector<std::map<int, int>>;
oracle::Tree renamed(const oracle::Tree& tree, const Renaming& names);

/// What the operations reported about the vertices of every mesh, since clear().
class Records {
 public:
  /// Listens to operations; must outlive them.
  Records(Propagation& operations, const MultiMesh& tree);
  ~Records();
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  void clear();
  const std::vector<VertexChange>& of(std::size_t node) const;

  /// The oracle's names of vertices -> those of the real tree. Vertex pairs that the operation did not
  /// report get the name -1, so that the trees differ.
  Renaming names_after(const oracle::SplitResult& split) const;
  Renaming names_after(const oracle::CollapseResult& collapse) const;

 private:
  class Listener;
  std::vector<std::unique_ptr<Listener>> listeners_;
};

/// Queries the library for the preimages of every simplex in every child, and for the image of every vertex
/// in the root, and compares with enumeration. \return the first difference, or an empty string
std::string query_difference(const MultiMesh& tree, const oracle::Tree& plain);

/// The dart (a, b, ...) of an edge of a mesh, given by its vertices; no_dart if there is none.
Dart edge_dart(const Mesh& mesh, int a, int b);

}  // namespace multimesh::test
