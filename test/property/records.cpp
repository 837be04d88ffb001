// SPDX-License-Identifier: BSD-3-Clause
#include "property/oracle_tree.hpp"

namespace multimesh::test {

/// An attribute without values: it only listens.
class Records::Listener final : public Attribute {
 public:
  using Attribute::Attribute;
  void update(Operation, const VertexChange& change) override { changes.push_back(change); }
  Mark mark() const override { return 0; }
  void rollback(Mark) override {}
  void forget() override {}

  std::vector<VertexChange> changes;
};

Records::Records(Propagation& operations, const MultiMesh& tree) {
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    listeners_.push_back(std::make_unique<Listener>(NodeId{i}));
    operations.add(*listeners_.back());
  }
}

Records::~Records() = default;

void Records::clear() {
  for (auto& l : listeners_) l->changes.clear();
}

const std::vector<VertexChange>& Records::of(std::size_t node) const {
  return listeners_.at(node)->changes;
}

Renaming Records::names_after(const oracle::SplitResult& split) const {
  Renaming names(listeners_.size());
  for (std::size_t i = 0; i < listeners_.size(); ++i)
    for (const auto& [edge, fresh] : split.vertex[i]) {
      names[i][fresh] = -1;
      for (const VertexChange& c : of(i))
        if (oracle::simplex({static_cast<int>(c.a), static_cast<int>(c.b)}) == edge)
          names[i][fresh] = static_cast<int>(c.vertex);
    }
  return names;
}

// The oracle keeps some vertex of each identified set, the library the one that keeps its place. If a mesh
// has several copies of the edge, the survivor of one may die with the next.
Renaming Records::names_after(const oracle::CollapseResult& collapse) const {
  Renaming names(listeners_.size());
  for (std::size_t i = 0; i < listeners_.size(); ++i) {
    std::map<int, int> merged_into;
    for (const VertexChange& c : of(i)) merged_into[static_cast<int>(c.a)] = static_cast<int>(c.vertex);
    const auto survivor = [&](int v) {
      for (std::size_t steps = 0; steps <= merged_into.size() && merged_into.contains(v); ++steps)
        v = merged_into.at(v);
      return v;
    };
    for (const auto& [dead, kept] : collapse.merged[i])
      names[i][kept] = survivor(kept) == survivor(dead) ? survivor(kept) : -1;
  }
  return names;
}

}  // namespace multimesh::test
