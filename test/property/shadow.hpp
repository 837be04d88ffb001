// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "property/oracle_tree.hpp"

namespace multimesh::test {

/// Operations on a tree, each of them repeated on plain vertex sets using only identification and
/// subdivision. The real tree must be the same up to the names of new vertices.
class Shadow {
 public:
  Shadow(MultiMesh& tree, std::uint64_t seed);

  /// A random operation, requested on a random mesh. All functions return the difference from brute force, or
  /// an empty string. A refused operation must have left everything as it was.
  std::string step();

  std::string split(NodeId n, Dart e);
  std::string collapse(NodeId n, Dart e);
  std::string swap(NodeId n, Dart e, bool natively);
  std::string swap_face(NodeId n, Dart f);
  std::string split_simplex(NodeId n, Dart d, int k);

  /// The tree as it is.
  const oracle::Tree& plain() const { return plain_; }

  std::size_t splits = 0, collapses = 0, swaps = 0, face_swaps = 0, insertions = 0, refused = 0;

 private:
  /// Vertices of the root.
  using Corners = std::array<int, 4>;
  Dart random_dart(NodeId n);
  Corners start(NodeId n, Dart e);
  std::string swap_edge_of_surface(const Corners& corners, bool natively);
  std::string compare(const oracle::Tree& expected, std::size_t& count);
  std::string unchanged();

  MultiMesh& tree_;
  Propagation ops_;
  Records records_;
  std::mt19937_64 rng_;
  oracle::Tree plain_;
  std::size_t steps_ = 0, most_facets_;
};

}  // namespace multimesh::test
