// SPDX-License-Identifier: BSD-3-Clause
// Queries on the maps of a tree: images, upward, and preimages, downward.
#include <algorithm>
#include <array>
#include <string>

#include "multimesh/faces.hpp"
#include "multimesh/multi_mesh.hpp"

namespace multimesh {

Anchor MultiMesh::anchor(NodeId child, Index facet) const {
  (void)parent(child);
  const Mesh& m = mesh(child);
  if (!m.is_live(m.dimension(), facet))
    throw UsageError("facet " + std::to_string(facet) + " of mesh " + std::to_string(index(child)) +
                     " is not alive");
  return m.anchor(facet);
}

Index MultiMesh::facet_over(NodeId child, Dart d) const {
  require_live(parent(child), d);
  return link_of(child, d);
}

Dart MultiMesh::image(NodeId child, Dart d) const {
  const Node& c = nodes_[index(child)];
  const Mesh& below = *c.mesh;
  const Anchor a = below.anchor(below.facet(d));
  return nodes_[index(c.parent)].mesh->reorder(a.parent, below.order(a.own, d));
}

Dart MultiMesh::to_parent(NodeId child, Dart d) const {
  (void)parent(child);
  require_live(child, d);
  return image(child, d);
}

Dart MultiMesh::to_root(NodeId n, Dart d) const {
  return to_ancestor(n, d, NodeId::root);
}

Dart MultiMesh::to_ancestor(NodeId n, Dart d, NodeId ancestor) const {
  require_live(n, d);
  require_below(n, ancestor);
  for (; n != ancestor; n = nodes_[index(n)].parent) d = image(n, d);
  return d;
}

namespace {

bool known(const Mesh& mesh, const DartBuffer& darts, std::size_t first, Dart d, int k) {
  return std::any_of(darts.begin() + static_cast<std::ptrdiff_t>(first), darts.end(),
                     [&](Dart other) { return mesh.same_simplex(other, d, k); });
}

/// The dart of the child facet `f` whose vertices map to the first ones of d, a dart at the facet's image.
Dart lift(const Mesh& above, const Mesh& below, Index f, Dart d) {
  const Anchor a = below.anchor(f);
  if (below.dimension() == above.dimension()) return below.reorder(a.own, above.order(a.parent, d));
  std::array<Index, 4> from{}, to{};
  above.vertices(a.parent, from.data());
  above.vertices(d, to.data());
  return below.reorder(a.own, matching(from.data(), to.data(), below.dimension()));
}

}  // namespace

FacetCopies::FacetCopies(const MultiMesh& tree, NodeId child)
    : above_(&tree.mesh(tree.parent(child))),
      below_(&tree.mesh(child)),
      links_(tree.nodes_[index(child)].links) {}

Dart FacetCopies::operator()(Dart d) const {
  const Index f = above_->link(links_, d);
  return f == no_index ? no_dart : lift(*above_, *below_, f, d);
}

Dart MultiMesh::facet_copy(NodeId child, Dart d) const {
  require_live(parent(child), d);
  return FacetCopies(*this, child)(d);
}

void MultiMesh::to_child(NodeId child, Dart d, int k, DartBuffer& out) const {
  require_simplex(parent(child), d, k);
  preimages(child, d, k, out);
}

void MultiMesh::preimages(NodeId child, Dart d, int k, DartBuffer& out) const {
  const Node& c = nodes_[index(child)];
  const Mesh& below = *c.mesh;
  const Mesh& above = *nodes_[index(c.parent)].mesh;
  const int dim = below.dimension();
  if (k > dim) return;
  if (k == dim) {
    if (const Index f = above.link(c.links, d); f != no_index) out.push_back(lift(above, below, f, d));
    return;
  }
  if (!above.may_have_link_around(c.links, d, k)) return;
  const std::size_t first = out.size();
  above.star(d, k, star_);
  for (const Dart t : star_)
    for (const Permutation p : faces_around(above.dimension(), dim, k)) {
      const Dart face = above.reorder(t, p);
      const Index f = above.link(c.links, face);
      if (f == no_index) continue;
      const Dart found = lift(above, below, f, face);
      if (!known(below, out, first, found, k)) out.push_back(found);
    }
}

void MultiMesh::to_descendant(NodeId from, Dart d, int k, NodeId descendant, DartBuffer& out) const {
  require_simplex(from, d, k);
  require_below(descendant, from);
  preimages_below(from, d, k, descendant, out);
}

void MultiMesh::preimages_below(NodeId from, Dart d, int k, NodeId descendant, DartBuffer& out) const {
  if (from == descendant) {
    out.push_back(d);
    return;
  }
  if (parent(descendant) == from) return preimages(descendant, d, k, out);
  NodeId step = descendant;
  while (parent(step) != from) step = parent(step);
  DartBuffer here;
  preimages(step, d, k, here);
  for (const Dart e : here) preimages_below(step, e, k, descendant, out);
}

void MultiMesh::map(NodeId from, Dart d, int k, NodeId to, Via via, DartBuffer& out) const {
  require_dart(from, d);
  require_simplex(from, d, k);
  const NodeId top = via == Via::root ? NodeId::root : lowest_common_ancestor(from, to);
  require_below(to, top);
  preimages_below(top, to_ancestor(from, d, top), k, to, out);
}

bool MultiMesh::same_simplex(NodeId m, Dart d, NodeId n, Dart e, int k) const {
  require_dart(m, d);
  require_dart(n, e);
  require_simplex(m, d, k);
  require_simplex(n, e, k);
  return mesh(NodeId::root).same_simplex(to_root(m, d), to_root(n, e), k);
}

bool MultiMesh::has_preimage(NodeId from, Dart d, int k, NodeId descendant) const {
  require_simplex(from, d, k);
  require_below(descendant, from);
  return from == descendant || is_covered(from, d, k, descendant);
}

bool MultiMesh::is_covered(NodeId from, Dart d, int k, NodeId descendant) const {
  if (parent(descendant) != from) {
    DartBuffer found;
    preimages_below(from, d, k, descendant, found);
    return !found.empty();
  }
  const Node& c = nodes_[index(descendant)];
  const Mesh& above = *nodes_[index(from)].mesh;
  const int dim = c.mesh->dimension();
  if (k > dim) return false;
  if (k == dim) return above.link(c.links, d) != no_index;
  return above.has_link_around(c.links, dim, d, k);
}

}  // namespace multimesh
