// SPDX-License-Identifier: BSD-3-Clause
#include "test/periodic/tiles.hpp"

#include <algorithm>
#include <cmath>

#include "test/support/shapes.hpp"

namespace multimesh::test {

PeriodicTile square_tile(Index n, Index m) {
  Shape s = grid(n, m);
  for (auto& p : s.points) p[0] /= n, p[1] /= m;
  return {s.points, s.facets};
}

PeriodicTile cube_tile(Index n) {
  PeriodicTile t{{}, {3, (n + 1) * (n + 1) * (n + 1), {}}};
  const double h = 1.0 / n;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j)
      for (Index k = 0; k <= n; ++k) t.points.push_back({i * h, j * h, k * h});
  const std::array<Index, 3> step{(n + 1) * (n + 1), n + 1, 1};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k < n; ++k) {
        std::array<std::size_t, 3> order{0, 1, 2};
        do {  // a tetrahedron per way from corner to corner along the axes
          std::array<Index, 4> v{(i * (n + 1) + j) * (n + 1) + k};
          for (std::size_t s = 0; s < 3; ++s) v[s + 1] = v[s] + step[order[s]];
          const bool odd = (order[0] > order[1]) ^ (order[0] > order[2]) ^ (order[1] > order[2]);
          if (odd) std::swap(v[0], v[1]);
          t.facets.corners.insert(t.facets.corners.end(), v.begin(), v.end());
        } while (std::next_permutation(order.begin(), order.end()));
      }
  return t;
}

PeriodicOptions along(bool x, bool y, bool z, bool refine) {
  PeriodicOptions o;
  o.axes = {x, y, z};
  o.refine = refine;
  return o;
}

std::string refusal(const PeriodicTile& tile, const PeriodicOptions& options) {
  try {
    PeriodicDomain domain(tile, options);
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

std::size_t legal_edges(PeriodicDomain& domain) {
  Propagation operations(domain.tree());
  const Mesh& root = domain.tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index e = 0; e < root.capacity(1); ++e)
    if (root.is_live(1, e)) n += !operations.judge(NodeId::root, root.dart_of(1, e)).refusal.refused();
  return n;
}

bool copies_fit(const PeriodicDomain& domain) {
  const MultiMesh& tree = domain.tree();
  const Mesh &root = tree.mesh(NodeId::root), &tile = tree.mesh(domain.tile());
  DartBuffer copies;
  for (Index v = 0; v < root.capacity(0); ++v) {
    if (!root.is_live(0, v) || root.dart_of(0, v) == no_dart) continue;
    copies.clear();
    tree.to_child(domain.tile(), root.dart_of(0, v), 0, copies);
    bool fit = false;  // to one of them
    for (const Dart first : copies) {
      const Index one = tile.vertex(first);
      fit |= std::ranges::all_of(copies, [&](Dart d) {
        const Index w = tile.vertex(d);
        return domain.positions()[w] ==
               domain.positions()[one] + domain.lattice().shift(domain.offsets()[w] - domain.offsets()[one]);
      });
    }
    if (!fit) return false;
  }
  return true;
}

std::size_t inverted(const PeriodicDomain& domain) {
  const Mesh& tile = domain.tree().mesh(domain.tile());
  const Vec3 normal = mean_normal(domain);
  std::size_t n = 0;
  for (Index f = 0; f < tile.capacity(tile.dimension()); ++f)
    n += tile.is_live(tile.dimension(), f) && orientation(domain, f, normal) <= 0;
  return n;
}

double size(const PeriodicDomain& domain) {
  const Mesh& tile = domain.tree().mesh(domain.tile());
  const Vec3 normal = mean_normal(domain);
  double sum = 0;
  for (Index f = 0; f < tile.capacity(tile.dimension()); ++f)
    if (tile.is_live(tile.dimension(), f)) sum += signed_measure(domain, f, normal);
  return sum;
}

std::map<PeriodicTile::Region, double> sizes(const PeriodicDomain& domain) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  std::map<PeriodicTile::Region, double> sizes;
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    if (mesh.is_live(mesh.dimension(), f))
      sizes[domain.region(f)] += std::abs(signed_measure(domain, f, Vec3(0, 0, 1)));
  return sizes;
}

}  // namespace multimesh::test
