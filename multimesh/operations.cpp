// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/operations.hpp"

#include <algorithm>
#include <string>

#include "multimesh/faces.hpp"

namespace multimesh {

Propagation& Propagation::add(Attribute& a) {
  tree_.require_closed("adding an attribute");
  const Mesh& mesh = tree_.mesh(a.node());
  const bool stored = a.dimension() == corners ? mesh.corner_capacity() > 0
                                               : a.dimension() >= 0 && a.dimension() <= mesh.dimension() &&
                                                     mesh.stores(a.dimension());
  if (!stored)
    throw UsageError("mesh " + std::to_string(index(a.node())) + " stores no values of this dimension");
  a.require_size(a.slots(mesh));
  attributes_.push_back(&a);
  if (a.dimension() != 0) {
    if (columns_.size() <= index(a.node())) columns_.resize(index(a.node()) + 1);
    columns_[index(a.node())].all |= column_bit(a.dimension());
    if (a.needs_kept()) columns_[index(a.node())].need_kept |= column_bit(a.dimension());
  }
  return *this;
}

Propagation& Propagation::add(Invariant& i) {
  tree_.require_closed("adding an invariant");
  invariants_.push_back(&i);
  return *this;
}

Propagation& Propagation::set(LegalityOptions o) {
  tree_.require_idle("setting options");
  legality_options_ = o;
  return *this;
}

// When elements are renumbered, vectors that the mesh does not own must be updated by the caller.
void Propagation::require_sizes() {
  const bool renumbered = renumberings_ != tree_.renumberings_;
  for (const Attribute* a : attributes_)
    if (tree_.contains(a->node()))
      a->require_size(a->slots(*tree_.nodes_[index(a->node())].mesh), renumbered);
  renumberings_ = tree_.renumberings_;
}

void Propagation::stage() {
  if (on_stage) on_stage(stage_++);
}

void Propagation::start(NodeId n, Dart d, int k) {
  find_copies(n, d, k);
  ++statistics_.tried;
  stage_ = 0;
  changes_.clear();
  done_.simplices.clear();
  done_.corners.clear();
  require_sizes();
}

// Maps the simplex to the root and finds its copies everywhere. Checks for outside edits before traversing:
// walking from a dead halfedge may never terminate.
void Propagation::find_copies(NodeId n, Dart d, int k) {
  tree_.require_dart(n, d);
  if (k > tree_.mesh(n).dimension()) [[unlikely]]
    tree_.require_simplex(n, d, k);
  tree_.require_star_in_step(n, d, k);
  for (; n != NodeId::root; n = tree_.parent(n)) {
    d = tree_.image(n, d);
    tree_.require_star_in_step(tree_.parent(n), d, k);
  }
  copies_.collect(tree_, d, k);
  for (std::size_t i = 1; i < copies_.size(); ++i)
    tree_.require_star_in_step(copies_[i].node, copies_[i].dart, k);
}

std::size_t Propagation::copy_of(NodeId n, Dart d, int k) const {
  const Mesh& mesh = tree_.mesh(n);
  std::size_t i = copies_.first(n);
  while (!mesh.same_simplex(copies_[i].dart, d, k)) ++i;
  return i;
}

Outcome Propagation::refuse(Refusal r) {
  ++statistics_.refused[static_cast<std::size_t>(r.check)];
  return {r, no_dart, no_dart};
}

Outcome Propagation::succeed(Operation operation, Dart dart, Dart root, Dart changed, int changed_dimension) {
  ++statistics_.done;
  return {{}, dart, root, changed, changed_dimension, operation};
}

Refusal Propagation::ask(bool (Invariant::*when)(const Event&), const Event& event) {
  for (Invariant* i : invariants_)
    if (tree_.contains(i->node()) && !(i->*when)(event)) return {Check::invariant, i->node(), i->name()};
  return {};
}

void Propagation::update_attributes(const Event& event) {
  const bool all_may_grow = event.operation == Operation::split || protect_properties_;
  const bool edges_may_grow = !columns_.empty() && event.operation == Operation::flip;
  if (all_may_grow || edges_may_grow)
    for (Attribute* a : attributes_)
      if (tree_.contains(a->node())) a->grow(a->slots(tree_.mesh(a->node())));
  for (const VertexChange& c : changes_)
    for (Attribute* a : attributes_)
      if (a->node() == c.node) a->update(event.operation, c);
  for (Attribute* a : attributes_)
    if (tree_.contains(a->node())) a->finish(event);
}

// All faces of the facets around the ends of each copy, and around the new ends of a swapped one, each once.
void Propagation::protect_neighbourhoods(Operation operation) {
  if (!protect_properties_) return;
  for (const Copy& c : copies_.all()) {
    Mesh& mesh = tree_.mesh(c.node);
    const int d = mesh.dimension();
    for (auto& list : around_) list.clear();
    DartBuffer ends{c.dart, mesh.reorder(c.dart, exchange_ends)};
    if (operation == Operation::flip) {
      mesh.star(c.dart, 1, star_);
      for (const Dart t : star_) ends.push_back(mesh.reorder(t, permutation(2, 0, 1)));
    }
    for (const Dart end : ends) {
      mesh.star(end, 0, star_);
      for (const Dart t : star_) {
        Index v[4];
        mesh.vertices(t, v);
        around_[0].insert(around_[0].end(), v, v + d + 1);
        for (int k = 1; k <= d; ++k)
          for (const Permutation p : faces_around(d, k, -1))
            around_[k].push_back(mesh.simplex(mesh.reorder(t, p), k));
      }
    }
    for (int k = 0; k <= d; ++k) {
      std::sort(around_[k].begin(), around_[k].end());
      around_[k].erase(std::unique(around_[k].begin(), around_[k].end()), around_[k].end());
      for (const Index s : around_[k]) mesh.protect(k, s);
    }
  }
}

Outcome Propagation::swap(NodeId n, Dart e) {
  const Operating operating(tree_);
  if (tree_.mesh(NodeId::root).dimension() > 2) return swap_in_steps(n, e);
  start(n, e, 1);
  const std::size_t asked = copy_of(n, e, 1);
  if (!flippable()) return refuse({Check::flip, n, {}});
  const Event event{tree_, Operation::flip, copies_, 0.5, &done_};
  stage();
  if (const Refusal r = ask(&Invariant::before, event); r.refused()) return refuse(r);
  Transaction transaction(tree_, attributes_, Transaction::Own::yes);
  protect_neighbourhoods(Operation::flip);
  collect_reanchored_by_flip();
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    stage();
    Copy& c = copies_.all()[i];
    Mesh& mesh = tree_.mesh(c.node);
    const Dart old = c.dart, outer = mesh.reorder(old, permutation(0, 2, 1));  // (a,l,.): its code stays
    if (has_columns(c.node)) note_flipping(c);
    mesh.flip_edge(old);
    c.dart = mesh.reorder(outer, permutation(1, 2, 0));  // (l,r,a)
    if (has_columns(c.node)) note_flipped(i);
  }
  for (const auto& [node, anchor] : reanchored_) {
    const Index facet = tree_.mesh(node).facet(anchor.own);
    tree_.mesh(node).set_anchor(facet, anchor);
    tree_.set_link_of(node, anchor.parent, facet);
  }
  update_attributes(event);
  stage();
  if (const Refusal r = ask(&Invariant::after, event); r.refused()) return refuse(r);
  stage();
  transaction.commit();
  return succeed(Operation::flip, copies_[asked].dart, copies_[0].dart, copies_[0].dart, 1);
}

Refusal Propagation::why_not_swap(NodeId n, Dart e) {
  const Operating operating(tree_);
  if (tree_.mesh(NodeId::root).dimension() > 2)
    throw UsageError("swaps in a tetrahedral mesh are sequences; whether one is refused is told by doing it");
  find_copies(n, e, 1);
  if (!flippable()) return {Check::flip, n, {}};
  return ask(&Invariant::before, {tree_, Operation::flip, copies_});
}

// The edge must be interior in every mesh that has it, in one copy only, and in no mesh of lower dimension.
bool Propagation::flippable() const {
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    const Copy& c = copies_[i];
    const Mesh& mesh = tree_.mesh(c.node);
    if (mesh.dimension() != 2 || !mesh.can_flip(c.dart)) return false;
    for (std::size_t j = i + 1; j < copies_.size(); ++j)
      if (copies_[j].node == c.node && copies_[j].above == c.above) return false;
  }
  return true;
}

// The triangles (a,l,r) and (b,l,r) of a child get anchors on their outer edges, where codes do not change;
// so do the points at a and b. Curves are on these edges already.
void Propagation::collect_reanchored_by_flip() {
  reanchored_.clear();
  for (const Copy& c : copies_.all()) {
    const MultiMesh::Node& node = tree_.nodes_[index(c.node)];
    if (c.node != NodeId::root)
      for (const Permutation outer : {edge_ax, edge_bx}) {
        const Dart own = node.mesh->reorder(c.dart, outer);
        reanchored_.push_back({c.node, {own, tree_.image(c.node, own)}});
      }
    for (const NodeId child : node.children) {
      const Mesh& below = *tree_.nodes_[index(child)].mesh;
      if (below.dimension() > 0) continue;
      for (const Permutation outer : {edge_ax, edge_bx}) {
        const Dart at = node.mesh->reorder(c.dart, outer);
        if (const Index point = tree_.link_of(child, at); point != no_index)
          reanchored_.push_back({child, {below.anchor(point).own, at}});
      }
    }
  }
}

Outcome Propagation::relocate(NodeId n, Dart v, const std::function<void(const Event&)>& write) {
  const Operating operating(tree_);
  start(n, v, 0);
  const Event event{tree_, Operation::relocate, copies_, 0.5, &done_};
  stage();
  if (const Refusal r = ask(&Invariant::before, event); r.refused()) return refuse(r);
  Transaction transaction(tree_, attributes_, Transaction::Own::yes);
  protect_neighbourhoods(Operation::relocate);
  write(event);
  stage();
  for (const Copy& c : copies_.all()) {
    const Index own = tree_.mesh(c.node).vertex(c.dart);
    const Index above =
        c.node == NodeId::root ? no_index : tree_.mesh(tree_.parent(c.node)).vertex(copies_[c.above].dart);
    changes_.push_back({own, own, own, 0, c.node, above});
  }
  update_attributes(event);
  stage();
  if (const Refusal r = ask(&Invariant::after, event); r.refused()) return refuse(r);
  transaction.commit();
  return succeed(Operation::relocate, v, copies_[0].dart, copies_[0].dart);
}

CollapseVerdict Propagation::judge(NodeId n, Dart e) {
  const Operating operating(tree_);
  find_copies(n, e, 1);
  return legality_.collapse(tree_, copies_, legality_options_);
}

}  // namespace multimesh
