// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/strata.hpp"

#include <algorithm>

namespace multimesh::decimation {

CurveKinds seam_kinds(const TexturedSurface& surface) {
  CurveKinds kinds = no_curve;
  for (std::size_t k = 0; k < surface.textures().size(); ++k) kinds |= seam_of(k);
  return kinds;
}

Strata::Strata(const TexturedSurface& surface, const DecimateOptions& options)
    : surface_(surface),
      tree_(surface.tree()),
      root_(tree_.mesh(NodeId::root)),
      curve_weight_(options.curve_weight),
      seam_weight_(options.seam_weight),
      seam_kinds_(seam_kinds(surface)),
      ranks_(root_.capacity(0), Rank::free) {
  rank_curves();
  rank_fixed_points();
}

bool Strata::is_curve(Dart e) const {
  if (root_.is_boundary(e, 1)) return true;
  const auto seams = surface_.seams();
  return seams && tree_.facet_over(*seams, e) != no_index;
}

double Strata::weight(Dart e) const {
  if (root_.is_boundary(e, 1)) return curve_weight_;
  const CurveKinds kinds = surface_.curve_kinds(e);
  if (kinds == no_curve) return 0;
  return kinds & ~seam_kinds_ ? curve_weight_ : seam_weight_;
}

void Strata::rank_curves() {
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    const Dart d = root_.dart_of(1, e);
    if (!is_curve(d)) continue;
    for (const Dart end : {d, root_.switch_dart(d, 0)}) ranks_[root_.vertex(end)] = Rank::on_curve;
  }
}

// Labelled vertices, and where curves end or meet.
void Strata::rank_fixed_points() {
  for (Index v = 0; v < root_.capacity(0); ++v)
    if (root_.is_locked(v)) ranks_[v] = Rank::fixed;
  const auto seams = surface_.seams();
  if (!seams) return;
  const Mesh& curves = tree_.mesh(*seams);
  for (Index v = 0; v < curves.capacity(0); ++v) {
    if (!curves.is_live(0, v)) continue;
    const Dart d = curves.dart_of(0, v);
    if (d != no_dart && curves.is_boundary(d, 0))
      ranks_[root_.vertex(tree_.to_parent(*seams, d))] = Rank::fixed;
  }
}

}  // namespace multimesh::decimation
