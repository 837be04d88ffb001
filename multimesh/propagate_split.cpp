// SPDX-License-Identifier: BSD-3-Clause
// Edge split in every mesh of a tree. Top-down: when a child is split, its parent's halves already exist, and
// each child facet over the edge is anchored, half by half, in the halves of its old parent facet.
#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

Outcome Propagation::split(NodeId n, Dart e, double t) {
  const Operating operating(tree_);
  return split_inside(n, e, t);
}

Outcome Propagation::split_inside(NodeId n, Dart e, double t) {
  if (!(t >= 0 && t <= 1)) throw UsageError("the new vertex must lie on the edge: 0 <= t <= 1");
  start(n, e, 1);
  const std::size_t asked = copy_of(n, e, 1);
  const Event event{tree_, Operation::split, copies_, t, &done_};
  stage();
  if (const Refusal r = ask(&Invariant::before, event); r.refused()) return refuse(r);

  Transaction transaction(tree_, attributes_, Transaction::Own::yes);
  protect_neighbourhoods(Operation::split);
  if (splits_.size() < copies_.size()) splits_.resize(copies_.size());
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    stage();
    split_copy(i);
  }
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    Copy& c = copies_.all()[i];
    const SplitRecord& r = splits_[i];
    c.dart = r.at_a;
    const Index above = c.node == NodeId::root ? no_index : splits_[c.above].vertex;
    changes_.push_back({r.a, r.b, r.vertex, t, c.node, above});
  }
  stage();
  update_attributes(event);
  stage();
  if (const Refusal r = ask(&Invariant::after, event); r.refused()) return refuse(r);
  stage();
  transaction.commit();
  const Dart in_root = copies_[0].dart;
  return succeed(Operation::split, tree_.mesh(n).after_split(splits_[asked], e, End::a), in_root,
                 tree_.mesh(NodeId::root).reorder(in_root, exchange_ends));
}

void Propagation::split_copy(std::size_t i) {
  const Copy& c = copies_[i];
  Mesh& mesh = tree_.mesh(c.node);
  moved_.clear();
  collect_moved_by_split(c);
  if (has_columns(c.node)) {
    note_whole(c);
    mesh.split_edge(c.dart, splits_[i]);
    note_halves(i);
  } else {
    mesh.split_edge(c.dart, splits_[i]);
  }
  for (const Moved& m : moved_) {
    Mesh& below = tree_.mesh(m.child);
    Anchor a = below.anchor(m.facet);
    a.parent = mesh.after_split(splits_[i], a.parent, m.end);
    below.set_anchor(m.facet, a);
    tree_.set_link_of(m.child, a.parent, m.facet);
  }
  if (c.node != NodeId::root) write_halves(i);
}

// Child facets anchored in a facet that will be split: those over the edge are unlinked (their halves get new
// links), the others move to the half that contains their image.
void Propagation::collect_moved_by_split(const Copy& c) {
  const auto children = tree_.children(c.node);
  if (children.empty()) return;
  const Mesh& mesh = tree_.mesh(c.node);
  const int d = mesh.dimension();
  mesh.star(c.dart, 1, star_);
  for (const Dart t : star_)
    for (const NodeId child : children) {
      if (!tree_.may_have_links(child, t)) continue;
      const int k = tree_.mesh(child).dimension();
      for (const Permutation p : faces_around(d, k, -1)) {
        const Dart face = mesh.reorder(t, p);
        const Index f = tree_.link_of(child, face);
        if (f == no_index) continue;
        bool has_a = false, has_b = false;
        for (int j = 0; j <= k; ++j) has_a |= p[j] == 0, has_b |= p[j] == 1;
        if (has_a && has_b) {
          tree_.set_link_of(child, face, no_index);
        } else if (mesh.facet(tree_.mesh(child).anchor(f).parent) == mesh.facet(t)) {
          tree_.set_link_of(child, face, no_index);
          moved_.push_back({child, f, has_b ? End::b : End::a});
        }
      }
    }
}

void Propagation::write_halves(std::size_t i) {
  const Copy& c = copies_[i];
  Mesh& mesh = tree_.mesh(c.node);
  const Mesh& above = tree_.mesh(tree_.parent(c.node));
  const SplitRecord& above_record = splits_[c.above];
  for (const auto& [old, at_a, at_b] : splits_[i].facets) {
    const Anchor whole = mesh.anchor(old);
    for (const End end : {End::a, End::b}) {
      const Anchor half{mesh.after_split(splits_[i], whole.own, end),
                        above.after_split(above_record, whole.parent, end)};
      const Index facet = end == End::a ? at_a : at_b;
      mesh.set_anchor(facet, half);
      tree_.set_link_of(c.node, half.parent, facet);
    }
  }
}

}  // namespace multimesh
