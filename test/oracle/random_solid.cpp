// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/random_solid.hpp"

#include <algorithm>

#include "oracle/collapse.hpp"
#include "oracle/orientation.hpp"
#include "oracle/split.hpp"

namespace multimesh::oracle {

namespace {

/// A triangle times an edge, as three tetrahedra. Prisms over neighbouring triangles fit if all are cut with
/// ascending columns.
void add_prism(Complex& c, std::array<int, 3> low, std::array<int, 3> high) {
  c.facets.push_back({low[0], low[1], low[2], high[2]});
  c.facets.push_back({low[0], low[1], high[1], high[2]});
  c.facets.push_back({low[0], high[0], high[1], high[2]});
}

Complex solid_torus() {
  Complex c{3, {}};
  for (int i = 0; i < 3; ++i) {
    const int low = 3 * i, high = 3 * ((i + 1) % 3);
    add_prism(c, {low, low + 1, low + 2}, {high, high + 1, high + 2});
  }
  return c;
}

Complex shell() {
  Complex c{3, {}};
  for (const std::array<int, 3>& t : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})
    add_prism(c, t, {t[0] + 4, t[1] + 4, t[2] + 4});
  return c;
}

/// As the 7-vertex torus, with steps 1, 2, 4, 8 modulo 15 (Kühnel and Lassak 1988).
Complex torus15() {
  SimplexSet all;
  std::array<int, 4> steps{1, 2, 4, 8};
  do {
    for (int i = 0; i < 15; ++i) {
      const int a = i + steps[0], b = a + steps[1], c = b + steps[2];
      all.push_back(simplex({i, a % 15, b % 15, c % 15}));
    }
  } while (std::next_permutation(steps.begin(), steps.end()));
  normalize(all);
  Complex torus{3, {}};
  for (const Simplex& s : all) torus.facets.push_back(s.v);
  return torus;
}

}  // namespace

Complex base_solid(Solid kind) {
  Complex c{3, {{0, 1, 2, 3}}};
  if (kind == Solid::kSphere)
    c.facets = {{1, 2, 3, 4}, {0, 2, 3, 4}, {0, 1, 3, 4}, {0, 1, 2, 4}, {0, 1, 2, 3}};
  if (kind == Solid::kSolidTorus) c = solid_torus();
  if (kind == Solid::kShell) c = shell();
  if (kind == Solid::kTorus) c = torus15();
  orient(c);
  return c;
}

namespace {

Simplex random_edge_of(const Complex& mesh, std::mt19937_64& rng) {
  const Facet& f = mesh.facets[pick(rng, mesh.facets.size())];
  const std::size_t i = pick(rng, 4), step = 1 + pick(rng, 3);
  return simplex({f[i], f[(i + step) % 4]});
}

}  // namespace

Complex random_solid(Solid kind, std::size_t facets, std::mt19937_64& rng) {
  Complex mesh = base_solid(kind);
  const std::size_t most = facets + pick(rng, 16);
  while (mesh.facets.size() < most) {
    const Simplex e = random_edge_of(mesh, rng);
    mesh = split({{{mesh, -1, {}}}}, e.v[0], e.v[1]).tree.nodes[0].mesh;
  }
  for (int attempt = 0; attempt < 60 && mesh.facets.size() > facets; ++attempt) {
    const Simplex e = random_edge_of(mesh, rng);
    if (link_condition(mesh, e.v[0], e.v[1]))
      mesh = collapse({{{mesh, -1, {}}}}, e.v[0], e.v[1]).tree.nodes[0].mesh;
  }
  return mesh;
}

SimplexSet random_lump(const Complex& mesh, std::mt19937_64& rng) {
  const SimplexSet all = facet_set(mesh);
  SimplexSet lump{all[pick(rng, all.size())]};
  const std::size_t most = std::max<std::size_t>(1, pick(rng, all.size() / 2 + 1));
  for (int tries = 0; tries < 60 && lump.size() < most; ++tries) {
    const Simplex& from = lump[pick(rng, lump.size())];
    const Simplex side = minus(from, simplex({from.v[pick(rng, 4)]}));
    for (const Simplex& t : star(all, side))
      if (std::find(lump.begin(), lump.end(), t) == lump.end()) {
        lump.push_back(t);
        break;
      }
  }
  normalize(lump);
  return lump;
}

namespace {

Complex complex_of(const SimplexSet& tetrahedra) {
  Complex c{3, {}};
  for (const Simplex& s : tetrahedra) c.facets.push_back(s.v);
  return c;
}

void add_walk(const SimplexSet& all, std::mt19937_64& rng, SimplexSet& triangles) {
  Simplex at = all[pick(rng, all.size())];
  for (std::size_t steps = 1 + pick(rng, 6); steps > 0; --steps) {
    triangles.push_back(at);
    const SimplexSet next = star(all, minus(at, simplex({at.v[pick(rng, 3)]})));
    at = next[pick(rng, next.size())];
  }
}

}  // namespace

SimplexSet random_triangles(const Complex& mesh, std::mt19937_64& rng) {
  const SimplexSet all = simplices(mesh), sides = of_dimension(all, 2);
  const SimplexSet points = of_dimension(all, 0);
  SimplexSet triangles;
  while (triangles.empty()) {
    if (chance(rng, 50)) triangles = of_dimension(boundary(complex_of(random_lump(mesh, rng))), 2);
    if (chance(rng, 25)) {
      const SimplexSet around = of_dimension(link(all, points[pick(rng, points.size())]), 2);
      triangles.insert(triangles.end(), around.begin(), around.end());
    }
    if (chance(rng, 30)) add_walk(sides, rng, triangles);
    if (chance(rng, 15)) triangles.push_back(sides[pick(rng, sides.size())]);
    if (chance(rng, 20)) {  // an open surface, or one that is off the boundary of the mesh
      const SimplexSet rim = boundary(mesh);
      std::erase_if(triangles, [&](const Simplex& s) { return contains(rim, s); });
    }
  }
  normalize(triangles);
  return triangles;
}

}  // namespace multimesh::oracle
