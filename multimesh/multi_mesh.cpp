// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/multi_mesh.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "multimesh/faces.hpp"

namespace multimesh {

MultiMesh::MultiMesh(std::unique_ptr<Mesh> root) {
  if (!root) throw UsageError("MultiMesh: the root is null");
  nodes_.push_back({.mesh = std::move(root), .children = {}, .descendants = {}});
  remember_order();
}

void MultiMesh::refuse_node(NodeId n) {
  throw UsageError("no node " + std::to_string(index(n)) + " in this tree");
}

void MultiMesh::remember_order() {
  top_down_.assign(1, NodeId::root);
  for (std::size_t i = 0; i < top_down_.size(); ++i) {
    const auto& below = nodes_[index(top_down_[i])].children;
    top_down_.insert(top_down_.end(), below.begin(), below.end());
  }
  for (const NodeId n : top_down_) nodes_[index(n)].descendants.clear();
  for (const NodeId n : top_down_)
    for (NodeId above = n; above != NodeId::root;) {
      above = nodes_[index(above)].parent;
      nodes_[index(above)].descendants.push_back(n);
    }
}

NodeId MultiMesh::parent(NodeId n) const {
  if (n == NodeId::root) throw UsageError("the root has no parent");
  return node(n).parent;
}

int MultiMesh::depth(NodeId n) const {
  int steps = 0;
  for (; n != NodeId::root; n = parent(n)) ++steps;
  return steps;
}

NodeId MultiMesh::lowest_common_ancestor(NodeId a, NodeId b) const {
  int da = depth(a), db = depth(b);
  while (a != b) {
    if (da >= db) {
      a = parent(a), --da;
    } else {
      b = parent(b), --db;
    }
  }
  return a;
}

namespace {

[[noreturn]] void refuse_dart(NodeId n, Dart d) {
  throw UsageError("dart " + std::to_string(code(d)) + " is not a live dart of mesh " +
                   std::to_string(index(n)) + "; darts die in operations and in compact()");
}

}  // namespace

void MultiMesh::require_dart(NodeId n, Dart d) const {
  require_same_counts();
  if (!mesh(n).is_dart(d)) refuse_dart(n, d);
}

// What is not alive cannot be walked from. Whether others have edited the mesh is not asked here.
void MultiMesh::require_simplex(NodeId n, Dart d, int k) const {
  const Mesh& m = mesh(n);
  if (!m.is_dart(d)) refuse_dart(n, d);
  if (k < 0 || k > m.dimension())
    throw UsageError("mesh " + std::to_string(index(n)) + " of dimension " + std::to_string(m.dimension()) +
                     " has no simplices of dimension " + std::to_string(k));
}

void MultiMesh::require_below(NodeId descendant, NodeId ancestor) const {
  NodeId n = descendant;
  (void)node(ancestor);
  while (n != ancestor && n != NodeId::root) n = parent(n);
  if (n != ancestor)
    throw UsageError("mesh " + std::to_string(index(descendant)) + " is not below mesh " +
                     std::to_string(index(ancestor)));
}

void MultiMesh::require_idle(std::string_view what) const {
  if (operating_)
    throw UsageError(
        std::string(what) +
        " in the middle of an operation: invariants, rules of attributes, choosers and hooks may only read, "
        "and write by VertexAttribute::set; do it when the operation has returned");
}

void MultiMesh::require_closed(std::string_view what) const {
  require_idle(what);
  if (open_transactions_ > 0)
    throw UsageError(std::string(what) + " inside a transaction; do it before, or after its end");
}

namespace {

[[noreturn]] void refuse_anchor(Index facet, const std::string& why) {
  throw InputError("anchor of child facet " + std::to_string(facet) + why);
}

/// One anchor per live child facet, both darts alive, no parent simplex used twice.
void check_anchors(const Mesh& parent, const Mesh& child, std::span<const Anchor> anchors) {
  const int k = child.dimension();
  if (k > parent.dimension())
    throw InputError("a child of dimension " + std::to_string(k) + " does not fit in a parent of dimension " +
                     std::to_string(parent.dimension()));
  std::vector<bool> used(parent.capacity(k), false);
  for (Index f = 0; f < child.capacity(k); ++f) {
    if (!child.is_live(k, f)) continue;
    if (f >= anchors.size()) refuse_anchor(f, " is missing: give one per facet of the child");
    const Anchor a = anchors[f];
    if (!child.is_dart(a.own) || child.facet(a.own) != f)
      refuse_anchor(f, ": its own dart does not belong to that facet");
    if (!parent.is_dart(a.parent)) refuse_anchor(f, ": its parent dart is not alive");
    const Index over = parent.simplex(a.parent, k);
    if (used[over])
      refuse_anchor(f,
                    ": another facet of the child lies over the same parent simplex " + std::to_string(over));
    used[over] = true;
  }
}

/// Child facets that share a vertex must agree on its image; else the map is not simplicial.
void check_vertex_images(const Mesh& parent, const Mesh& child, std::span<const Anchor> anchors) {
  const int k = child.dimension();
  std::vector<Index> image(child.capacity(0), no_index);
  std::array<Index, 4> from{}, to{};
  for (Index f = 0; f < child.capacity(k); ++f) {
    if (!child.is_live(k, f)) continue;
    child.vertices(anchors[f].own, from.data());
    parent.vertices(anchors[f].parent, to.data());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(k); ++i) {
      Index& known = image[from[i]];
      if (known != no_index && known != to[i])
        throw InputError("child vertex " + std::to_string(from[i]) + " would have two images, " +
                         std::to_string(known) + " and " + std::to_string(to[i]) +
                         ": cut the child there, or give the facets' vertices in corresponding order");
      known = to[i];
    }
  }
}

}  // namespace

NodeId MultiMesh::add_child(NodeId parent, std::unique_ptr<Mesh> child, std::span<const Anchor> anchors) {
  if (!child) throw UsageError("add_child: the child is null");
  require_closed("add_child");
  Mesh& above = mesh(parent);
  check_anchors(above, *child, anchors);
  check_vertex_images(above, *child, anchors);
  const auto id = static_cast<NodeId>(nodes_.size());
  const int k = child->dimension();
  const auto links = above.add_links(k);
  child->add_anchors();
  nodes_.push_back(
      {.mesh = std::move(child), .parent = parent, .links = links, .children = {}, .descendants = {}});
  nodes_[index(parent)].children.push_back(id);
  remember_order();
  Mesh& below = mesh(id);
  // Nothing of this is ever undone. The journals are emptied on the way, so that they stay small.
  const auto forget = [&] {
    below.forget();
    above.forget();
  };
  for (Index f = 0; f < below.capacity(k); ++f) {
    if (f % 4096 == 0) forget();
    if (!below.is_live(k, f)) continue;
    below.set_anchor(f, anchors[f]);
    set_link_of(id, anchors[f].parent, f);
  }
  forget();
  return id;
}

void MultiMesh::unlink_from_parent(NodeId n) {
  Node& c = node(n);
  Node& above = nodes_[index(c.parent)];
  above.mesh->remove_links(c.links);
  std::erase(above.children, n);
}

MultiMesh MultiMesh::detach(NodeId child) {
  if (child == NodeId::root) throw UsageError("the root cannot be detached");
  require_closed("detach");
  unlink_from_parent(child);
  node(child).mesh->remove_anchors();

  MultiMesh tree;
  std::vector<std::pair<NodeId, NodeId>> moved;  // old id, new id
  const auto move_down = [&](const auto& self, NodeId old, NodeId new_parent) -> void {
    const auto id = static_cast<NodeId>(tree.nodes_.size());
    Node& from = nodes_[index(old)];
    const std::vector<NodeId> below = std::move(from.children);
    tree.nodes_.push_back({std::move(from.mesh), new_parent, from.links, {}, {}});
    if (id != NodeId::root) tree.nodes_[index(new_parent)].children.push_back(id);
    for (const NodeId c : below) self(self, c, id);
  };
  move_down(move_down, child, NodeId::root);
  tree.remember_order();
  remember_order();
  return tree;
}

Anchor MultiMesh::anchor(NodeId child, Index facet) const {
  (void)parent(child);
  const Mesh& m = mesh(child);
  if (!m.is_live(m.dimension(), facet))
    throw UsageError("facet " + std::to_string(facet) + " of mesh " + std::to_string(index(child)) +
                     " is not alive");
  return m.anchor(facet);
}

Index MultiMesh::facet_over(NodeId child, Dart d) const {
  require_simplex(parent(child), d, 0);
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
  require_simplex(child, d, 0);
  return image(child, d);
}

Dart MultiMesh::to_root(NodeId n, Dart d) const {
  return to_ancestor(n, d, NodeId::root);
}

Dart MultiMesh::to_ancestor(NodeId n, Dart d, NodeId ancestor) const {
  require_simplex(n, d, 0);
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

Dart MultiMesh::facet_copy(NodeId child, Dart d) const {
  require_simplex(parent(child), d, 0);
  const Node& c = nodes_[index(child)];
  const Mesh& above = *nodes_[index(c.parent)].mesh;
  const Index f = above.link(c.links, d);
  return f == no_index ? no_dart : lift(above, *c.mesh, f, d);
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

std::vector<Compaction> MultiMesh::compact() {
  require_closed("compact");
  require_in_step();
  std::vector<Compaction> moved(nodes_.size());
  for (const NodeId n : top_down_) moved[index(n)] = nodes_[index(n)].mesh->compact();
  follow(moved);
  return moved;
}

// New names for the darts of anchors and for the facets in links. No entry: the mesh's own are the old ones.
void MultiMesh::follow(const std::vector<Compaction>& moved) {
  const auto renamed = [](const Compaction& c, Dart d) { return c.simplices.empty() ? d : c.dart(d); };
  for (const NodeId n : top_down_) {
    if (n == NodeId::root) continue;
    Node& c = nodes_[index(n)];
    const Compaction& own = moved[index(n)];
    const Compaction& above = moved[index(c.parent)];
    const int k = c.mesh->dimension();
    for (Index f = 0; f < c.mesh->capacity(k); ++f) {
      const Anchor a = c.mesh->anchor(f);
      c.mesh->set_anchor(f, {renamed(own, a.own), renamed(above, a.parent)});
    }
    if (!own.simplices.empty())
      nodes_[index(c.parent)].mesh->remap_links(c.links, own.simplices[static_cast<std::size_t>(k)]);
  }
  for (const NodeId n : top_down_) nodes_[index(n)].mesh->forget();
  const auto stayed = [](const std::vector<Index>& places) {
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i] != i) return false;
    return true;
  };
  for (const Compaction& c : moved)
    if (!std::all_of(c.simplices.begin(), c.simplices.end(), stayed)) {
      ++renumberings_;
      return;
    }
}

}  // namespace multimesh
