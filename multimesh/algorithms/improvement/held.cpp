// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/held.hpp"

#include <algorithm>

#include "multimesh/faces.hpp"

namespace multimesh::improvement {

Held::Held(const TetDomain& domain, const ImproveOptions& options)
    : domain_(domain),
      mesh_(domain.mesh()),
      locked_regions_(options.locked_regions),
      locked_patches_(options.locked_patches),
      lock_surface_(options.lock_surface),
      strata_(mesh_.capacity(0), 0) {
  std::sort(locked_regions_.begin(), locked_regions_.end());
  std::sort(locked_patches_.begin(), locked_patches_.end());
  hold_faces();
  if (domain.curves()) hold_curves();
  for (Index v = 0; v < mesh_.capacity(0); ++v)
    if (mesh_.is_live(0, v) && mesh_.is_locked(v)) strata_[v] |= fixed;
  const auto points = domain.fixed_points();
  for (Index p = 0; points && p < domain.tree().mesh(*points).capacity(0); ++p)
    if (const Mesh& mesh = domain.tree().mesh(*points); mesh.is_live(0, p))
      strata_[mesh_.vertex(domain.tree().to_root(*points, mesh.dart_of(0, p)))] |= fixed;
}

bool Held::is_locked_tet(Index t) const {
  return (domain_.flags(3, t) & required_simplex) ||
         (!locked_regions_.empty() &&
          std::binary_search(locked_regions_.begin(), locked_regions_.end(), domain_.regions()[t]));
}

bool Held::is_locked_face(Dart f) const {
  if (lock_surface_ || !domain_.surface()) return lock_surface_;
  const Index triangle = domain_.tree().facet_over(*domain_.surface(), f);
  return triangle != no_index &&
         ((domain_.flags(2, triangle) & required_simplex) ||
          std::binary_search(locked_patches_.begin(), locked_patches_.end(), domain_.patch(triangle)));
}

bool Held::is_locked_edge(Dart e) const {
  Index v[4];
  mesh_.vertices(e, v);
  if (!(strata_[v[0]] & strata_[v[1]] & fixed)) return false;
  if (domain_.is_copied_edge(e)) return true;
  if (!(strata_[v[0]] & strata_[v[1]] & on_curve)) return false;
  const Index edge = domain_.tree().facet_over(*domain_.curves(), e);
  return edge != no_index && (domain_.flags(1, edge) & required_simplex);
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
      if (const Dart f = tet::TetMesh::dart(t, p); is_held_face(f)) {
        const std::uint8_t strata = is_locked_face(f) ? on_face | fixed : on_face;
        for (int i = 0; i < 3; ++i) strata_[v[p[i]]] |= strata;
      }
  }
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
  for (Index e = 0; e < curves.capacity(1); ++e) {
    if (!curves.is_live(1, e) || !(domain_.flags(1, e) & required_simplex)) continue;
    const Dart d = domain_.tree().to_root(*domain_.curves(), curves.dart_of(1, e));
    for (const Dart end : {d, mesh_.reorder(d, exchange_ends)}) strata_[mesh_.vertex(end)] |= fixed;
  }
}

}  // namespace multimesh::improvement
