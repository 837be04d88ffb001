// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/copy.hpp"

namespace multimesh {

void Copies::collect(const MultiMesh& tree, Dart d, int k) {
  list_.clear();
  ranges_.assign(ranges_.size(), {});
  for (const NodeId n : tree.nodes()) {
    if (index(n) >= ranges_.size()) ranges_.resize(index(n) + 1);
    const auto first = static_cast<std::uint32_t>(list_.size());
    if (n == NodeId::root) {
      list_.push_back({n, d, 0});
    } else {
      const Range above = ranges_[index(tree.parent(n))];
      for (std::uint32_t i = above.first; i < above.first + above.count; ++i) {
        found_.clear();
        tree.preimages(n, list_[i].dart, k, found_);
        for (const Dart e : found_) list_.push_back({n, e, i});
      }
    }
    ranges_[index(n)] = {first, static_cast<std::uint32_t>(list_.size()) - first};
  }
}

}  // namespace multimesh
