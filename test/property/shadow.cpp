// SPDX-License-Identifier: BSD-3-Clause
#include "property/shadow.hpp"

#include "multimesh/validate.hpp"
#include "oracle/random_surface.hpp"

namespace multimesh::test {

Shadow::Shadow(MultiMesh& tree, std::uint64_t seed)
    : tree_(tree), ops_(tree), records_(ops_, tree), rng_(seed), plain_(to_oracle(tree)) {}

std::string Shadow::step() {
  const NodeId n = tree_.nodes()[oracle::pick(rng_, tree_.nodes().size())];
  const Dart d = random_dart(n);
  std::size_t choice = oracle::pick(rng_, 100);
  if (plain_.nodes[0].mesh.facets.size() > 36) choice = 30 + choice / 2;
  if (plain_.nodes[0].mesh.facets.size() < 12) choice /= 2;
  std::string fault = choice < 30 ? split(n, d) : choice < 75 ? collapse(n, d) : swap(n, d, choice < 90);
  if (fault.empty() && steps_++ % 4 == 0) fault = query_difference(tree_, plain_);
  if (fault.empty() && steps_ % 40 == 0) {
    tree_.compact();
    plain_ = to_oracle(tree_);
    fault = query_difference(tree_, plain_);
  }
  return fault;
}

Dart Shadow::random_dart(NodeId n) {
  const Mesh& mesh = tree_.mesh(n);
  const int k = mesh.dimension();
  for (;;) {
    const auto f = static_cast<Index>(oracle::pick(rng_, mesh.capacity(k)));
    if (!mesh.is_live(k, f)) continue;
    return mesh.reorder(mesh.dart_of(k, f), {static_cast<std::uint8_t>(oracle::pick(rng_, k == 2 ? 6 : 2))});
  }
}

/// The ends of the edge in the root.
Shadow::Edge Shadow::start(NodeId n, Dart e) {
  records_.clear();
  const Mesh& mesh = tree_.mesh(NodeId::root);
  const Dart root = tree_.to_root(n, e);
  return {static_cast<int>(mesh.vertex(root)),
          static_cast<int>(mesh.vertex(mesh.reorder(root, exchange_ends)))};
}

/// Compares with what the tree should be, and goes on from there.
std::string Shadow::compare(const oracle::Tree& expected, std::size_t& count) {
  ++count;
  if (const auto problems = validate(tree_); !problems.empty()) return problems.front();
  oracle::Tree now = to_oracle(tree_);
  std::string fault = tree_difference(expected, now);
  plain_ = std::move(now);
  return fault;
}

std::string Shadow::unchanged() {
  return compare(oracle::Tree(plain_), refused);
}

std::string Shadow::split(NodeId n, Dart e) {
  const auto [a, b] = start(n, e);
  const oracle::SplitResult expected = oracle::split(plain_, a, b);
  if (!ops_.split(n, e)) return "a split was refused";
  return compare(renamed(expected.tree, records_.names_after(expected)), splits);
}

std::string Shadow::collapse(NodeId n, Dart e) {
  const auto [a, b] = start(n, e);
  const oracle::CollapseResult expected = oracle::collapse(plain_, a, b);
  if (!ops_.collapse(n, e)) return unchanged();
  if (!expected.valid) return "a collapse was done that leaves no valid tree: " + expected.reason;
  return compare(renamed(expected.tree, records_.names_after(expected)), collapses);
}

// A split, and the collapse of the new vertex into an apex. The names of the new vertices are the largest
// ones, so that none of them survives. Natively it does not matter which apex; by split and collapse it does
// on the rim of a patch, which loses a triangle or gains one.
std::string Shadow::swap(NodeId n, Dart e, bool natively) {
  const auto [a, b] = start(n, e);
  if (!(natively ? ops_.swap(n, e) : ops_.swap_by_split_and_collapse(n, e))) return unchanged();
  const oracle::Simplex edge = oracle::simplex({a, b});
  const oracle::SimplexSet apexes = of_dimension(link(simplices(plain_.nodes[0].mesh), edge), 0);
  if (apexes.size() != 2) return "an edge was swapped that has not two facets";
  const oracle::SplitResult cut = oracle::split(plain_, a, b);
  const int apex = natively ? apexes[0].v[0] : static_cast<int>(records_.of(0).back().vertex);
  if (!contains(apexes, oracle::simplex({apex}))) return "a swap that did not end at an apex";
  const oracle::CollapseResult expected = oracle::collapse(cut.tree, apex, cut.vertex[0].at(edge));
  if (!expected.valid) return "a swap was done that leaves no valid tree: " + expected.reason;
  return compare(expected.tree, swaps);
}

}  // namespace multimesh::test
