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

void MultiMesh::refuse_root() {
  throw UsageError("the root has no parent");
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

void MultiMesh::refuse_dart(NodeId n, Dart d) {
  throw UsageError("dart " + std::to_string(code(d)) + " is not a live dart of mesh " +
                   std::to_string(index(n)) + "; darts die in operations and in compact()");
}

void MultiMesh::require_dart(NodeId n, Dart d) const {
  require_same_counts();
  if (!mesh(n).is_dart(d)) refuse_dart(n, d);
}

void MultiMesh::require_simplex(NodeId n, Dart d, int k) const {
  const Mesh& m = mesh(n);
  require_live(n, d);
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
  // This is never undone. The journals are emptied repeatedly, so that they stay small.
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

std::vector<Compaction> MultiMesh::compact() {
  require_closed("compact");
  require_in_step();
  std::vector<Compaction> moved(nodes_.size());
  for (const NodeId n : top_down_) moved[index(n)] = nodes_[index(n)].mesh->compact();
  follow(moved);
  return moved;
}

// New names for the darts of anchors and for the facets in links. No entry: the mesh's own names are
// unchanged.
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
