// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/domain_report.hpp"

#include <algorithm>
#include <numbers>

#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh {

namespace {

using Point = TetDomain::Point;

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

DomainReport report(const TetDomain& domain) {
  return report(domain, topology_of(domain.tagged()));
}

DomainReport report(const TetDomain& domain, TetTopology joined) {
  DomainReport r;
  const tet::TetMesh& mesh = domain.mesh();
  r.tets = std::move(joined);
  r.min_dihedral = std::numbers::pi;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    Point p[4];
    for (int i = 0; i < 4; ++i) p[i] = domain.points()[mesh.corners(t)[i]];
    const double volume = six_volume(p[0], p[1], p[2], p[3]) / 6;
    r.inverted_tets += orient3d(p[0].data(), p[1].data(), p[2].data(), p[3].data()) <= 0;
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
  if (const auto p = domain.fixed_points()) {
    const Mesh& points = domain.tree().mesh(*p);
    for (Index v = 0; v < points.capacity(0); ++v)
      if (points.is_live(0, v)) ++r.fixed_points, ++r.fixed_tags[domain.fixed_tag(v)];
  }
  return r;
}

}  // namespace multimesh
