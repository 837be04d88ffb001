// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "multimesh/attribute.hpp"
#include "multimesh/invariant.hpp"
#include "multimesh/legality.hpp"
#include "multimesh/transaction.hpp"

namespace multimesh {

/// Done, or refused with the reason. A refused operation leaves everything as it was, indices included.
struct [[nodiscard]] Outcome {
  Refusal refusal;
  /// In the mesh where the operation was requested, after it. Split: (a, c, x, ..) for e = (a, b, x, ..).
  /// Collapse: a dart at the merged vertex. Swap: (l, r, ...), in dimension 3 a dart at x. Relocation: the
  /// given dart. no_dart if refused.
  Dart dart = no_dart;
  /// The same in the root.
  Dart root = no_dart;
  /// What changed in the root. Every facet there that is new, or whose vertices or their places changed,
  /// contains the simplex of this dart that has the dimension `changed_dimension`, 0 or 1. Split: the new
  /// vertex; collapse: the merged one; relocation: the one that moved; swap: the new edge, or a vertex of it.
  Dart changed = no_dart;
  int changed_dimension = 0;
  Operation operation = Operation::relocate;  ///< swap_face: flip; split_simplex: split
  explicit operator bool() const noexcept { return !refusal.refused(); }
};

/// How often each result occurred.
struct Statistics {
  std::size_t tried = 0, done = 0;
  std::array<std::size_t, 8> refused{};  ///< by Check

  std::size_t refused_by(Check c) const noexcept { return refused[static_cast<std::size_t>(c)]; }
};

/// Where the merged vertex of a collapse goes on the edge a-b.
struct Placement {
  /// The requested point (1-t) a + t b.
  double t = 0.5;
  /// If the maps hold an end that is not the requested one: go there (false) or refuse (true).
  bool strict = false;
  /// Go to the end that lies in a boundary or ends a curve in some mesh, if exactly one of them does.
  bool respect_strata = true;

  static constexpr Placement at(double t) noexcept { return {t, false, true}; }
  static constexpr Placement keep_a() noexcept { return {0, true, false}; }
  static constexpr Placement keep_b() noexcept { return {1, true, false}; }
};

/// The local operations on a tree of meshes. An operation that is requested on an edge of any mesh is
/// extended to the root and restricted to all meshes; all maps stay valid, or nothing changes.
///
/// Attributes and invariants belong to the algorithm that uses this object; they are not owned and must
/// outlive it. Those of a detached mesh are no longer called. If one of them throws, everything is left as it
/// was before the operation. They may read, query the maps, and write by ValueAttribute::set. Everything else
/// here, transactions, and changes of the tree are a UsageError until the operation has returned, through any
/// Propagation of this tree. Cost per operation: that of the stars of the edge's copies; buffers are reused,
/// but queries over two or more levels of the tree allocate. Source: Codimensional MultiMeshing, section 4;
/// legality beyond it: docs/concepts.md, "When a collapse is legal".
class Propagation {
 public:
  explicit Propagation(MultiMesh& tree) : tree_(tree), renumberings_(tree.renumberings_) {}

  /// \throw UsageError inside a transaction, or if the attribute has fewer values than its mesh has slots
  Propagation& add(Attribute& a);
  /// \throw UsageError inside a transaction
  Propagation& add(Invariant& i);
  Propagation& set(LegalityOptions o);
  /// Whether operations first save all properties, of any type, of the simplices around both ends of the
  /// edge. Only needed if rules of attributes or invariants write properties that no Attribute manages, and
  /// those must be undone too. Costs a copy of each.
  Propagation& protect_properties(bool on) { return protect_properties_ = on, *this; }

  /// Splits the edge of (a, b, ...) at (1-t) a + t b. Always legal.
  /// \post every facet over the edge became two; new facets and the new edge have their old one's properties
  Outcome split(NodeId n, Dart e, double t = 0.5);

  /// Collapses the edge of (a, b, ...) in every mesh where it has a copy.
  /// \post one vertex and one edge fewer per copy; the merged vertex keeps index and properties of the end
  /// whose place it takes, else of b
  Outcome collapse(NodeId n, Dart e, Placement placement = {});

  /// Collapses, with a placement chosen after legality has said which end must be held (0, 1 or none).
  using Chooser = std::function<double(const Event&, std::optional<double> held)>;
  Outcome collapse(NodeId n, Dart e, const Chooser& choose);

  /// Swaps the edge of e = (a,b,x,..). It must be interior in every mesh of dimension 2 or more that has it,
  /// and in no other mesh. The facets around it are replaced by those that join x to the rest of their rim.
  ///
  // clang-format off
  ///        b               b
  ///       /|\             / \         Dimension 2: (a,b,l), (b,a,r) become (l,r,a), (r,l,b). Inverse: swap of
  ///      / | \           /   \        l-r. Native where no mesh of the tree has dimension 3: no dead elements.
  ///     l  |  r   ->    l-----r
  ///      \ | /           \   /        Dimension 3: swaps 3-2, 4-4, 5-6, .., by the rim x, y1, .., yn-1: all
  ///       \|/             \ /         (a,b,.,.) become (a,x,yi,yi+1), (b,x,yi,yi+1); x chooses among n results.
  ///        a               a          Inverse: n = 3, swap_face; n = 4, swap of the new edge x-y2.
  // clang-format on
  ///
  /// Equals a split at c and the collapse of c into x. Where the edge lies on a surface inside a tetrahedral
  /// mesh, x must be one of its two apexes there. If requested in such a surface, the edge may also lie in
  /// the boundary of the tetrahedra, provided that the two facets of the surface are part of that boundary.
  Outcome swap(NodeId n, Dart e);
  /// The same by split and collapse in one transaction; the reference against which swap() is tested.
  Outcome swap_by_split_and_collapse(NodeId n, Dart e);

  /// Swaps the face of f = (x,y,z,w) in a mesh of dimension 3: (x,y,z,w) and (x,y,z,v) beyond it become the
  /// three tetrahedra around the new edge w-v. Refused in the boundary, and where another mesh has the face.
  /// Inverse: swap of w-v. Outcome: (w, v, ..).
  Outcome swap_face(NodeId n, Dart f);

  /// Inserts a new vertex at the barycentre of the k-simplex of d, k = 1..3, and joins it to the simplices
  /// around: for a face, (x,y,z) -> (m,x,y), (m,y,z), (m,z,x). By splits and collapses, in one transaction.
  /// Always legal; invariants are checked at each step. Inverse: collapse of the new vertex into one of its
  /// own corners. Outcome: a dart at the new vertex.
  Outcome split_simplex(NodeId n, Dart d, int k);

  /// Moves a vertex: `write` sets new values by VertexAttribute::set on the copies of the event; then
  /// attributes with a rule follow, and invariants are checked.
  Outcome relocate(NodeId n, Dart v, const std::function<void(const Event&)>& write);

  /// Only judges a collapse; nothing is changed. Invariants are not checked.
  CollapseVerdict judge(NodeId n, Dart e);
  /// Why an operation would be refused, as far as that is known without doing it. Not covered: what
  /// invariants say afterwards, and the link condition of a second copy after the first is collapsed.
  Refusal why_not_collapse(NodeId n, Dart e, Placement placement = {});
  /// The same for a swap in a surface. \pre no mesh of the tree has dimension 3
  Refusal why_not_swap(NodeId n, Dart e);

  /// A scope around several operations. It rolls all back, attributes included, unless it is committed.
  [[nodiscard]] Transaction transaction() { return {tree_, attributes_}; }

  const MultiMesh& tree() const noexcept { return tree_; }
  const Statistics& statistics() const noexcept { return statistics_; }
  /// After an operation: the copies of the vertex (collapse: of the merged one), or of the edge (split).
  const Copies& copies() const noexcept { return copies_; }

  /// For tests: called before each stage of an operation with the stage's number; may throw.
  std::function<void(int stage)> on_stage;

 private:
  /// The time during which no other code may change the tree, request operations, or add to them.
  class Operating {
   public:
    explicit Operating(MultiMesh& tree) : tree_(tree) {
      if (tree.operating_) tree.require_idle("an operation");
      tree.operating_ = true;
    }
    ~Operating() { tree_.operating_ = false; }
    Operating(const Operating&) = delete;
    Operating& operator=(const Operating&) = delete;

   private:
    MultiMesh& tree_;
  };
  struct Moved {  // a child facet whose anchor points into a changing part of the parent
    NodeId child;
    Index facet;
    End end;
  };
  struct Reanchored {
    NodeId node;
    Anchor anchor;
  };

  Outcome refuse(Refusal r);
  Outcome succeed(Operation operation, Dart dart, Dart root, Dart changed, int changed_dimension = 0);

  // The operations without their guard.
  Outcome split_inside(NodeId n, Dart e, double t);
  Outcome collapse_inside(NodeId n, Dart e, Placement placement);
  Outcome swap_in_steps(NodeId n, Dart e);
  Outcome split_simplex_inside(NodeId n, Dart d, int k);
  std::size_t copy_of(NodeId n, Dart d, int k) const;
  void start(NodeId n, Dart d, int k);
  void find_copies(NodeId n, Dart d, int k);
  void require_sizes();
  void stage();
  Refusal ask(bool (Invariant::*when)(const Event&), const Event& event);
  void update_attributes(const Event& event);
  void protect_neighbourhoods(Operation operation);

  void split_copy(std::size_t i);
  void collect_moved_by_split(const Copy& c);
  void write_halves(std::size_t i);

  // Changes reported to columns, and which values win in a collapse (column_changes.cpp). Only those are
  // noted for which there is a column.
  struct OldFacet {
    Dart dart;
    Index facet;
    std::array<Index, 4> corners;
  };
  struct MergingEdges {
    Dart dart;  // (b, x, ..)
    Index at_a, at_b;
    bool a_wins;
  };
  struct ColumnKinds {  // which kinds of simplex have a column
    std::uint8_t all = 0, need_kept = 0;
  };
  static constexpr std::uint8_t column_bit(int k) { return static_cast<std::uint8_t>(1U << (k + 1)); }
  bool has_columns(NodeId n) const { return index(n) < columns_.size() && columns_[index(n)].all != 0; }
  /// `k`: a dimension, or `corners`.
  bool has_column(NodeId n, int k) const {
    return index(n) < columns_.size() && (columns_[index(n)].all & column_bit(k)) != 0;
  }
  bool must_find_kept(NodeId n, int k) const {
    return index(n) < columns_.size() && (columns_[index(n)].need_kept & column_bit(k)) != 0;
  }
  void remember_facets(NodeId n, const DartBuffer& facets);
  void note_corners(std::size_t i, const OldFacet& old, Dart now, int replaced);
  void note_whole(const Copy& c);
  void note_halves(std::size_t i);
  void note_merging(std::size_t i);
  void note_merged(std::size_t i);
  void note_flipping(const Copy& c);
  void note_flipped(std::size_t i);
  void note_winners(std::size_t i, double t);
  void rename_winners(std::size_t i);
  bool is_in_mesh_below(NodeId n, Dart d, int k) const;

  Refusal judge_placed(Placement placement, double& t);
  void let_b_survive(double& t);
  Outcome collapse_judged(std::size_t asked, double t);
  bool collapse_copy(std::size_t i);
  void unlink_dead(NodeId n);
  void collect_moved_by_collapse(NodeId n);
  void collect_anchored_in(NodeId child, Dart facet);
  Dart after_earlier_collapses(std::size_t i, Dart d) const;

  bool swappable(NodeId n, Dart e);
  template <class Steps>
  Outcome sequence(Operation operation, const Steps& steps);
  Outcome take_back(NodeId n, Dart e);
  Dart after_collapses(NodeId n, Dart d) const;
  Dart after_split(NodeId n, Dart e, End end) const;

  bool flippable() const;
  void collect_reanchored_by_flip();

  MultiMesh& tree_;
  std::size_t renumberings_;  // those of the tree that the attributes have followed
  std::vector<Attribute*> attributes_;
  std::vector<Invariant*> invariants_;
  LegalityOptions legality_options_;
  Legality legality_;
  Statistics statistics_;

  Copies copies_;
  std::vector<SplitRecord> splits_;
  std::vector<CollapseRecord> collapses_;
  std::vector<Merging> mergings_;
  bool taking_back_ = false;  // the collapse removes a vertex that a split of the same operation inserted
  std::vector<ColumnKinds> columns_;  // by node
  // Changes of simplices and corners; only if there are columns.
  Changes done_;
  std::vector<OldFacet> old_facets_;
  std::vector<MergingEdges> merging_edges_;
  Index old_edge_ = no_index;
  CollapseRegion region_;
  std::vector<Moved> moved_;
  DartBuffer star_;
  std::vector<Reanchored> reanchored_;
  std::vector<VertexChange> changes_;
  std::vector<Index> around_[4];
  int stage_ = 0;
  bool protect_properties_ = false;
};

}  // namespace multimesh
