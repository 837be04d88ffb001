// SPDX-License-Identifier: BSD-3-Clause
// Changes that columns are notified of, and which of two values wins where a collapse makes one simplex of
// two.
#include <algorithm>

#include "multimesh/faces.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

namespace {

/// An ordering of the same facet with this position first.
Dart beginning_with(const Mesh& mesh, Dart d, int position) {
  constexpr std::array<Permutation, 4> first{Permutation{}, permutation(1, 0), permutation(2, 0, 1),
                                             permutation(3, 0, 1, 2)};
  return mesh.reorder(d, first[static_cast<std::size_t>(position)]);
}

constexpr std::array<Index, 4> no_corners{no_index, no_index, no_index, no_index};

std::array<Index, 4> corners_of(const Mesh& mesh, Dart d) {
  std::array<Index, 4> all = no_corners;
  if (mesh.corner(d) == no_index) return all;
  for (int i = 0; i <= mesh.dimension(); ++i)
    all[static_cast<std::size_t>(i)] = mesh.corner(beginning_with(mesh, d, i));
  return all;
}

}  // namespace

// Records facets that will change, with the names of their corners.
void Propagation::remember_facets(NodeId n, const DartBuffer& facets) {
  const Mesh& mesh = tree_.mesh(n);
  const bool has_corners = has_column(n, corners);
  old_facets_.clear();
  for (const Dart t : facets)
    old_facets_.push_back({t, mesh.facet(t), has_corners ? corners_of(mesh, t) : no_corners});
}

void Propagation::note_corners(std::size_t i, const OldFacet& old, Dart now, int replaced) {
  const Mesh& mesh = tree_.mesh(copies_[i].node);
  if (old.corners[0] == no_index) return;
  const auto to = corners_of(mesh, now);
  for (std::size_t p = 0; p <= static_cast<std::size_t>(mesh.dimension()); ++p) {
    const bool is_new = static_cast<int>(p) == replaced;
    if (!is_new && to[p] == old.corners[p]) continue;
    done_.corners.push_back({copies_[i].node, static_cast<std::uint32_t>(i), to[p], old.corners[p],
                             is_new ? old.corners[0] : no_index, is_new ? old.corners[1] : no_index});
  }
}

void Propagation::note_whole(const Copy& c) {
  const Mesh& mesh = tree_.mesh(c.node);
  mesh.star(c.dart, 1, star_);
  remember_facets(c.node, star_);
  old_edge_ = mesh.stores(1) ? mesh.simplex(c.dart, 1) : no_index;
}

void Propagation::note_halves(std::size_t i) {
  using Kind = SimplexChange::Kind;
  const NodeId n = copies_[i].node;
  const Mesh& mesh = tree_.mesh(n);
  const int d = mesh.dimension();
  for (const OldFacet& old : old_facets_) {
    const Dart at_a = mesh.after_split(splits_[i], old.dart, End::a);
    const Dart at_b = mesh.after_split(splits_[i], old.dart, End::b);
    if (mesh.stores(1) && &old == &old_facets_.front())
      done_.simplices.push_back(
          {n, 1, Kind::halved, mesh.simplex(at_a, 1), mesh.simplex(at_b, 1), old_edge_});
    if (d > 1) done_.simplices.push_back({n, d, Kind::halved, mesh.facet(at_a), mesh.facet(at_b), old.facet});
    if (d == 2) done_.simplices.push_back({n, 1, Kind::fresh, mesh.simplex(mesh.reorder(at_a, edge_bx), 1)});
    note_corners(i, old, at_a, 1);
    note_corners(i, old, at_b, 0);
  }
}

// Before the collapse: the edges of a surface that will become one, and the facets whose corners move.
void Propagation::note_merging(std::size_t i) {
  const NodeId n = copies_[i].node;
  const Mesh& mesh = tree_.mesh(n);
  old_facets_.clear();
  if (has_column(n, corners)) remember_facets(n, region_.renamed);
  merging_edges_.clear();
  if (mesh.dimension() != 2 || taking_back_ || !has_column(n, 1)) return;
  for (const Dart t : region_.dead) {
    const Dart at_b = mesh.reorder(t, edge_bx);
    const Index x = mesh.vertex(beginning_with(mesh, t, 2));
    merging_edges_.push_back(
        {at_b, mesh.simplex(mesh.reorder(t, edge_ax), 1), mesh.simplex(at_b, 1), mergings_[i].wins(x)});
  }
}

void Propagation::note_merged(std::size_t i) {
  const NodeId n = copies_[i].node;
  const Mesh& mesh = tree_.mesh(n);
  const CollapseRecord& record = collapses_[i];
  const double t = mergings_[i].t;
  for (const auto& [dart, at_a, at_b, a_wins] : merging_edges_) {
    const Index now = mesh.simplex(mesh.after_collapse(record, dart), 1);
    done_.simplices.push_back({n, 1, SimplexChange::Kind::merged, now, now == at_b ? at_a : at_b, no_index,
                               a_wins == (now == at_b), now == at_b ? 1 - t : t});
  }
  for (const OldFacet& old : old_facets_) note_corners(i, old, mesh.after_collapse(record, old.dart), -1);
}

void Propagation::note_flipping(const Copy& c) {
  const Mesh& mesh = tree_.mesh(c.node);
  mesh.star(c.dart, 1, star_);  // (a,b,l), (a,b,r)
  remember_facets(c.node, star_);
}

void Propagation::note_flipped(std::size_t i) {
  using Kind = SimplexChange::Kind;
  const NodeId n = copies_[i].node;
  const Mesh& mesh = tree_.mesh(n);
  const Dart at_a = copies_[i].dart, at_b = mesh.switch_dart(at_a, 2);  // (l,r,a), (l,r,b)
  const Index edge = mesh.simplex(at_a, 1);
  done_.simplices.push_back({n, 1, Kind::swapped, edge, edge});
  done_.simplices.push_back({n, 2, Kind::swapped, mesh.facet(at_a), mesh.facet(at_b)});
  for (const auto& [now, end] : {std::pair(at_a, 0U), std::pair(at_b, 1U)}) {
    const bool stays = mesh.facet(now) == old_facets_[0].facet;
    OldFacet mixed = old_facets_[stays ? 0 : 1];
    mixed.corners = {old_facets_[0].corners[2], old_facets_[1].corners[2], mixed.corners[end], no_index};
    note_corners(i, mixed, now, -1);
  }
}

bool Propagation::is_in_mesh_below(NodeId n, Dart d, int k) const {
  const auto below = tree_.descendants(n);
  return std::any_of(below.begin(), below.end(), [&](NodeId m) {
    return tree_.mesh(m).dimension() == k && tree_.is_covered(n, d, k, m);
  });
}

// Called before anything changes: then all maps are valid.
void Propagation::note_winners(std::size_t i, double t) {
  Merging& merging = mergings_[i];
  merging.t = t;
  merging.keep_b = taking_back_;
  merging.a_wins.clear();
  const Copy& c = copies_[i];
  if (taking_back_ || tree_.descendants(c.node).empty()) return;
  const Mesh& mesh = tree_.mesh(c.node);
  const int d = mesh.dimension();
  for (int k = 1; k < d; ++k) {
    const auto below = tree_.descendants(c.node);
    const bool may_win =
        std::any_of(below.begin(), below.end(), [&](NodeId m) { return tree_.mesh(m).dimension() == k; });
    if (!may_win || !(must_find_kept(c.node, k) || mesh.has_values(k))) continue;
    mesh.star(c.dart, 1, star_);
    for (const Dart facet : star_)
      for (const Permutation p : faces_around(d, k + 1, 1)) {
        const Dart whole = mesh.reorder(facet, p);  // (a, b, x, ..)
        if (!is_in_mesh_below(c.node, mesh.reorder(whole, without_b(k)), k) ||
            is_in_mesh_below(c.node, mesh.reorder(whole, without_a(k)), k))
          continue;
        Index v[4];
        mesh.vertices(whole, v);
        merging.add_winner(v[2], k == 1 ? no_index : v[3]);
      }
  }
}

// Other copies of this mesh have not been collapsed yet: they use the previous names of vertices.
void Propagation::rename_winners(std::size_t i) {
  const CollapseRecord& record = collapses_[i];
  for (std::size_t j = copies_.first(copies_[i].node); j < i; ++j)
    mergings_[j].rename(record.dead, record.survivor);
}

}  // namespace multimesh
