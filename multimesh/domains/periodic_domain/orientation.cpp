// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/periodic_domain/vertex_values.hpp"
#include "multimesh/geometry/orient3d.hpp"

namespace multimesh {

double signed_measure(const PeriodicDomain& domain, Index facet, const Eigen::Vector3d& normal) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  const auto& p = domain.positions();
  Index v[4];
  oriented_corners(mesh, facet, v);
  const Eigen::Vector3d area = (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]) / 2;
  return mesh.dimension() == 2 ? area.dot(normal) : area.dot(p[v[3]] - p[v[0]]) / 3;
}

int orientation(const PeriodicDomain& domain, Index facet, const Eigen::Vector3d& normal) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  const auto& p = domain.positions();
  Index v[4];
  oriented_corners(mesh, facet, v);
  const double *a = p[v[0]].data(), *b = p[v[1]].data(), *c = p[v[2]].data();
  return mesh.dimension() == 2 ? orient_against(normal.data(), a, b, c) : orient3d(a, b, c, p[v[3]].data());
}

Eigen::Vector3d mean_normal(const PeriodicDomain& domain) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (mesh.dimension() == 3) return sum;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    for (int i = 0; i < 3; ++i) sum[i] += signed_measure(domain, f, Eigen::Vector3d::Unit(i));
  }
  return sum.stableNormalized();
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
