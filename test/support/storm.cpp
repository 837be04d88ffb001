// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/storm.hpp"

#include "multimesh/permutation.hpp"
#include "multimesh/validate.hpp"

namespace multimesh::test {

Storm::Storm(Tree& tree, unsigned seed, Index fewest_facets, Index most_facets)
    : tree_(tree), random_(seed), fewest_(fewest_facets), most_(most_facets) {
  for (const NodeId n : tree.tree->nodes()) at_start_.push_back(topology(tree.tree->mesh(n)));
}

Dart Storm::random_dart(NodeId n) {
  const Mesh& mesh = tree_.tree->mesh(n);
  const int d = mesh.dimension();
  for (;;) {
    const auto f = static_cast<Index>(random_() % mesh.capacity(d));
    if (!mesh.is_live(d, f)) continue;
    const auto p = static_cast<std::uint8_t>(random_() % number_of_orders(d));
    return mesh.reorder(mesh.dart_of(d, f), {p});
  }
}

namespace {

Index count_live(const Mesh& mesh) {
  Index live = 0;
  const int d = mesh.dimension();
  for (Index f = 0; f < mesh.capacity(d); ++f) live += mesh.is_live(d, f);
  return live;
}

}  // namespace

void Storm::step() {
  const auto nodes = tree_.tree->nodes();
  const NodeId n = nodes[random_() % nodes.size()];
  const Dart d = random_dart(n);
  Propagation& ops = *tree_.operations;
  const Mesh& root = tree_.tree->mesh(NodeId::root);
  if (steps_++ % 128 == 0) live_ = count_live(root);

  const auto dimension = static_cast<unsigned>(tree_.tree->mesh(n).dimension());
  auto choice = static_cast<unsigned>(random_() % 100);
  if (live_ > most_) choice = 40 + choice / 2;
  if (live_ < fewest_) choice /= 3;
  if (dimension == 0) choice = 95;  // points can only be moved
  bool ok = false;
  if (choice < 35) {
    ok = bool(ops.split(n, d, 0.25 * static_cast<double>(1 + random_() % 3)));
  } else if (choice < 80) {
    const auto where = random_() % 8;
    const Placement p = where == 0   ? Placement::keep_a()
                        : where == 1 ? Placement::keep_b()
                                     : Placement::at(0.125 * static_cast<double>(random_() % 9));
    ok = bool(ops.collapse(n, d, p));
  } else if (choice < 95) {
    ok = bool(choice < 82   ? ops.split_simplex(n, d, 1 + static_cast<int>(random_() % dimension))
              : choice < 86 ? ops.swap_face(n, d)
              : choice < 91 ? ops.swap(n, d)
                            : ops.swap_by_split_and_collapse(n, d));
  } else {
    const Point3 shift(0.01 * static_cast<double>(random_() % 10), 0.0, 0.001);
    ok = bool(tree_.move(n, d, shift));
  }
  ok ? ++done : ++refused;
  if (root.capacity(root.dimension()) > 4 * (most_ + live_) || steps_ % 300 == 0) {
    tree_.tree->compact();
    ++compactions;
  }
}

std::string Storm::fault() const {
  const MultiMesh& tree = *tree_.tree;
  if (const auto problems = validate(tree); !problems.empty()) return problems.front();
  std::size_t i = 0;
  for (const NodeId n : tree.nodes()) {
    const Mesh& mesh = tree.mesh(n);
    if (topology(mesh) != at_start_[i++]) return "topology of mesh " + std::to_string(index(n)) + " changed";
    if (n == NodeId::root) continue;
    const NodeId above = tree.parent(n);
    for (Index v = 0; v < mesh.capacity(0); ++v) {
      if (!mesh.is_live(0, v)) continue;
      const Index image = tree.mesh(above).vertex(tree.to_parent(n, mesh.dart_of(0, v)));
      if (tree_.points(n)[v] != tree_.points(above)[image])
        return "vertex " + std::to_string(v) + " of mesh " + std::to_string(index(n)) + " left its image";
    }
  }
  return {};
}

}  // namespace multimesh::test
