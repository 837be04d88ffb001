// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/strata.hpp"

#include <algorithm>

#include "multimesh/strata.hpp"

namespace multimesh::decimation {

Strata::Strata(const EmbeddedMesh& surface, const DecimateOptions& options)
    : surface_(surface),
      tree_(surface.tree()),
      mesh_(surface.mesh()),
      curve_weight_(options.curve_weight),
      seam_weight_(options.seam_weight),
      ranks_(mesh_.capacity(0), Rank::free),
      lines_(mesh_.capacity(1), Line::none) {
  const std::vector<Index> curves = find_curves();
  for (Index e = 0; e < curves.size(); ++e)
    if (curves[e] != 0) lines_[e] = line(mesh_.dart_of(1, e));
  rank_vertices(curves);
  lock(options);
}

/// Per edge: 1 if anything runs along it. At the root these are the images of what has them: a look at every
/// edge costs far more.
std::vector<Index> Strata::find_curves() const {
  std::vector<Index> numbers(mesh_.capacity(1), 0);
  if (has_sheets()) {
    for (Index e = 0; e < mesh_.capacity(1); ++e)
      if (mesh_.is_live(1, e)) numbers[e] = line(mesh_.dart_of(1, e)) != Line::none;
    return numbers;
  }
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    for (Index e = 0; mesh.dimension() > 0 && e < mesh.capacity(1); ++e) {
      if (!mesh.is_live(1, e)) continue;
      const Dart d = mesh.dart_of(1, e);
      if (mesh.dimension() == 1 || mesh.is_boundary(d, 1)) numbers[mesh_.simplex(tree_.to_root(n, d), 1)] = 1;
    }
  }
  return numbers;
}

/// Per vertex: whether it may be anything but free.
std::vector<bool> Strata::special_vertices(const std::vector<Index>& curves) const {
  std::vector<bool> special(mesh_.capacity(0), has_sheets());
  if (has_sheets()) return special;
  for (Index e = 0; e < curves.size(); ++e) {
    if (curves[e] == 0) continue;
    const Dart d = mesh_.dart_of(1, e);
    special[mesh_.vertex(d)] = special[mesh_.vertex(mesh_.reorder(d, exchange_ends))] = true;
  }
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && (mesh.dimension() == 0 || mesh.is_locked(v)) && mesh.dart_of(0, v) != no_dart)
        special[mesh_.vertex(tree_.to_root(n, mesh.dart_of(0, v)))] = true;
  }
  return special;
}

void Strata::rank_vertices(const std::vector<Index>& curves) {
  multimesh::Strata strata(tree_, surface_.node());
  const std::vector<bool> special = special_vertices(curves);
  strata.trust(curves);
  for (Index v = 0; v < mesh_.capacity(0); ++v) {
    const Dart d = special[v] && mesh_.is_live(0, v) ? mesh_.dart_of(0, v) : no_dart;
    if (d == no_dart) continue;
    const Freedom freedom = strata.freedom(d);
    ranks_[v] = freedom == Freedom::surface ? Rank::free
                : freedom == Freedom::line  ? Rank::on_curve
                                            : Rank::fixed;
  }
}

void Strata::lock(const DecimateOptions& options) {
  if (!options.lock_boundary && !options.lock_seams) return;
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e)) continue;
    const Dart d = mesh_.dart_of(1, e);
    if (!(options.lock_boundary && mesh_.is_boundary(d, 1)) && !(options.lock_seams && is_seam(d))) continue;
    for (const Dart end : {d, mesh_.reorder(d, exchange_ends)}) ranks_[mesh_.vertex(end)] = Rank::locked;
  }
}

// A vertex inside a sheet is in no other one.
void Strata::sheets(Dart e, Index a, Index b, DartBuffer& out) const {
  out.assign(1, e);
  if (surface_.node() == NodeId::root || ranks_[a] == Rank::free || ranks_[b] == Rank::free) return;
  copies_.collect(tree_, surface_.node(), e, 1);
  for (const Copy& c : copies_.of(surface_.node()))
    if (!mesh_.same_simplex(c.dart, e, 1)) out.push_back(c.dart);
}

bool Strata::is_seam(Dart e) const {
  copies_.collect(tree_, surface_.node(), e, 1);
  return !mesh_.is_boundary(e, 1) && std::ranges::any_of(surface_.charts(), [&](const Coordinates* chart) {
    return copies_.count(chart->node()) > 1;
  });
}

Strata::Line Strata::line_of(const Copy& c, std::size_t copies) const {
  const Mesh& mesh = tree_.mesh(c.node);
  if (mesh.dimension() == 1)
    return surface_.is_only_seam(c.node, mesh.facet(c.dart)) ? Line::seam : Line::shape;
  if (mesh.dimension() != 2) return Line::none;
  const bool is_chart = std::ranges::any_of(
      surface_.charts(), [&](const Coordinates* chart) { return chart->node() == c.node; });
  if (copies > 1) return is_chart ? Line::seam : Line::shape;
  return mesh.is_boundary(c.dart, 1) ? Line::shape : Line::none;
}

Strata::Line Strata::line(Dart e) const {
  if (mesh_.is_boundary(e, 1)) return Line::shape;
  copies_.collect(tree_, surface_.node(), e, 1);
  Line most = Line::none;
  for (const Copy& c : copies_.all()) most = std::max(most, line_of(c, copies_.count(c.node)));
  return most;
}

void Strata::merge(Index kept, Index gone, bool renew) {
  ranks_[kept] = std::max(ranks_[kept], ranks_[gone]);
  if (!renew) return;
  edges_around(mesh_, mesh_.dart_of(0, kept), edges_);
  for (const Dart e : edges_)
    if (ranks_[mesh_.vertex(mesh_.reorder(e, exchange_ends))] != Rank::free)
      lines_[mesh_.simplex(e, 1)] = line(e);
}

double Strata::weight(Dart e) const {
  const Line l = lines_[mesh_.simplex(e, 1)];
  return l == Line::none ? 0 : l == Line::seam ? seam_weight_ : curve_weight_;
}

}  // namespace multimesh::decimation
