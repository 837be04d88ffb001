// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>

#include "test/support/topology.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {

/// Random operations on random edges of random meshes of a tree, from a seed.
class Storm {
 public:
  Storm(Tree& tree, unsigned seed, Index fewest_facets, Index most_facets);

  /// One operation; it may be refused. The tree is compacted now and then.
  void step();
  /// Everything that must hold after any operation, an empty string if it does: validate(), topology of
  /// every mesh as at the start, positions of children equal to those of their images.
  std::string fault() const;

  std::size_t done = 0, refused = 0, compactions = 0;

 private:
  Dart random_dart(NodeId n);

  Tree& tree_;
  std::mt19937 random_;
  Index fewest_, most_, live_ = 0;
  std::size_t steps_ = 0;
  std::vector<Topology> at_start_;
};

}  // namespace multimesh::test
