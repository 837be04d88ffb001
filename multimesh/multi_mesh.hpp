// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "multimesh/error.hpp"
#include "multimesh/mesh.hpp"

namespace multimesh {

/// Names a mesh of a tree; stays valid when other meshes are added or removed.
enum class NodeId : std::uint32_t { root = 0 };

constexpr std::uint32_t index(NodeId n) noexcept {
  return static_cast<std::uint32_t>(n);
}

/// A tree of meshes joined by containment maps. Each child facet has an anchor, a dart of its own paired with
/// a dart of its parent, from which the map child -> parent follows by equal switches on both sides. The map
/// is simplicial, preserves dimension, and is injective on facets: a parent simplex has at most one facet of
/// each child over it, but its lower faces may have several preimages (a seam edge has two).
///
///                 root            operations: multimesh/operations.hpp
///                /    \           construction: multimesh/build.hpp
///            child    child       checks: multimesh/validate.hpp
///              |                  what follows an operation: attribute.hpp, invariant.hpp
///          grandchild
///
/// Simplices are named by (node, dart, k): the k-simplex of the dart. Upward, every simplex has one image;
/// downward, none, one or several preimages. Not thread-safe.
/// Source: Tao, Dai, Zorin, Schneider, Panozzo, Codimensional MultiMeshing, section 3.
class MultiMesh {
 public:
  explicit MultiMesh(std::unique_ptr<Mesh> root);
  MultiMesh(MultiMesh&&) noexcept = default;
  MultiMesh& operator=(MultiMesh&&) noexcept = default;

  // --- the tree
  /// Adds a mesh below `parent`. `anchors`: one per facet slot of the child, ignored for dead slots.
  /// \throw InputError if an anchor is missing, dead, not dimension-preserving or not injective on facets;
  /// the tree is unchanged then. Cost: linear in the child.
  NodeId add_child(NodeId parent, std::unique_ptr<Mesh> child, std::span<const Anchor> anchors);
  /// Removes a child and everything below it from this tree; the child becomes the root of the returned tree.
  MultiMesh detach(NodeId child);

  const Mesh& mesh(NodeId n) const { return *node(n).mesh; }
  Mesh& mesh(NodeId n) { return *node(n).mesh; }
  bool contains(NodeId n) const noexcept { return index(n) < nodes_.size() && nodes_[index(n)].mesh; }
  /// \throw UsageError for the root
  NodeId parent(NodeId n) const {
    if (n == NodeId::root) [[unlikely]]
      refuse_root();
    return node(n).parent;
  }
  std::span<const NodeId> children(NodeId n) const { return node(n).children; }
  /// All meshes below n, parents before children.
  std::span<const NodeId> descendants(NodeId n) const { return node(n).descendants; }
  /// All nodes, parents before children.
  std::span<const NodeId> nodes() const noexcept { return top_down_; }
  /// Number of steps from the root.
  int depth(NodeId n) const;
  NodeId lowest_common_ancestor(NodeId a, NodeId b) const;

  // --- the containment map of one child. These throw UsageError for a node that is not in the tree, for the
  // root where a child is expected, for a dart that is not alive in its mesh, and for a dimension that the
  // mesh does not have.
  Anchor anchor(NodeId child, Index facet) const;
  /// The facet of `child` over the parent simplex of the child's dimension at d, or no_index.
  Index facet_over(NodeId child, Dart d) const;

  /// The preimage of a dart in a child of the same dimension: the dart of the facet over it with the vertices
  /// in the same order, or no_dart.
  Dart facet_copy(NodeId child, Dart d) const;

  /// The image of a dart: (v0..vk) -> the dart of the parent that begins with the images, in order.
  Dart to_parent(NodeId child, Dart d) const;
  Dart to_root(NodeId n, Dart d) const;
  /// \pre `ancestor` is on the path from n to the root
  Dart to_ancestor(NodeId n, Dart d, NodeId ancestor) const;
  /// All preimages in `child` of the parent's k-simplex of d, without duplicates: darts whose first k+1
  /// vertices map to those of d, in order. Appends to `out`. Cost: that of the star of the simplex.
  void to_child(NodeId child, Dart d, int k, DartBuffer& out) const;
  /// All preimages in a descendant, any number of steps down.
  void to_descendant(NodeId from, Dart d, int k, NodeId descendant, DartBuffer& out) const;
  /// The k-simplices of mesh `to` that have the same image as that of (from, d): in the root (`by root`,
  /// which crosses seams) or in the lowest common ancestor (which does not).
  enum class Via { root, lowest_common_ancestor };
  void map(NodeId from, Dart d, int k, NodeId to, Via via, DartBuffer& out) const;
  /// Whether two simplices of the tree are the same one: equal images in the root.
  bool same_simplex(NodeId m, Dart d, NodeId n, Dart e, int k) const;
  /// Whether the k-simplex of (from, d) has a preimage in a descendant.
  bool has_preimage(NodeId from, Dart d, int k, NodeId descendant) const;

  // --- maintenance
  /// Removes dead elements of all meshes; anchors follow. \return the renumbering, by node index.
  /// \throw UsageError inside a transaction. Invalidates all darts and indices that the caller holds.
  std::vector<Compaction> compact();

  /// \throw UsageError unless d is a dart of a live facet of n
  void require_dart(NodeId n, Dart d) const;
  /// \throw UsageError in the middle of an operation: an invariant, an attribute or a hook cannot do
  /// `what`
  void require_idle(std::string_view what) const;
  /// \throw UsageError in the middle of an operation, and inside a transaction
  void require_closed(std::string_view what) const;

  // --- edits by other code, of meshes that it can reach (attached OpenMesh meshes)
  /// Checks all meshes. (Before they change anything, operations check by themselves only whether elements
  /// were added or removed anywhere, and whether the stars that they read are as they were left.)
  /// \throw OutOfStepError naming the mesh and a vertex. Cost: linear
  void require_in_step() const;
  /// Follows edits that other code has made: elements to which a garbage collection gave new indices, and
  /// any other edits after which every map is still a containment map (new faces; changes where no child
  /// is).
  /// \return the renumbering, by node index, as from compact(); empty for meshes with nothing to follow
  /// \throw OutOfStepError if a map is lost, saying where; then only detach() helps, followed by making the
  /// children anew. UsageError inside a transaction. Cost: that of validate(). Invalidates all darts and
  /// indices that the caller holds.
  std::vector<Compaction> resync();

 private:
  friend class Transaction;
  friend class Propagation;
  friend class Legality;
  friend class Copies;
  friend class FacetCopies;

  struct Node {
    std::unique_ptr<Mesh> mesh;
    NodeId parent = NodeId::root;
    Mesh::LinkSet links = 0;  ///< in the parent's mesh
    std::vector<NodeId> children;
    std::vector<NodeId> descendants;
  };

  MultiMesh() = default;
  [[noreturn]] static void refuse_node(NodeId n);
  [[noreturn]] static void refuse_root();
  [[noreturn]] static void refuse_dart(NodeId n, Dart d);
  const Node& node(NodeId n) const {
    if (!contains(n)) [[unlikely]]
      refuse_node(n);
    return nodes_[index(n)];
  }
  Node& node(NodeId n) { return const_cast<Node&>(std::as_const(*this).node(n)); }
  // Queries from inside operations, for darts that are known to be alive.
  Dart image(NodeId child, Dart d) const;
  void preimages(NodeId child, Dart d, int k, DartBuffer& out) const;
  void preimages_below(NodeId from, Dart d, int k, NodeId descendant, DartBuffer& out) const;
  bool is_covered(NodeId from, Dart d, int k, NodeId descendant) const;
  // A walk must not start from a dead dart. This does not check for edits by other code.
  void require_live(NodeId n, Dart d) const {
    if (!mesh(n).is_dart(d)) [[unlikely]]
      refuse_dart(n, d);
  }
  void require_simplex(NodeId n, Dart d, int k) const;
  void require_below(NodeId descendant, NodeId ancestor) const;

  void remember_order();
  void require_star_in_step(NodeId n, Dart d, int k) const;
  void require_same_counts() const;
  void follow(const std::vector<Compaction>& moved);
  void unlink_from_parent(NodeId n);

  /// Link of the parent's simplex at d to a facet of the child.
  Index link_of(NodeId child, Dart d) const {
    const Node& c = nodes_[index(child)];
    return nodes_[index(c.parent)].mesh->link(c.links, d);
  }
  /// Whether facets of the child may lie over faces of the parent's facet at d; a cheap filter.
  bool may_have_links(NodeId child, Dart d) const {
    const Node& c = nodes_[index(child)];
    return nodes_[index(c.parent)].mesh->may_have_link_in_facet(c.links, d);
  }
  void set_link_of(NodeId child, Dart d, Index facet) {
    const Node& c = nodes_[index(child)];
    nodes_[index(c.parent)].mesh->set_link(c.links, d, facet);
  }

  std::vector<Node> nodes_;       // by NodeId; a removed node has no mesh
  std::vector<NodeId> top_down_;  // live nodes, parents first
  int open_transactions_ = 0;
  std::size_t renumberings_ = 0;  // by compact() and resync(), counted where anything moved
  bool operating_ = false;        // inside an operation of a Propagation
  std::string lost_;              // what resync() could not follow
  mutable DartBuffer star_;
};

/// MultiMesh::facet_copy() for loops: the lookup in the tree is done once, and darts are not checked. Valid
/// as long as the child stays in the tree.
class FacetCopies {
 public:
  FacetCopies(const MultiMesh& tree, NodeId child);
  /// \pre d is a dart of the parent's mesh, and alive
  Dart operator()(Dart d) const;

 private:
  const Mesh* above_;
  const Mesh* below_;
  Mesh::LinkSet links_;
};

}  // namespace multimesh
