// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/ranks.hpp"

#include <algorithm>

namespace multimesh::decimation {

Ranks::Ranks(EmbeddedMesh& surface, const DecimateOptions& options)
    : mesh_(surface.mesh()),
      has_sheets_(surface.node() != NodeId::root),
      weights_{0, options.seam_weight, options.curve_weight},
      strata_(surface.embedding(), surface.node()),
      curves_(strata_.curves()),
      ranks_(mesh_.capacity(0), Rank::free),
      curve_column_(surface.node(), 1, curves_, ColumnRules<Index>::larger()),
      rank_column_(surface.node(), ranks_,
                   [this](Operation, const VertexChange& c) { return std::max(ranks_[c.a], ranks_[c.b]); }) {
  strata_.trust(curves_);
  find_curves();
  rank_vertices();
  if (options.lock_boundary || options.lock_seams) lock(options.lock_boundary, options.lock_seams);
  if (strata_.may_facets_stay()) lock_what_stays();
  if (strata_.may_edges_be_kept()) lock_kept_edges(surface.tree(), surface.node());
  surface.operations().add(curve_column_).add(rank_column_);
}

void Ranks::find_curves() {
  for (Index e = 0; e < curves_.size(); ++e)
    if (curves_[e] != plain) curves_[e] = strata_.kind(mesh_.dart_of(1, e)).is_only_seam() ? seam : shape;
}

void Ranks::rank_vertices() {
  const std::vector<Freedom> freedoms = strata_.freedoms();
  for (Index v = 0; v < ranks_.size(); ++v)
    ranks_[v] = freedoms[v] == Freedom::surface ? Rank::free
                : freedoms[v] == Freedom::line  ? Rank::on_curve
                                                : Rank::fixed;
}

void Ranks::lock(bool boundary, bool seams) {
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e) || curves_[e] == plain) continue;
    const Dart d = mesh_.dart_of(1, e);
    if (!(mesh_.is_boundary(d, 1) ? boundary : seams && strata_.kind(d).is_seam())) continue;
    for (const Dart end : {d, mesh_.reorder(d, exchange_ends)}) ranks_[mesh_.vertex(end)] = Rank::locked;
  }
}

void Ranks::lock_what_stays() {
  for (Index v = 0; v < ranks_.size(); ++v)
    if (const Dart d = mesh_.is_live(0, v) ? mesh_.dart_of(0, v) : no_dart;
        d != no_dart && strata_.facets_stay_at(d))
      ranks_[v] = Rank::locked;
}

// All copies of an end: what is done to one is done to all.
void Ranks::lock_kept_edges(const MultiMesh& tree, NodeId node) {
  Copies copies;
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    const Dart d = mesh_.is_live(1, e) ? mesh_.dart_of(1, e) : no_dart;
    if (d == no_dart || !strata_.is_kept(d)) continue;
    for (const Dart end : {d, mesh_.reorder(d, exchange_ends)}) {
      copies.collect(tree, node, end, 0);
      for (const Copy& c : copies.of(node)) ranks_[mesh_.vertex(c.dart)] = Rank::locked;
    }
  }
}

}  // namespace multimesh::decimation
