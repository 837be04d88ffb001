// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/value_list.hpp"

namespace multimesh {

/// What an edge split did: e = (a,b) got the new vertex c in its interior, and every facet that contained e
/// was replaced by two. Filled by Mesh::split_edge; buffers are reused.
///
///        b              b          `old` is the facet before, `at_b` and `at_a` its halves after;
///       /|\            /|\         one of them has the index of `old`.
///      / | \          /_|_\        .
///     l  |  r   ->   l  c  r       .
///      \ | /          \ | /        .
///       \|/            \|/         .
///        a              a          .
struct SplitRecord {
  struct Halves {
    Index old, at_a, at_b;
  };
  Index a = no_index, b = no_index, vertex = no_index;
  Dart at_a = no_dart;  ///< (a, c, ...) in some facet, after the split
  std::vector<Halves> facets;
  std::vector<std::uint32_t> words;  ///< the mesh's own notes for after_split
};

/// What an edge collapse did: a was merged into b, and the facets that contained (a,b) died. Filled by
/// Mesh::collapse_edge; buffers are reused.
///
///        b                b        Facets around a now have b instead; l-a and l-b are one edge, r-a and
///       /|\              / \       r-b too. Indices of surviving facets stay; `renamed` of them have darts
///      / | \            /   \      with new codes.
///     l  |  r    ->    l-----r     .
///      \ | /            \   /      .
///       \|/              \ /       .
///        a
struct CollapseRecord {
  Index dead = no_index, survivor = no_index;  ///< vertices a and b
  Dart at_survivor = no_dart;                  ///< a dart at b in a live facet
  std::vector<std::uint32_t> words;            ///< the mesh's own notes for after_collapse
};

/// Chooses which values are kept where a collapse of (a,b) makes one simplex of two: a-x and b-x for each x
/// of the link of the edge; in dimension 3 also a-x-y and b-x-y.
struct Merging {
  /// The position of the merged vertex: the point (1-t) a + t b.
  double t = 1;
  /// Keep those at b, with or without a value: a is a vertex that this same operation inserted.
  bool keep_b = false;
  /// Each x, or x-y, where the values at a take precedence: a mesh below contains a-x, and not b-x.
  std::vector<std::array<Index, 2>> a_wins;  // sorted vertices; no_index second: an edge

  static std::array<Index, 2> key(Index x, Index y) { return {std::min(x, y), std::max(x, y)}; }
  bool wins(Index x, Index y = no_index) const {
    return std::find(a_wins.begin(), a_wins.end(), key(x, y)) != a_wins.end();
  }
  void add_winner(Index x, Index y) { a_wins.push_back(key(x, y)); }
  void rename(Index old, Index now) {
    for (auto& k : a_wins)
      if (k[0] == old || k[1] == old) k = key(k[0] == old ? now : k[0], k[1] == old ? now : k[1]);
  }
};

/// The facets that an edge collapse would touch: one dart per facet, before the operation.
struct CollapseRegion {
  DartBuffer dead;     ///< facets that contain the edge; darts (a, b, ...)
  DartBuffer renamed;  ///< surviving facets in which some dart code will change
};

/// Old to new indices, after compaction; no_index for dead elements. Codes of darts move in blocks of
/// 2^block_bits.
struct Compaction {
  std::vector<std::vector<Index>> simplices;  ///< [k][old index]
  std::vector<Index> blocks;                  ///< [old block]
  unsigned block_bits = 0;

  /// The new name of an old dart; no_dart where dead.
  Dart dart(Dart old) const {
    const std::size_t block = code(old) >> block_bits;
    if (block >= blocks.size() || blocks[block] == no_index) return no_dart;
    return Dart{blocks[block] << block_bits | (code(old) & ((1U << block_bits) - 1))};
  }
};

/// A pure, facet-manifold simplicial mesh of dimension 0..3 as the core sees it: a proper simplicial complex
/// (a simplex is determined by its vertex set) with darts, local operations, a journal for exact undo, and
/// storage for anchors. Only the adapter behind it knows the data structure. Indices name simplices until the
/// mesh is compacted; those of simplices without storage (edges and faces of a tetrahedral mesh), until an
/// operation touches their star.
///
/// Calls are coarse: one per neighbourhood or operation. Writes go through a journal: everything since a
/// mark() can be rolled back exactly, element counts included. Not thread-safe. A dead or foreign dart is a
/// caller's bug; it is not checked here, but where darts enter the tree (MultiMesh).
class Mesh {
 public:
  using Mark = std::size_t;
  using LinkSet = std::uint8_t;

  virtual ~Mesh() = default;
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  int dimension() const noexcept { return dimension_; }

  // --- simplices and darts
  virtual Index capacity(int k) const = 0;  ///< index slots of the k-simplices, dead ones included
  virtual bool is_live(int k, Index s) const = 0;
  virtual bool is_dart(Dart d) const = 0;  ///< a dart of a live facet
  virtual Index simplex(Dart d, int k) const = 0;
  virtual Dart dart_of(int k, Index s) const = 0;           ///< some dart of s; no_dart if s has no facet
  virtual Dart switch_dart(Dart d, int k) const = 0;        ///< no_dart across the boundary
  virtual Dart reorder(Dart d, Permutation p) const = 0;    ///< another dart of the same facet
  virtual Permutation order(Dart from, Dart to) const = 0;  ///< p with reorder(from, p) == to; same facet
  virtual void vertices(Dart d, Index* out) const = 0;      ///< dimension()+1 of them, in order
  /// Those of a live facet, in the order of its dart_of: in one call, for loops over facets.
  virtual void facet_vertices(Index facet, Index* out) const { vertices(dart_of(dimension_, facet), out); }
  /// Whether the k-simplices of two darts are the same one.
  virtual bool same_simplex(Dart d, Dart e, int k) const { return simplex(d, k) == simplex(e, k); }

  /// Whether the index of a k-simplex is stable until it dies, so that values can be stored by it.
  virtual bool stores(int k) const { return dimension_ < 3 || k == 0 || k == dimension_; }
  /// The corner of the facet of d at the vertex of d, for values that are stored by corner; no_index if the
  /// mesh stores none.
  virtual Index corner(Dart) const { return no_index; }
  virtual Index corner_capacity() const { return 0; }

  Index vertex(Dart d) const { return simplex(d, 0); }
  Index facet(Dart d) const { return simplex(d, dimension_); }

  // --- neighbourhoods
  /// One dart per facet that contains the k-simplex of d, each beginning with d's first k+1 vertices.
  virtual void star(Dart d, int k, DartBuffer& out) const = 0;
  /// Whether the k-simplex of d (k < dimension) lies in the boundary of the mesh.
  virtual bool is_boundary(Dart d, int k) const = 0;

  // --- locks: marks on vertices that keep their place and are not merged away (docs/concepts.md, "Points and
  // locks"). A mesh that stores no locks has none.
  virtual bool is_locked(Index /*vertex*/) const { return false; }
  /// Not journaled: outside of transactions. \throw UsageError if the mesh stores no locks
  virtual void set_locked(Index vertex, bool on);

  // --- local operations; e = (a, b, ...)
  /// Lk a n Lk b = Lk ab with the boundary coned to a dummy vertex (Dey et al. 1999).
  virtual bool link_condition(Dart e) const = 0;
  virtual void split_edge(Dart e, SplitRecord& record) = 0;
  /// \pre link_condition(e)
  virtual void collapse_edge(Dart e, CollapseRecord& record) = 0;
  virtual void collapse_region(Dart e, CollapseRegion& region) const = 0;
  /// The dart of an old facet that contained e=(a,b), in the half at `end`, with c in place of the other end.
  virtual Dart after_split(const SplitRecord& record, Dart old, End end) const = 0;
  /// The dart that an old dart became, with b for a. For a dart of a dead facet: the same ordering of the
  /// surviving simplices, in the facet that now contains them. The first k+1 vertices of such a dart, for the
  /// k in question, may not contain both a and b.
  virtual Dart after_collapse(const CollapseRecord& record, Dart old) const = 0;
  /// Whether flip_edge is possible: dimension 2, e interior, and the other diagonal not an edge yet.
  virtual bool can_flip(Dart) const { return false; }
  /// Replaces e=(a,b) by (l,r). The darts on the four outer edges keep their codes. \pre can_flip(e)
  virtual void flip_edge(Dart) {}

  // --- values that the mesh itself stores; all others are attributes
  /// Adds a list of values on the k-simplices, initially initial_value(). The mesh owns it: it grows and is
  /// compacted with the mesh; new facets have the value of the one that they are part of. \pre stores(k); a
  /// copyable type other than bool. \throw UsageError if the mesh stores no values
  template <class T>
  std::vector<T>& add_values(int k, std::string name) {
    auto made = std::make_unique<ValuesOf<T>>(std::move(name));
    std::vector<T>& values = made->values;
    keep(k, std::move(made));
    return values;
  }
  virtual void keep(int k, std::unique_ptr<ValueList> values);
  /// Removes a list that add_values() has returned. \throw UsageError if the mesh has none such, or inside a
  /// transaction
  template <class T>
  void remove_values(int k, const std::vector<T>& values) {
    drop(k, &values);
  }
  virtual void drop(int k, const void* values);
  /// Whether the mesh stores values on k-simplices, 0 < k < dimension.
  virtual bool has_values(int /*k*/) const { return false; }
  /// Call before collapse_edge(e). Where two simplices will become one, moves the values to keep to where the
  /// merged simplex finds them. Journaled.
  virtual void merge_values(Dart /*e*/, const Merging&) {}

  // --- journal
  virtual Mark mark() const = 0;
  virtual void rollback(Mark mark) = 0;  ///< undo everything since; exact
  virtual void forget() = 0;             ///< nothing before this call can be undone any more
  /// Saves all properties of a k-simplex, of any type, so that a rollback restores them: for callbacks that
  /// write properties not managed by any Attribute.
  virtual void protect(int k, Index s) = 0;

  // --- containment maps: anchors towards the parent, links towards the children; writes are journaled
  virtual void add_anchors() = 0;
  virtual void remove_anchors() = 0;
  virtual Anchor anchor(Index facet) const = 0;
  virtual void set_anchor(Index facet, Anchor anchor) = 0;
  virtual LinkSet add_links(int k) = 0;
  virtual void remove_links(LinkSet links) = 0;
  /// The facet of a child over the k-simplex of d (k is that of the link set), or no_index.
  virtual Index link(LinkSet links, Dart d) const = 0;
  virtual void set_link(LinkSet links, Dart d, Index child_facet) = 0;
  /// Whether a j-simplex around the k-simplex of d, k < j, has a facet of a child over it; j is the dimension
  /// of the link set. One call per star; adapters may override it with a faster search.
  virtual bool has_link_around(LinkSet links, int j, Dart d, int k) const;
  /// A cheap filter. False only if it is certain that no j-simplex around the k-simplex of d has a link, or
  /// no face of its facet, respectively; then they need not be searched.
  virtual bool may_have_link_around(LinkSet, Dart, int) const { return true; }
  virtual bool may_have_link_in_facet(LinkSet, Dart) const { return true; }

  // --- maintenance
  /// Removes dead elements permanently; properties and status bits move along. \pre the journal is empty
  virtual Compaction compact() = 0;
  /// Relabels link values after the child was compacted.
  virtual void remap_links(LinkSet links, const std::vector<Index>& child_facets) = 0;
  /// Appends one sentence for each error in the connectivity.
  virtual void check(std::vector<std::string>& problems) const = 0;

  // --- edits by other code: only for a mesh that other code can reach, which is then watched
  bool is_watched() const noexcept { return watched_; }
  /// Whether the numbers of elements are those that the calls above have left. Cost: constant
  virtual bool same_counts() const { return true; }
  /// Whether the star of a vertex is as the calls above have left it. Cost: that of the star
  virtual bool star_in_step(Index) const { return true; }
  /// The first vertex whose star is not; nothing if the whole mesh is in step. Cost: linear
  virtual std::optional<Index> first_out_of_step() const { return std::nullopt; }
  /// Where other code has moved elements by giving them new indices, in the form of compact(); nothing if the
  /// mesh is not watched.
  virtual std::optional<Compaction> renumbering() const { return std::nullopt; }
  /// Accepts the current connectivity as ours. \pre the journal is empty
  virtual void accept_edits() {}

 protected:
  explicit Mesh(int dimension) : dimension_(dimension) {}
  void set_watched() noexcept { watched_ = true; }

 private:
  int dimension_;
  bool watched_ = false;
  mutable DartBuffer star_;
};

/// Appends one sentence for every two k-simplices with the same vertices; a proper simplicial complex has
/// none. Cost: sorting.
void check_simplices_differ(const Mesh& mesh, int k, std::vector<std::string>& problems);

/// One dart (v, x, ..) per edge at the vertex of a surface's dart. `edges` is overwritten. Cost: that of the
/// star
void edges_around(const Mesh& mesh, Dart vertex, DartBuffer& edges);

/// The permutation p of the first k+1 positions with from[p[i]] == to[i]; k <= 3.
/// \pre both orderings have the same first k+1 vertices, in some order
Permutation matching(const Index* from, const Index* to, int k);

/// The dart of `facet` with the vertices in this order; no_dart if it has others. Dimension+1 vertices.
Dart dart_with(const Mesh& mesh, Index facet, const Index* vertices);

}  // namespace multimesh
