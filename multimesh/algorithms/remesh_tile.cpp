// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh_tile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "multimesh/domains/periodic_domain/recut.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/error.hpp"

namespace multimesh {

namespace {

/// Where a tile with free sides is cut, in units of its periods. In the first cut, sides are curves; what is
/// bad at them is mended in the following ones, which run along edges that are good already, and keep them.
constexpr std::array<Vec3, 8> cuts{Vec3{0.5, 0.5, 0.5}, Vec3{0.25, 0.35, 0.3}, Vec3{0.7, 0.6, 0.65},
                                   Vec3{0.4, 0.2, 0.5},  Vec3{0.6, 0.8, 0.3},   Vec3{0.1, 0.45, 0.8},
                                   Vec3{0.8, 0.1, 0.4},  Vec3{0.35, 0.65, 0.2}};

void add(const RemeshResult& more, TileRemeshResult& sum) {
  RemeshResult now = more;
  now.splits += sum.splits, now.collapses += sum.collapses, now.swaps += sum.swaps, now.moves += sum.moves;
  now.seconds += sum.seconds;
  static_cast<RemeshResult&>(sum) = now;
}

/// In radians.
double least_angle(const PeriodicDomain& domain) {
  const Mesh& tile = domain.tree().mesh(domain.tile());
  double least = std::numbers::pi;
  for (Index f = 0; f < tile.capacity(2); ++f) {
    if (!tile.is_live(2, f)) continue;
    Index v[4];
    tile.vertices(tile.dart_of(2, f), v);
    for (int i = 0; i < 3; ++i) {
      const Vec3& at = domain.positions()[v[i]];
      const Vec3 a = domain.positions()[v[(i + 1) % 3]] - at, b = domain.positions()[v[(i + 2) % 3]] - at;
      least = std::min(least, std::atan2(cross(a, b).norm(), dot(a, b)));
    }
  }
  return least;
}

/// Each cut goes on with the best tile so far.
TileRemeshResult remesh_free(PeriodicDomain& domain, const RemeshOptions& options) {
  if (domain.report().cut_root_vertices > 0)
    throw InputError("the glued tile is not manifold: its sides cannot be free");
  TileRemeshResult result;
  for (const Vec3& at : cuts) {
    const bool is_first = result.edges == 0;
    RecutTile other(domain, at, is_first);
    const Embedding embedding = other.domain().embedding(is_first ? TileSides::flat : TileSides::frozen);
    TileRemeshResult now = result;
    add(remesh(embedding, other.domain().tile(), options), now);
    now.dropped_listed += other.dropped();
    PeriodicDomain back = other.back();
    if (!is_first && least_angle(back) <= least_angle(domain)) continue;
    domain = std::move(back);
    result = now;
  }
  return result;
}

}  // namespace

TileRemeshResult remesh(PeriodicDomain& domain, const TileRemeshOptions& options) {
  if (domain.tree().mesh(domain.tile()).dimension() != 2)
    throw UsageError("remesh: the tile is not one of triangles");
  if (options.sides == TileSides::free) return remesh_free(domain, options);
  TileRemeshResult result;
  add(remesh(domain.embedding(options.sides), domain.tile(), options), result);
  return result;
}

}  // namespace multimesh
