// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "multimesh/cut.hpp"
#include "multimesh/error.hpp"
#include "multimesh/mesh.hpp"
#include "multimesh/tet/large_array.hpp"
#include "multimesh/tet/simplex_map.hpp"
#include "multimesh/tet/simplex_property.hpp"

namespace multimesh::tet {

/// Values on the vertices or tetrahedra of a TetMesh.
template <class T>
using Property = ValuesOf<T>;

/// A tetrahedral mesh: per tetrahedron its 4 vertices and, across each face, the neighbour with the
/// permutation that takes local corners over; per vertex one tetrahedron. 37 bytes per tetrahedron and 5 per
/// vertex; edges and faces are implicit. It holds no positions: geometry is a property.
///
/// A dart is tetrahedron << 5 | permutation: position i of the ordering is local corner p[i].
///
/// Facet i of the input is tetrahedron i, vertex j is vertex j. Slots of dead elements are reused by later
/// splits. Edges and faces have no storage: their indices (6 t + e, 4 t + f of their lowest tetrahedron) are
/// stable only until an operation touches their star.
///
/// Source of the layout: glue permutations as in Regina's triangulations (Burton 2004).
class TetMesh final : public Mesh {
 public:
  static constexpr Index most_tets = 1U << 27;

  /// \pre consistently oriented and manifold, as multimesh::cut makes it. \throw InputError naming the first
  /// tetrahedra that share a face with a third, are oriented against each other, have the same vertices, or
  /// repeat a vertex; and if there are more than 2^27. Cost: sorting; the list is read only
  explicit TetMesh(const FacetList& tets);

  // --- simplices and darts
  Index capacity(int k) const override;
  bool is_live(int k, Index s) const override;
  bool is_dart(Dart d) const override;
  Index simplex(Dart d, int k) const override;
  Dart dart_of(int k, Index s) const override;
  Dart switch_dart(Dart d, int k) const override;
  Dart reorder(Dart d, Permutation p) const override;
  Permutation order(Dart from, Dart to) const override;
  void vertices(Dart d, Index* out) const override;
  void facet_vertices(Index t, Index* out) const override { std::copy_n(tets_[t].v, 4, out); }
  bool same_simplex(Dart d, Dart e, int k) const override;
  /// The four vertices of a live tetrahedron, in the order of its local corners; positively oriented if the
  /// input was.
  const Index* corners(Index t) const { return tets_[t].v; }
  static Dart dart(Index t, Permutation p = {}) { return Dart{t << 5 | p.code}; }
  static Index tet(Dart d) { return code(d) >> 5; }

  // --- neighbourhoods
  /// Of an edge (a,b,x0,x1): in order, (a,b,x0,x1), (a,b,x1,x2), ..; from boundary to boundary if any.
  void star(Dart d, int k, DartBuffer& out) const override;
  bool is_boundary(Dart d, int k) const override;
  bool is_locked(Index v) const override { return flags_[v] & locked; }
  void set_locked(Index v, bool on) override;
  bool has_link_around(LinkSet links, int j, Dart d, int k) const override;
  bool may_have_link_around(LinkSet links, Dart d, int k) const override;
  bool may_have_link_in_facet(LinkSet links, Dart d) const override;

  // --- local operations
  bool link_condition(Dart e) const override;
  void split_edge(Dart e, SplitRecord& record) override;
  bool has_values(int k) const override;
  void merge_values(Dart e, const Merging& merging) override;
  void collapse_edge(Dart e, CollapseRecord& record) override;
  void collapse_region(Dart e, CollapseRegion& region) const override;
  Dart after_split(const SplitRecord& record, Dart old, End end) const override;
  Dart after_collapse(const CollapseRecord& record, Dart old) const override;

  /// Splits the face of f = (x,y,z,w) at a new vertex m in its interior: each tetrahedron beside it becomes
  /// three, in which m stands for x, y or z; (m,y,z,w) keeps the index, and its darts their codes. Its value
  /// goes to all three parts of the face. Journaled. \return (m,y,z,w) \pre the mesh has no children
  Dart split_face(Dart f);

  // --- journal
  Mark mark() const override { return log_.size(); }
  void rollback(Mark mark) override;
  void forget() override;
  void protect(int k, Index s) override;

  // --- properties
  void keep(int k, std::unique_ptr<ValueList> values) override;
  void drop(int k, const void* values) override;
  /// Adds a column; the mesh owns it, the reference stays valid until it is removed. T{} everywhere.
  /// \throw UsageError if the name is taken
  template <class T>
  Property<T>& add_vertex_property(std::string name) {
    return add<T>(vertex_properties_, std::move(name), vertex_tet_.size());
  }
  template <class T>
  Property<T>& add_tet_property(std::string name) {
    return add<T>(tet_properties_, std::move(name), tets_.size());
  }
  /// Null if there is no property of that name and type.
  template <class T>
  Property<T>* vertex_property(std::string_view name) const {
    return dynamic_cast<Property<T>*>(find(vertex_properties_, name));
  }
  template <class T>
  Property<T>* tet_property(std::string_view name) const {
    return dynamic_cast<Property<T>*>(find(tet_properties_, name));
  }
  /// \throw UsageError for a property of another mesh, or that is removed
  void remove_property(const ValueList& property);

  /// A column on few of the edges (k = 1) or faces (k = 2); simplices without a value cost nothing. Halves of
  /// a split simplex keep its value. Where a collapse makes one simplex of two, it has the value of the one
  /// that has any; of two values, that of the simplex in a mesh below if the other is in none, else that at
  /// the surviving vertex, or what `merge` makes of both.
  template <class T>
  SimplexProperty<T>& add_simplex_property(int k, std::string name,
                                           typename SimplexProperty<T>::Merge merge = {}) {
    auto made =
        std::make_unique<SimplexProperty<T>>(k, std::move(name), vertex_tet_.size(), std::move(merge));
    SimplexProperty<T>& property = *made;
    adopt(std::move(made));
    return property;
  }
  template <class T>
  SimplexProperty<T>* simplex_property(std::string_view name) const {
    for (const auto& p : simplex_properties_)
      if (p->name() == name) return dynamic_cast<SimplexProperty<T>*>(p.get());
    return nullptr;
  }
  void remove_property(const SimplexPropertyBase& property);
  /// The value on the simplex of d, or null. Valid until the next write to the property.
  template <class T>
  const T* value(const SimplexProperty<T>& property, Dart d) const {
    Index v[4];
    vertices(d, v);
    const Index n = property.table().find(v);
    return n == no_index ? nullptr : &property.values_[n];
  }
  /// Journaled, as is clear_value.
  template <class T>
  void set_value(SimplexProperty<T>& property, Dart d, T value) {
    property.values_.push_back(std::move(value));
    write(property.table(), key(d, property.dimension()), static_cast<Index>(property.values_.size() - 1));
  }
  void clear_value(SimplexPropertyBase& property, Dart d) {
    write(property.table(), key(d, property.dimension()), no_index);
  }

  // --- containment maps
  void add_anchors() override;
  void remove_anchors() override;
  Anchor anchor(Index facet) const override { return anchors_[facet]; }
  void set_anchor(Index facet, Anchor anchor) override;
  LinkSet add_links(int k) override;
  void remove_links(LinkSet links) override;
  Index link(LinkSet links, Dart d) const override;
  void set_link(LinkSet links, Dart d, Index child_facet) override;

  // --- maintenance
  Compaction compact() override;
  void remap_links(LinkSet links, const std::vector<Index>& child_facets) override;
  void check(std::vector<std::string>& problems) const override;

 private:
  struct alignas(32) Tet {  // never across two cache lines
    Index v[4];             ///< v[0] is no_index in a dead one
    std::uint32_t glue[4];  ///< across the face opposite: neighbour << 5 | where our corners are in it
  };
  static constexpr std::uint32_t no_glue = ~0U;
  enum Flag : std::uint8_t { in_boundary = 1, locked = 2, dead = 4 };

  enum class Word : std::uint8_t {
    corner,
    glue,
    vertex_tet,
    flags,
    anchor_own,
    anchor_parent,
    dense_link,
    table,
    vertex_property,
    tet_property,
    took_tet,
    grew_tets,
    freed_tet,
    took_vertex,
    grew_vertices,
    freed_vertex,
  };
  struct Entry {
    Word word;
    LinkSet column;
    std::uint32_t index, old;
  };
  struct TableEntry {
    SimplexTable* table;
    SimplexKey key;
    Index old;
  };
  struct Links {
    int k = 0;
    std::vector<Index> facet_plus_one;    ///< of vertices or tetrahedra; 0: none
    std::unique_ptr<SimplexTable> table;  ///< of edges or faces
    bool used = false;
  };
  /// The tetrahedra around an edge (a,b): darts (a,b,x0,x1), (a,b,x1,x2), ... in turn.
  struct Ring {
    std::vector<std::uint32_t> darts;
    std::vector<Index> rim;  ///< x0, x1, ...: one more than darts if open
    bool closed = false;
  };
  using Properties = std::vector<std::unique_ptr<ValueList>>;

  // codes
  static Permutation perm(std::uint32_t d) { return {static_cast<std::uint8_t>(d & 31U)}; }
  static std::size_t local(std::uint32_t d, int position) {
    return detail::permutations[d & 31U][static_cast<std::size_t>(position)];
  }
  Index at(std::uint32_t d, int position) const { return tets_[d >> 5].v[local(d, position)]; }
  /// The same ordering in the neighbour across the face that lacks this position; no_glue at the boundary.
  std::uint32_t across(std::uint32_t d, int position) const;
  std::uint32_t turned(std::uint32_t d, int position) const;
  static Index edge_slot(std::uint32_t d);
  SimplexKey key(Dart d, int k) const;

  // neighbourhoods
  void vertex_star(std::uint32_t d, std::vector<std::uint32_t>& out) const;
  void edge_ring(std::uint32_t d, Ring& ring) const;
  static std::uint32_t next_search(LargeArray<std::uint32_t>& stamps, std::uint32_t& last, unsigned step);
  bool link_of_edge_is_common(const Ring& ring, Index a, Index b) const;
  bool boundary_link_is_common(const Ring& ring, Index a, Index b) const;

  // construction
  [[noreturn]] static void refuse_third_side(const FacetList& tets, std::span<const Index> sides);
  void glue_pair(const FacetList& tets, Index side, Index other);
  void name_vertices();
  void refuse_singular_vertices() const;
  const char* star_fault(Index v, Index tets_around) const;

  // journaled writes
  void log(Word word, std::uint32_t index, std::uint32_t old, LinkSet column = 0) {
    log_.push_back({word, column, index, old});
  }
  void set_corner(Index t, std::size_t i, Index v);
  void set_glue(Index t, std::size_t f, std::uint32_t g);
  void set_vertex_tet(Index v, std::uint32_t d);
  void set_flags(Index v, std::uint8_t flags);
  void write(SimplexTable& table, const SimplexKey& key, Index number);
  void new_tets(const std::vector<std::uint32_t>& like, std::vector<Index>& out);
  Index new_vertex();
  void kill_tet(Index t);
  void kill_vertex(Index v);
  void undo(const Entry& e);
  void resize_vertices(std::size_t n);
  void resize_tets(std::size_t n);

  // operations
  void join_neighbours(std::uint32_t dying, CollapseRecord& record);
  void halve_values(const Ring& ring, Index a, Index b, Index c);
  void rename_values(const std::vector<std::uint32_t>& star, const Ring& ring, Index a, Index b);
  template <class Visit>
  void for_each_table(const Visit& visit) {
    for (const Links& l : links_)
      if (l.table) visit(*l.table);
    for (const auto& p : simplex_properties_) visit(p->table());
  }
  using FaceParts = std::array<Index, 3>;
  FaceParts split_side(std::uint32_t d, Index m);
  void divide_value(const Index* face, Index m);

  // properties
  template <class T>
  Property<T>& add(Properties& list, std::string name, std::size_t n) {
    auto made = std::make_unique<Property<T>>(std::move(name));
    Property<T>& property = *made;
    adopt(list, std::move(made), n);
    return property;
  }
  static void adopt(Properties& list, std::unique_ptr<ValueList> values, std::size_t n);
  static ValueList* find(const Properties& list, std::string_view name) {
    for (const auto& p : list)
      if (p->name() == name) return p.get();
    return nullptr;
  }
  void adopt(std::unique_ptr<SimplexPropertyBase> property);

  LargeArray<Tet> tets_;
  LargeArray<std::uint32_t> vertex_tet_;  // a dart at the vertex, or no_dart's code
  LargeArray<std::uint8_t> flags_;
  std::vector<Index> free_tets_, free_vertices_;    // to be reused
  std::vector<Index> freed_tets_, freed_vertices_;  // the same, once the journal is forgotten
  Properties vertex_properties_, tet_properties_;
  std::vector<std::unique_ptr<SimplexPropertyBase>> simplex_properties_;
  std::vector<Anchor> anchors_;
  bool has_anchors_ = false;
  std::vector<Links> links_;

  std::vector<Entry> log_;
  std::vector<TableEntry> old_numbers_;

  // Scratch. A tetrahedron or vertex is marked if its stamp is that of the search.
  mutable LargeArray<std::uint32_t> tet_stamp_, vertex_stamp_;
  mutable std::uint32_t tet_search_ = 0, vertex_search_ = 0;
  mutable std::vector<std::uint32_t> star_, star_b_;
  mutable Ring ring_;
  mutable std::vector<std::array<Index, 2>> pairs_;
  std::vector<Index> halves_;
};

}  // namespace multimesh::tet
