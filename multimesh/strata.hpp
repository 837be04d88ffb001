// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "multimesh/copy.hpp"
#include "multimesh/simplices_stay.hpp"

namespace multimesh {

class Embedding;

/// What an edge of a surface is besides an edge: the meshes that contain it as a curve or in their boundary.
/// Edges with the same meshes are of one kind.
class EdgeKind {
 public:
  bool is_plain() const noexcept { return meshes_.empty(); }
  /// Whether a chart of the embedding is cut open there.
  bool is_seam() const noexcept { return is_seam_; }
  /// Whether it is a curve only because charts are cut open there: its place in space matters less.
  bool is_only_seam() const noexcept { return !is_plain() && !has_shape_; }
  friend bool operator==(const EdgeKind& x, const EdgeKind& y) { return x.meshes_ == y.meshes_; }

 private:
  friend class Strata;
  std::vector<std::uint32_t> meshes_;  // by node; once per copy
  bool is_seam_ = false, has_shape_ = false;
};

/// Where a vertex of a surface may move.
enum class Freedom : std::uint8_t {
  surface,  ///< anywhere on it
  line,     ///< along the two edges of one kind that meet there
  none,
};

/// How free the vertices of one mesh of a tree are, wherever in the tree the mesh is, and what its edges and
/// faces are besides edges and faces. Found from the maps and from what the embedding keeps, not from tags.
class Strata {
 public:
  /// What lies at a vertex.
  enum Stratum : std::uint8_t {
    on_face = 1,   ///< a wall contains it (dimension 3)
    on_curve = 2,  ///< a curve passes through it
    fixed = 4,     ///< it keeps its place: locked, the end of a curve, where curves meet, or a corner of
                   ///< something that stays
    copied = 8,    ///< it is one of several preimages of one vertex: what is done to one is done to all
  };

  /// By the maps alone.
  explicit Strata(const MultiMesh& tree, NodeId node = NodeId::root);
  /// And by what the embedding keeps, which must outlive it.
  Strata(const Embedding& embedding, NodeId node);

  // --- edges and vertices of a surface
  /// Trusts the caller's numbers from now on: an edge with number 0 is plain, and its copies are not
  /// examined. `numbers`: per edge of the surface.
  void trust(const std::vector<Index>& numbers) noexcept { numbers_ = &numbers; }
  /// Numbers to trust: 0 for plain edges, 1 for others. Cost: linear; at the root, less than to ask of each
  std::vector<Index> curves() const;
  /// The kind of the edge of (a, b, ..). Cost: that of its copies
  EdgeKind kind(Dart e) const;
  bool is_plain(Dart e) const { return kind(e).is_plain(); }
  /// Whether the edge may be neither split nor moved: an edge with a kind between two locked vertices, or one
  /// that is kept.
  bool is_frozen(Dart e) const {
    return is_kept(e) || (is_locked(e) && is_locked(mesh_.reorder(e, exchange_ends)) && !is_plain(e));
  }
  /// \param line if the vertex is on one: its two edges, darts that begin with the vertex. Cost: its star
  Freedom freedom(Dart vertex, std::array<Dart, 2>& line) const;
  Freedom freedom(Dart vertex) const {
    std::array<Dart, 2> line{};
    return freedom(vertex, line);
  }
  /// Of all vertices, dead ones included. Cost: linear; at the root, less than to ask of each
  std::vector<Freedom> freedoms() const;
  /// All edges of this mesh that are the same in the root, e first, beginning with the same end: where sheets
  /// meet, each has its own.
  void sheets(Dart e, DartBuffer& out) const;

  // --- of any mesh
  /// Whether the vertex keeps its place in this mesh or the root.
  bool is_locked(Dart vertex) const;
  /// Whether the face is in the boundary, between facets of different parts, or in a mesh of dimension 2. A
  /// face with another preimage is in the boundary of this mesh only, and lies between facets of both.
  /// Dimension 3
  bool is_wall(Dart f) const;
  /// The meshes of dimension 2 that have the wall.
  void meshes_of_wall(Dart f, std::vector<NodeId>& meshes) const;
  /// Whether the edge is in a mesh of dimension 1; of a surface: whether it is not plain.
  bool is_curve(Dart e) const;

  // --- what may not change, neither it nor its sides
  /// Has all that a mesh below or beside this one has of it stay as it is; for this mesh itself, the walls
  /// that no other mesh has. Asked for before tabulate()
  void fix(NodeId n) { fixed_.push_back(n); }
  bool facet_stays(Index f) const { return may_facets_stay() && stays(node_, f); }
  /// False if no facet does.
  bool may_facets_stay() const { return kept_ && !kept_->facets.empty(); }
  /// Whether a facet at the vertex stays, in any mesh: then the vertex keeps its place and those facets.
  /// Cost: the stars of its copies
  bool facets_stay_at(Dart vertex) const;
  bool wall_stays(Dart f) const;
  bool edge_stays(Dart e) const;
  /// Whether the embedding says that some invariant keeps the edge, in this mesh or one above it.
  bool is_kept(Dart e) const { return may_edges_be_kept() && is_kept_anywhere(e); }
  bool may_edges_be_kept() const { return kept_ && !kept_->edges.empty(); }

  // --- for loops
  /// Finds the strata of all vertices. From then on the questions above look there first, and who splits
  /// edges says what new vertices are. Cost: linear
  void tabulate();
  std::uint8_t of(Index v) const { return strata_[v]; }
  bool is_free(Index v) const { return (strata_[v] & ~copied) == 0; }
  bool is_copied(Index v) const { return (strata_[v] & copied) != 0; }
  bool is_fixed(Index v) const { return (strata_[v] & fixed) != 0; }
  void set(Index v, std::uint8_t strata) {
    if (v >= strata_.size()) strata_.resize(v + v / 2 + 1, 0);
    strata_[v] = strata;
  }

 private:
  bool runs_through(Dart vertex, const EdgeKind& kind) const;
  void add(EdgeKind& kind, const Copy& c, bool several) const;
  std::vector<bool> may_be_bound() const;
  void classify_meshes();
  bool is_fixed_mesh(NodeId n) const;
  bool stays(NodeId n, Index facet) const;
  bool has_preimages_beside(Dart d, int k) const;
  bool is_kept_anywhere(Dart e) const;
  template <class Visit>
  bool any_over(Dart d, int k, const Visit& visit) const;
  bool parts_differ(Dart f, Dart beyond) const;
  Dart beyond(Dart f) const;
  bool may_be(Dart d, int k, Stratum stratum) const;
  void share_with_copies(std::vector<std::uint8_t>& found) const;
  template <class Mark>
  void mark_facets(const Mark& mark) const;
  template <class Mark>
  void mark_curve(NodeId n, const std::vector<std::uint8_t>& found, const Mark& mark) const;
  template <class Mark>
  void mark_points(NodeId n, const Mark& mark) const;
  template <class Visit>
  void visit_images(NodeId n, Dart d, int k, const Visit& visit) const;

  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  const Embedding* embedding_ = nullptr;
  const Kept* kept_ = nullptr;
  std::vector<NodeId> charts_;
  std::array<std::vector<NodeId>, 3> below_, elsewhere_;  // by dimension: children, and others
  std::vector<NodeId> fixed_;
  std::vector<std::uint8_t> strata_;  // by vertex; empty: not tabulated
  const std::vector<Index>* numbers_ = nullptr;
  mutable Copies copies_;
  mutable DartBuffer edges_, star_;
};

}  // namespace multimesh
