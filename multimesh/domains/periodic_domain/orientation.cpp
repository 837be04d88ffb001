// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/geometry/orient3d.hpp"

namespace multimesh {

double signed_measure(const PeriodicDomain& domain, Index facet, const Vec3& normal) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  const auto& p = domain.positions();
  Index v[4];
  mesh.vertices(mesh.dart_of(mesh.dimension(), facet), v);  // in the order of its orientation
  const Vec3 area = cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]) / 2;
  return mesh.dimension() == 2 ? dot(area, normal) : dot(area, p[v[3]] - p[v[0]]) / 3;
}

int orientation(const PeriodicDomain& domain, Index facet, const Vec3& normal) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  const auto& p = domain.positions();
  Index v[4];
  mesh.vertices(mesh.dart_of(mesh.dimension(), facet), v);  // in the order of its orientation
  const double *a = p[v[0]].data(), *b = p[v[1]].data(), *c = p[v[2]].data();
  return mesh.dimension() == 2 ? orient_against(normal.data(), a, b, c) : orient3d(a, b, c, p[v[3]].data());
}

Vec3 mean_normal(const PeriodicDomain& domain) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  Vec3 sum{};
  if (mesh.dimension() == 3) return sum;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    sum[0] += signed_measure(domain, f, {1, 0, 0});
    sum[1] += signed_measure(domain, f, {0, 1, 0});
    sum[2] += signed_measure(domain, f, {0, 0, 1});
  }
  return sum.unit_or_zero();
}

TileStaysPositive::TileStaysPositive(const PeriodicDomain& domain)
    : Invariant("tile stays positive", domain.tile()), domain_(domain), normal_(mean_normal(domain)) {}

bool TileStaysPositive::after(const Event& event) {
  const Mesh& mesh = event.tree.mesh(node());
  const int around = event.operation == Operation::flip ? 1 : 0;
  for (const Copy& c : event.copies.of(node())) {
    // After a split, (a, c, ..): the new vertex is c.
    const Dart d = event.operation == Operation::split ? mesh.reorder(c.dart, exchange_ends) : c.dart;
    mesh.star(d, around, star_);
    for (const Dart t : star_)
      if (orientation(domain_, mesh.facet(t), normal_) <= 0) return false;
  }
  return true;
}

}  // namespace multimesh
