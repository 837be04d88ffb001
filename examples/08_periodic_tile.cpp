// SPDX-License-Identifier: BSD-3-Clause
// A cube of tetrahedra that repeats in all directions. The corner of the cube is moved, with all eight copies
// of it. Then the mesh is coarsened until no edge may be collapsed, and still repeats.
#include <algorithm>
#include <iostream>

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/keeps_orientation.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

/// n^3 cubes, each cut into six tetrahedra around its main diagonal.
PeriodicTile cube(Index n) {
  PeriodicTile tile{{}, {3, 0, {}}};
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j)
      for (Index k = 0; k <= n; ++k) tile.points.push_back({double(i) / n, double(j) / n, double(k) / n});
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k < n; ++k) {
        std::array<Index, 3> steps{1, n + 1, (n + 1) * (n + 1)};
        do {  // from corner to corner along the axes, in each of six orders
          Index v = (i * (n + 1) + j) * (n + 1) + k;
          tile.facets.corners.push_back(v);
          for (const Index step : steps) tile.facets.corners.push_back(v += step);
        } while (std::next_permutation(steps.begin(), steps.end()));
      }
  return tile;
}

int main() {
  try {
    PeriodicDomain(cube(2));
  } catch (const InputError& e) {
    std::cout << "2 x 2 x 2 cubes: " << e.what() << '\n';
  }
  PeriodicDomain domain(cube(6));
  Propagation propagation(domain.tree());
  domain.attach(propagation);
  KeepsOrientation positive(domain.positions());  // no tetrahedron may turn over, around any copy
  propagation.add(positive);

  const Mesh& tile = domain.tree().mesh(domain.tile());
  const Dart corner = tile.dart_of(0, 0);
  const Outcome moved = domain.move(propagation, domain.tile(), corner, {0.03, 0.02, 0.01});
  const auto copies = propagation.copies().count(domain.tile());
  std::cout << "moved the corner: " << (moved ? copies : 0) << " copies\n";

  const Mesh& root = domain.tree().mesh(NodeId::root);
  std::size_t collapses = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index t = 0; t < root.capacity(3); ++t)
      for (std::uint8_t p = 0; p < 24 && root.is_live(3, t); ++p) {  // every edge of it, both ways
        const Dart edge = root.reorder(root.dart_of(3, t), {p});
        if (propagation.collapse(NodeId::root, edge)) ++collapses, changed = true;
      }
  }
  const PeriodicTile coarse = domain.tile_lists();
  std::cout << collapses << " collapses: " << coarse.facets.size() << " tetrahedra, copies differ by "
            << domain.mismatch() << " of the tile's size\n";
  const bool ok = copies == 8 && coarse.facets.size() < 600 && domain.mismatch() < 1e-12 &&
                  validate(domain.tree()).empty();
  return ok ? 0 : 1;
}
