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

/// Where a tile with free sides is cut, in units of its periods. Sides stay as they are in each; what is bad
/// at those of one cut is mended in the next ones, whose sides run along edges that are good already.
constexpr int cuts = 12;
/// Spread evenly.
Vec3 place_of_cut(int i) {
  const auto along = [i](double step) { return 0.1 + 0.8 * std::fmod(0.5 + i * step, 1.0); };
  return {along(0.8191725134), along(0.6710436067), along(0.5497004779)};
}

void freeze_sides(PeriodicDomain& domain) {
  Mesh& root = domain.tree().mesh(NodeId::root);
  DartBuffer copies;
  for (Index v = 0; v < root.capacity(0); ++v) {
    if (!root.is_live(0, v)) continue;
    copies.clear();
    domain.tree().to_child(domain.tile(), root.dart_of(0, v), 0, copies);
    if (copies.size() > 1) root.set_locked(v, true);
  }
}

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
  for (int i = 0; i < cuts; ++i) {
    const bool is_first = result.edges == 0;
    RecutTile other(domain, place_of_cut(i), is_first);
    freeze_sides(other.domain());
    const Embedding embedding = other.domain().embedding();
    TileRemeshResult now = result;
    add(remesh(embedding, other.domain().tile(), options), now);
    now.dropped_listed += other.dropped();
    PeriodicDomain back = other.back();
    // Moving rounds, which may invert the thinnest triangles.
    if (std::max(other.domain().report().inverted_facets, back.report().inverted_facets) >
        domain.report().inverted_facets)
      continue;
    if (!is_first && least_angle(back) <= least_angle(domain)) continue;
    domain = std::move(back);
    result = now;
  }
  if (result.edges == 0)
    throw InputError("the tile has triangles too thin to be moved by a period: its sides cannot be free");
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
