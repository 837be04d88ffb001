// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/multi_mesh.hpp"

namespace multimesh {

/// One of the places in the tree where a simplex of the root occurs.
struct Copy {
  NodeId node = NodeId::root;
  Dart dart = no_dart;      ///< its first k+1 vertices map to those of the root's dart, in order
  std::uint32_t above = 0;  ///< position in the list of the copy of the parent that this one maps to
};

/// All copies of a simplex of the root, parents before children; copies in one node are contiguous.
class Copies {
 public:
  /// Collects the copies of the k-simplex of the root dart d. Reuses its memory.
  void collect(const MultiMesh& tree, Dart d, int k);
  /// Collects those of the k-simplex of a dart of any mesh.
  void collect(const MultiMesh& tree, NodeId n, Dart d, int k) {
    collect(tree, n == NodeId::root ? d : tree.to_root(n, d), k);
  }

  std::span<const Copy> all() const noexcept { return list_; }
  std::span<Copy> all() noexcept { return list_; }
  /// The copies in one mesh; none for a mesh that was not, or is no longer, in the tree.
  std::span<const Copy> of(NodeId n) const noexcept { return {list_.data() + first(n), count(n)}; }
  std::uint32_t first(NodeId n) const noexcept { return range(n).first; }
  std::uint32_t count(NodeId n) const noexcept { return range(n).count; }
  std::size_t size() const noexcept { return list_.size(); }
  const Copy& operator[](std::size_t i) const noexcept { return list_[i]; }

 private:
  struct Range {
    std::uint32_t first = 0, count = 0;
  };
  Range range(NodeId n) const noexcept { return index(n) < ranges_.size() ? ranges_[index(n)] : Range{}; }
  std::vector<Copy> list_;
  std::vector<Range> ranges_;
  DartBuffer found_;
};

}  // namespace multimesh
