// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/embedding.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/domains/periodic_domain/domain_data.hpp"
#include "multimesh/domains/periodic_domain/tile_coordinates.hpp"

namespace multimesh {

namespace {

/// Changes of a coordinate up to this, relative to the size of the tile, are rounding.
constexpr double rounding = 1e-15;
/// The same of places that algorithms compute as solutions of equations.
constexpr double solved = 1e-9;

}  // namespace

TileCoordinates::TileCoordinates(PeriodicDomain& domain, bool keep_flat) : domain_(domain) {
  if (keep_flat) flat_.emplace(domain);
}

Vec3 TileCoordinates::place_of_copy(Index copy, Index v, const Vec3& x) const {
  const auto& offsets = domain_.offsets();
  return copy == v ? x : x + domain_.lattice().shift(offsets[copy] - offsets[v]);
}

std::vector<Vec3> TileCoordinates::periods() const {
  const Lattice& lattice = domain_.lattice();
  std::vector<Vec3> all;
  LatticeVector n;
  const auto range = [&](int axis) { return lattice.is_periodic(axis) ? 1 : 0; };
  for (n[0] = -range(0); n[0] <= range(0); ++n[0])
    for (n[1] = -range(1); n[1] <= range(1); ++n[1])
      for (n[2] = -range(2); n[2] <= range(2); ++n[2])
        if (n != LatticeVector{}) all.push_back(lattice.shift(n));
  return all;
}

Vec3 TileCoordinates::image_near(const Vec3& x, const Vec3& p) const {
  const LatticeVector n = domain_.lattice().rounded(p - x);
  return n == LatticeVector{} ? x : x + domain_.lattice().shift(n);
}

void TileCoordinates::set(Index v, const Vec3& x) {
  const MultiMesh& tree = domain_.tree();
  const Mesh& mesh = tree.mesh(node());
  auto& positions = domain_.positions();
  Vec3 to = x;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(x[i] - positions[v][i]) <= rounding * domain_.diagonal()) to[i] = positions[v][i];
  copies_.clear();
  tree.to_child(node(), tree.to_parent(node(), mesh.dart_of(0, v)), 0, copies_);
  const auto offset = [&](Dart d) { return domain_.offsets()[mesh.vertex(d)]; };
  const Index first =
      mesh.vertex(*std::ranges::min_element(copies_, [&](Dart d, Dart e) { return offset(d) < offset(e); }));
  const Vec3 place = place_of_copy(first, v, to);
  for (const Dart d : copies_) positions.set(mesh.vertex(d), place_of_copy(mesh.vertex(d), first, place));
}

Vec3 TileCoordinates::merged(const VertexChange& c) const {
  return domain_.positions().result(Operation::collapse, c);
}

void TileCoordinates::prescribe(Places places) {
  auto& positions = domain_.positions();
  if (!places) return positions.prescribe({});
  positions.prescribe([this, &positions, places = std::move(places)](const VertexChange& c) {
    std::optional<Vec3> x = places(c);
    if (!x) return x;
    *x = image_near(*x, (positions[c.a] + positions[c.b]) / 2);
    for (std::size_t i = 0; i < 3; ++i) {  // an edge in a flat side stays there
      const double both = positions[c.a][i];
      if (both == positions[c.b][i] && std::abs((*x)[i] - both) <= solved * domain_.diagonal())
        (*x)[i] = both;
    }
    return x;
  });
}

// A vertex that is merged into one with more copies than the edge has stays where it was.
void CopiesKeepTheirOffsets::finish(const Event& event) {
  if (event.operation == Operation::flip || event.copies.count(node()) < 2) return;
  const Mesh& mesh = event.tree.mesh(node());
  const auto& offsets = domain_.offsets();
  vertices_.clear();
  for (const Copy& c : event.copies.of(node()))
    vertices_.push_back(
        mesh.vertex(event.operation == Operation::split ? mesh.reorder(c.dart, exchange_ends) : c.dart));
  const Index first =
      *std::ranges::min_element(vertices_, [&](Index v, Index w) { return offsets[v] < offsets[w]; });
  auto& positions = domain_.positions();
  for (const Index v : vertices_) {
    const Vec3 place = positions[first] + domain_.lattice().shift(offsets[v] - offsets[first]);
    if (positions[v] != place) positions.set(v, place);
  }
}

void PeriodicDomain::Data::anchor() {
  Mesh& root = tree.mesh(NodeId::root);
  DartBuffer in_tile;
  std::size_t most = 0;
  Index best = no_index;
  for (Index v = 0; v < root.capacity(0); ++v) {
    if (!root.is_live(0, v) || root.dart_of(0, v) == no_dart) continue;
    if (root.is_locked(v)) return;
    in_tile.clear();
    tree.to_child(tile, root.dart_of(0, v), 0, in_tile);
    if (in_tile.size() > most) most = in_tile.size(), best = v;
  }
  root.set_locked(best, true);
}

Embedding PeriodicDomain::embedding(TileSides sides) {
  if (sides == TileSides::frozen) (void)add_cuts();
  const bool is_solid = tree().mesh(tile()).dimension() == 3;
  const bool may_drift = sides == TileSides::free || (sides == TileSides::flat && !has_flat_sides());
  if (is_solid && may_drift) data_->anchor();
  Embedding e(tree());
  e.set(LegalityOptions{.contact = true});
  e.add(offsets());
  e.add(positions());
  e.add(sources_of_vertices());
  e.add<CopiesKeepTheirOffsets>(*this);
  const Coordinates& places = e.add_coordinates(
      std::make_unique<TileCoordinates>(*this, sides == TileSides::flat), Embedding::Kind::space);
  if (is_solid || report().inverted_facets == 0) e.keep_orientation(places, mean_normal(*this));
  e.tell_parts(tile(), *data_->part);
  if (sides == TileSides::frozen && data_->cuts)
    e.keep("the sides of the tile are frozen", [cuts = *data_->cuts](NodeId n, Index) { return n == cuts; });
  return e;
}

}  // namespace multimesh
