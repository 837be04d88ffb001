// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/domain_report.hpp"

#include <algorithm>
#include <numbers>

#include "multimesh/algorithms/tet_shape.hpp"
#include "multimesh/pair_numbers.hpp"
#include "multimesh/tet_sides.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

using Point = TetDomain::Point;

std::size_t count_roots(UnionFind& sets, const std::vector<bool>& used) {
  std::size_t n = 0;
  for (Index i = 0; i < used.size(); ++i) n += used[i] && sets.find(i) == i;
  return n;
}

/// The smallest angle between two faces.
double min_dihedral(const Point (&p)[4]) {
  double least = std::numbers::pi;
  for (const auto& [i, j] : edge_corners) {
    const auto& [k, l] = edge_corners[5 - edge_number[i][j]];  // the opposite edge
    least = std::min(least, dihedral_angle(p[i], p[j], p[k], p[l]));
  }
  return least;
}

}  // namespace

TetReport report_tets(const tet::TetMesh& mesh) {
  TetReport r;
  const Index slots = mesh.capacity(0);
  UnionFind pieces(slots), rims(slots);
  std::vector<bool> used(slots, false), on_rim(slots, false);
  PairNumbers edges(slots);
  std::size_t rim_faces = 0;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    ++r.tets;
    const Index* v = mesh.corners(t);
    for (int i = 0; i < 4; ++i) {
      used[v[i]] = true;
      pieces.join(v[0], v[i]);
      for (int j = 0; j < i; ++j) edges(v[i], v[j]);
      const Dart face = tet::TetMesh::dart(t, permutation((i + 1) % 4, (i + 2) % 4, (i + 3) % 4, i));
      if (!mesh.is_boundary(face, 2)) continue;
      ++rim_faces;
      for (int j = 1; j < 4; ++j) {
        on_rim[v[(i + j) % 4]] = true;
        rims.join(v[(i + 1) % 4], v[(i + j) % 4]);
      }
    }
  }
  r.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  r.edges = edges.size();
  r.faces = (4 * r.tets + rim_faces) / 2;
  r.components = count_roots(pieces, used);
  r.euler_characteristic = static_cast<long>(r.vertices) - static_cast<long>(r.edges) +
                           static_cast<long>(r.faces) - static_cast<long>(r.tets);
  r.boundary_components = count_roots(rims, on_rim);
  r.boundary_euler_characteristic =
      static_cast<long>(std::count(on_rim.begin(), on_rim.end(), true)) - static_cast<long>(rim_faces / 2);
  return r;
}

DomainReport report(const TetDomain& domain) {
  DomainReport r;
  const tet::TetMesh& mesh = domain.mesh();
  r.tets = report_tets(mesh);
  r.min_dihedral = std::numbers::pi;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    Point p[4];
    for (int i = 0; i < 4; ++i) p[i] = domain.points()[mesh.corners(t)[i]];
    const double volume = six_volume(p[0], p[1], p[2], p[3]) / 6;
    r.inverted_tets += !(volume > 0);
    r.min_dihedral = std::min(r.min_dihedral, min_dihedral(p));
    RegionReport& region = r.regions[domain.regions()[t]];
    ++region.tets;
    region.volume += volume;
  }
  if (const auto s = domain.surface()) {
    const Mesh& surface = domain.tree().mesh(*s);
    r.surface = report(surface);
    for (Index f = 0; f < surface.capacity(2); ++f)
      if (surface.is_live(2, f)) ++r.patches[domain.patch(f)];
  }
  if (const auto c = domain.curves()) {
    const Mesh& curves = domain.tree().mesh(*c);
    r.curves = report(curves);
    for (Index e = 0; e < curves.capacity(1); ++e)
      if (curves.is_live(1, e)) ++r.curve_tags[domain.curve_tag(e)];
  }
  return r;
}

}  // namespace multimesh
