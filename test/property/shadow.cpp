// SPDX-License-Identifier: BSD-3-Clause
#include "property/shadow.hpp"

#include <algorithm>

#include "multimesh/validate.hpp"
#include "oracle/image.hpp"
#include "oracle/random_surface.hpp"

namespace multimesh::test {

Shadow::Shadow(MultiMesh& tree, std::uint64_t seed)
    : tree_(tree), ops_(tree), records_(ops_, tree), rng_(seed), plain_(to_oracle(tree)) {
  const oracle::Complex& root = plain_.nodes[0].mesh;
  most_facets_ = std::max<std::size_t>(root.dim == 3 ? 60 : 36, root.facets.size());
}

std::string Shadow::step() {
  NodeId n = tree_.nodes()[oracle::pick(rng_, tree_.nodes().size())];
  while (tree_.mesh(n).dimension() == 0) n = tree_.parent(n);  // points have no edges
  const Dart d = random_dart(n);
  const auto k = static_cast<std::size_t>(tree_.mesh(n).dimension());
  const std::size_t facets = plain_.nodes[0].mesh.facets.size();
  std::size_t choice = oracle::pick(rng_, 100);
  if (facets > most_facets_) choice = 30 + choice / 2;
  if (facets < 12) choice /= 2;
  std::string fault = choice < 26   ? split(n, d)
                      : choice < 30 ? split_simplex(n, d, static_cast<int>(1 + oracle::pick(rng_, k)))
                      : choice < 70 ? collapse(n, d)
                      : choice < 76 ? swap_face(n, d)
                                    : swap(n, d, choice < 90);
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
  const std::size_t orders = k == 3 ? 24 : k == 2 ? 6 : 2;
  for (;;) {
    const auto f = static_cast<Index>(oracle::pick(rng_, mesh.capacity(k)));
    if (!mesh.is_live(k, f)) continue;
    return mesh.reorder(mesh.dart_of(k, f), {static_cast<std::uint8_t>(oracle::pick(rng_, orders))});
  }
}

/// The vertices of the dart in the root.
Shadow::Corners Shadow::start(NodeId n, Dart e) {
  records_.clear();
  Index v[4] = {};
  tree_.mesh(NodeId::root).vertices(tree_.to_root(n, e), v);
  return {static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2]), static_cast<int>(v[3])};
}

/// Compares with the expected tree, and continues from there.
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
  const auto [a, b, x, y] = start(n, e);
  const oracle::SplitResult expected = oracle::split(plain_, a, b);
  if (!ops_.split(n, e)) return "a split was refused";
  return compare(renamed(expected.tree, records_.names_after(expected)), splits);
}

std::string Shadow::collapse(NodeId n, Dart e) {
  const auto [a, b, x, y] = start(n, e);
  const oracle::CollapseResult expected = oracle::collapse(plain_, a, b);
  if (!ops_.collapse(n, e)) return unchanged();
  if (!expected.valid) return "a collapse was done that leaves no valid tree: " + expected.reason;
  return compare(renamed(expected.tree, records_.names_after(expected)), collapses);
}

// A split, and the collapse of the new vertex into an apex. The names of the new vertices are the largest
// ones, so that none of them survives. Natively it does not matter which apex; by split and collapse it does
// on the rim of a patch, which loses a triangle or gains one.
std::string Shadow::swap(NodeId n, Dart e, bool natively) {
  const Corners corners = start(n, e);
  if (!(natively ? ops_.swap(n, e) : ops_.swap_by_split_and_collapse(n, e))) return unchanged();
  if (plain_.nodes[0].mesh.dim == 2) return swap_edge_of_surface(corners, natively);
  // In dimension 3 the dart says which apex.
  const auto [a, b, x, y] = corners;
  const oracle::SplitResult cut = oracle::split(plain_, a, b);
  const oracle::CollapseResult expected =
      oracle::collapse(cut.tree, x, cut.vertex[0].at(oracle::simplex({a, b})));
  if (!expected.valid) return "a swap was done that leaves no valid tree: " + expected.reason;
  return compare(expected.tree, swaps);
}

std::string Shadow::swap_edge_of_surface(const Corners& corners, bool natively) {
  const auto [a, b, x, y] = corners;
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

namespace {

/// The facets of a mesh, one of them replaced by two or more.
void replace(oracle::Complex& mesh, const oracle::SimplexSet& old, const oracle::SimplexSet& fresh) {
  oracle::SimplexSet facets;
  for (const oracle::Simplex& f : facet_set(mesh))
    if (!contains(old, f)) facets.push_back(f);
  facets = unite(facets, fresh);
  mesh.facets.clear();
  for (const oracle::Simplex& f : facets) mesh.facets.push_back(f.v);
}

}  // namespace

// In every mesh of dimension 3 over the two tetrahedra on the face, three take their place.
std::string Shadow::swap_face(NodeId n, Dart f) {
  const auto [x, y, z, w] = start(n, f);
  if (!ops_.swap_face(n, f)) return unchanged();
  const oracle::Simplex face = oracle::simplex({x, y, z});
  oracle::Tree expected = plain_;
  for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
    const oracle::SimplexSet copies = preimages(plain_, static_cast<int>(i), 0, face);
    for (const oracle::Simplex& copy : copies) {
      const oracle::SimplexSet old = of_dimension(star(simplices(plain_.nodes[i].mesh), copy), 3);
      if (old.size() != 2)
        return "a face was swapped that has not two tetrahedra in mesh " + std::to_string(i);
      const int up = minus(old[0], copy).v[0], down = minus(old[1], copy).v[0];
      oracle::SimplexSet fresh;
      for (int k = 0; k < 3; ++k) {
        const oracle::Simplex side = minus(copy, oracle::simplex({copy.v[static_cast<std::size_t>(k)]}));
        fresh.push_back(joined(joined(side, up), down));
      }
      oracle::normalize(fresh);
      replace(expected.nodes[i].mesh, old, fresh);
    }
  }
  if (const std::string error = tree_error(expected); !error.empty())
    return "a face was swapped that leaves no valid tree: " + error;
  return compare(expected, face_swaps);
}

namespace {

int largest(const oracle::Complex& mesh) {
  return vertices(mesh).back();
}

/// Per node, the new vertices of `expected` by the names that they have in `actual`: the same facets are
/// around them.
Renaming names_of_new(const oracle::Tree& before, const oracle::Tree& expected, const oracle::Tree& actual) {
  Renaming names(expected.nodes.size());
  for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
    const auto around = [&](const oracle::Tree& tree, int v) {
      return link(simplices(tree.nodes[i].mesh), oracle::simplex({v}));
    };
    const std::vector<int> old = vertices(before.nodes[i].mesh);
    for (const int v : vertices(expected.nodes[i].mesh)) {
      if (std::binary_search(old.begin(), old.end(), v)) continue;
      names[i][v] = -1;
      for (const int w : vertices(actual.nodes[i].mesh))
        if (!std::binary_search(old.begin(), old.end(), w) && around(expected, v) == around(actual, w))
          names[i][v] = w;
    }
  }
  return names;
}

}  // namespace

// In every mesh, each facet over the simplex is replaced by those that join a new vertex to its other sides.
std::string Shadow::split_simplex(NodeId n, Dart d, int k) {
  const Corners corners = start(n, d);
  if (!ops_.split_simplex(n, d, k)) return "the insertion of a vertex was refused";
  oracle::Simplex s;
  for (int i = 0; i <= k; ++i) s = joined(s, corners[static_cast<std::size_t>(i)]);
  oracle::Tree expected = plain_;
  std::vector<std::map<oracle::Simplex, int>> fresh(plain_.nodes.size());
  for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
    int next = largest(plain_.nodes[i].mesh);
    for (const oracle::Simplex& copy : preimages(plain_, static_cast<int>(i), 0, s)) {
      fresh[i][copy] = ++next;
      const oracle::SimplexSet old =
          of_dimension(star(simplices(expected.nodes[i].mesh), copy), expected.nodes[i].mesh.dim);
      oracle::SimplexSet halves;
      for (const oracle::Simplex& f : old)
        for (int c = 0; c < copy.n; ++c)
          halves.push_back(joined(minus(f, oracle::simplex({copy.v[static_cast<std::size_t>(c)]})), next));
      oracle::normalize(halves);
      replace(expected.nodes[i].mesh, old, halves);
      if (i > 0)
        expected.nodes[i].image[next] =
            fresh[static_cast<std::size_t>(expected.nodes[i].parent)].at(mapped(copy, plain_.nodes[i].image));
    }
  }
  return compare(renamed(expected, names_of_new(plain_, expected, to_oracle(tree_))), insertions);
}

}  // namespace multimesh::test
