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
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(mesh.dimension()); ++i) corners[i] = p[v[i]];
  return orientation_of_facet(mesh.dimension(), corners.data(), normal);
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

}  // namespace multimesh
