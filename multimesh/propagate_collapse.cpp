// SPDX-License-Identifier: BSD-3-Clause
// Edge collapse in every mesh of a tree. Bottom-up: when a mesh is changed, the child facets over its dying
// facets are already dead and unlinked. Every child facet that is still anchored in a changed facet therefore
// survives, and only its parent dart needs the new name. Reads come before writes, copy by copy.
#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

namespace {

/// The end that must be kept (0 or 1), or the one that strata prefer, or nothing.
std::optional<double> held_end(const CollapseVerdict& v, bool respect_strata) {
  if (v.hold_a || v.hold_b) return v.hold_a ? 0.0 : 1.0;
  if (respect_strata && v.prefer_a != v.prefer_b) return v.prefer_a ? 0.0 : 1.0;
  return std::nullopt;
}

}  // namespace

// t: the resulting place of the merged vertex.
Refusal Propagation::judge_placed(Placement placement, double& t) {
  const CollapseVerdict verdict = legality_.collapse(tree_, copies_, legality_options_);
  if (verdict.refusal.refused()) return verdict.refusal;
  t = placement.t;
  const auto held = held_end(verdict, placement.respect_strata && !placement.strict);
  if (!held || *held == t) return {};
  if (placement.strict) return {Check::placement, NodeId::root, {}};
  t = *held;
  return {};
}

Outcome Propagation::collapse(NodeId n, Dart e, Placement placement) {
  const Operating operating(tree_);
  return collapse_inside(n, e, placement);
}

Outcome Propagation::collapse_inside(NodeId n, Dart e, Placement placement) {
  start(n, e, 1);
  const std::size_t asked = copy_of(n, e, 1);
  double t = 0;
  if (const Refusal r = judge_placed(placement, t); r.refused()) return refuse(r);
  return collapse_judged(asked, t);
}

Refusal Propagation::why_not_collapse(NodeId n, Dart e, Placement placement) {
  const Operating operating(tree_);
  find_copies(n, e, 1);
  double t = 0;
  if (const Refusal r = judge_placed(placement, t); r.refused()) return r;
  let_b_survive(t);
  return ask(&Invariant::before, {tree_, Operation::collapse, copies_, t});
}

Outcome Propagation::collapse(NodeId n, Dart e, const Chooser& choose) {
  const Operating operating(tree_);
  start(n, e, 1);
  const std::size_t asked = copy_of(n, e, 1);
  const CollapseVerdict verdict = legality_.collapse(tree_, copies_, legality_options_);
  if (verdict.refusal.refused()) return refuse(verdict.refusal);
  const auto held = held_end(verdict, true);
  const double t = choose({tree_, Operation::collapse, copies_, 0.5}, held);
  return collapse_judged(asked, held.value_or(t));
}

// Makes the end that keeps its place survive, with its index and every property.
void Propagation::let_b_survive(double& t) {
  if (t > 0) return;
  for (Copy& c : copies_.all()) c.dart = tree_.mesh(c.node).reorder(c.dart, exchange_ends);
  t = 1;
}

Outcome Propagation::collapse_judged(std::size_t asked, double t) {
  if (!(t >= 0 && t <= 1)) throw UsageError("the new vertex must lie on the edge: 0 <= t <= 1");
  let_b_survive(t);
  const Event event{tree_, Operation::collapse, copies_, t, &done_};
  stage();
  if (const Refusal r = ask(&Invariant::before, event); r.refused()) return refuse(r);

  Transaction transaction(tree_, attributes_, Transaction::Own::yes);
  protect_neighbourhoods(Operation::collapse);
  if (collapses_.size() < copies_.size()) {
    collapses_.resize(copies_.size());
    mergings_.resize(copies_.size());
  }
  for (std::size_t i = 0; i < copies_.size(); ++i) note_winners(i, t);
  for (std::size_t i = copies_.size(); i-- > 0;) {
    stage();
    if (!collapse_copy(i)) return refuse({Check::link_condition, copies_[i].node, {}});
  }
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    Copy& c = copies_.all()[i];
    const CollapseRecord& r = collapses_[i];
    c.dart = r.at_survivor;
    for (std::size_t j = i; j-- > 0 && copies_[j].node == c.node;)
      c.dart = tree_.mesh(c.node).after_collapse(collapses_[j], c.dart);
    const Index above = c.node == NodeId::root ? no_index : collapses_[c.above].survivor;
    changes_.push_back({r.dead, r.survivor, r.survivor, t, c.node, above});
  }
  stage();
  update_attributes(event);
  stage();
  if (const Refusal r = ask(&Invariant::after, event); r.refused()) return refuse(r);
  stage();
  transaction.commit();
  return succeed(Operation::collapse, copies_[asked].dart, copies_[0].dart, copies_[0].dart);
}

// The name of a dart of this copy's mesh after the earlier collapses of copies in the same mesh.
Dart Propagation::after_earlier_collapses(std::size_t i, Dart d) const {
  const NodeId n = copies_[i].node;
  for (std::size_t j = copies_.first(n) + copies_.count(n); j-- > i + 1;)
    d = tree_.mesh(n).after_collapse(collapses_[j], d);
  return d;
}

// False if the link condition fails now that other copies in this mesh have been collapsed.
bool Propagation::collapse_copy(std::size_t i) {
  const NodeId n = copies_[i].node;
  Mesh& mesh = tree_.mesh(n);
  const Dart e = after_earlier_collapses(i, copies_[i].dart);
  const bool first = i + 1 == copies_.first(n) + copies_.count(n);
  if (!first && !mesh.link_condition(e)) return false;

  mesh.collapse_region(e, region_);
  if (mesh.dimension() > 1) mesh.merge_values(e, mergings_[i]);
  if (has_columns(n)) note_merging(i);
  if (n != NodeId::root) unlink_dead(n);
  moved_.clear();
  collect_moved_by_collapse(n);

  CollapseRecord& record = collapses_[i];
  mesh.collapse_edge(e, record);
  if (has_columns(n)) note_merged(i);
  if (i > copies_.first(n)) rename_winners(i);
  for (const Moved& m : moved_) {
    Mesh& below = tree_.mesh(m.child);
    Anchor a = below.anchor(m.facet);
    a.parent = mesh.after_collapse(record, a.parent);
    below.set_anchor(m.facet, a);
    if (below.dimension() < mesh.dimension()) tree_.set_link_of(m.child, a.parent, m.facet);
  }
  if (n != NodeId::root)
    for (const Dart t : region_.renamed) {
      const Index f = mesh.facet(mesh.after_collapse(record, t));
      Anchor a = mesh.anchor(f);
      a.own = mesh.after_collapse(record, a.own);
      mesh.set_anchor(f, a);
    }
  return true;
}

void Propagation::unlink_dead(NodeId n) {
  const Mesh& mesh = tree_.mesh(n);
  for (const Dart t : region_.dead) tree_.set_link_of(n, mesh.anchor(mesh.facet(t)).parent, no_index);
}

void Propagation::collect_moved_by_collapse(NodeId n) {
  const Mesh& mesh = tree_.mesh(n);
  for (const NodeId child : tree_.children(n)) {
    if (tree_.mesh(child).dimension() == mesh.dimension()) {
      for (const Dart t : region_.renamed)
        if (const Index f = tree_.link_of(child, t); f != no_index) moved_.push_back({child, f, End::b});
    } else {
      for (const Dart t : region_.dead) collect_anchored_in(child, t);
      for (const Dart t : region_.renamed) collect_anchored_in(child, t);
    }
  }
}

// Child facets over faces of this facet that are anchored in it. They are unlinked until they are renamed.
void Propagation::collect_anchored_in(NodeId child, Dart facet) {
  if (!tree_.may_have_links(child, facet)) return;
  const Mesh& below = tree_.mesh(child);
  const Mesh& mesh = tree_.mesh(tree_.parent(child));
  for (const Permutation p : faces_around(mesh.dimension(), below.dimension(), -1)) {
    const Dart face = mesh.reorder(facet, p);
    const Index f = tree_.link_of(child, face);
    if (f == no_index || mesh.facet(below.anchor(f).parent) != mesh.facet(facet)) continue;
    tree_.set_link_of(child, face, no_index);
    moved_.push_back({child, f, End::b});
  }
}

}  // namespace multimesh
