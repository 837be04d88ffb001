// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/held.hpp"

#include <algorithm>

#include "multimesh/faces.hpp"

namespace multimesh::improvement {

Held::Held(const TetDomain& domain, const std::vector<TetDomain::Tag>& locked_regions)
    : domain_(domain), mesh_(domain.mesh()), locked_regions_(locked_regions), strata_(mesh_.capacity(0), 0) {
  std::sort(locked_regions_.begin(), locked_regions_.end());
  hold_faces();
  if (domain.curves()) hold_curves();
  for (Index v = 0; v < mesh_.capacity(0); ++v)
    if (mesh_.is_live(0, v) && mesh_.is_locked(v)) strata_[v] |= fixed;
}

bool Held::is_locked_tet(Index t) const {
  return !locked_regions_.empty() &&
         std::binary_search(locked_regions_.begin(), locked_regions_.end(), domain_.regions()[t]);
}

bool Held::is_held_face(Dart f) const {
  const Dart beyond = mesh_.switch_dart(f, 3);
  if (beyond == no_dart) return true;
  if (domain_.regions()[tet::TetMesh::tet(f)] != domain_.regions()[tet::TetMesh::tet(beyond)]) return true;
  return domain_.surface() && domain_.tree().facet_over(*domain_.surface(), f) != no_index;
}

bool Held::face(Dart f) const {
  Index v[4];
  mesh_.vertices(f, v);
  return (strata_[v[0]] & strata_[v[1]] & strata_[v[2]] & on_face) && is_held_face(f);
}

bool Held::curve(Dart e) const {
  Index v[4];
  mesh_.vertices(e, v);
  return (strata_[v[0]] & strata_[v[1]] & on_curve) &&
         domain_.tree().facet_over(*domain_.curves(), e) != no_index;
}

void Held::hold_faces() {
  for (Index t = 0; t < mesh_.capacity(3); ++t) {
    if (!mesh_.is_live(3, t)) continue;
    const Index* v = mesh_.corners(t);
    if (is_locked_tet(t))
      for (int i = 0; i < 4; ++i) strata_[v[i]] |= fixed;
    for (const Permutation p : faces_around(3, 2, -1))
      if (is_held_face(tet::TetMesh::dart(t, p)))
        for (int i = 0; i < 3; ++i) strata_[v[p[i]]] |= on_face;
  }
}

bool Held::is_copied(Dart e) const {
  Index v[4];
  mesh_.vertices(e, v);
  return (strata_[v[0]] & strata_[v[1]] & fixed) && domain_.is_copied_edge(e);
}

// A vertex is regular if just one vertex of the curves lies over it, and that is no end.
void Held::hold_curves() {
  const Mesh& curves = domain_.tree().mesh(*domain_.curves());
  for (Index v = 0; v < curves.capacity(0); ++v) {
    if (!curves.is_live(0, v)) continue;
    const Dart d = curves.dart_of(0, v);
    std::uint8_t& strata = strata_[mesh_.vertex(domain_.tree().to_root(*domain_.curves(), d))];
    if ((strata & on_curve) || curves.is_boundary(d, 0)) strata |= fixed;
    strata |= on_curve;
  }
}

}  // namespace multimesh::improvement
