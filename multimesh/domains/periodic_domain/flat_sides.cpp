// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/flat_sides.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh {

namespace {

/// Points that are this far from a plane, relative to the size of the tile, lie in it.
constexpr double rounding = 1e-12;

constexpr Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Vec3 point(const PeriodicTile& tile, Index v) {
  return {tile.points[v][0], tile.points[v][1], tile.points[v][2]};
}

bool is_axis(const Vec3& n) {
  return std::ranges::find(axes, n) != std::end(axes);
}

}  // namespace

FlatSides::FlatSides(const PeriodicDomain& domain) : domain_(domain), tile_normal_(mean_normal(domain)) {
  const PeriodicTile tile = domain.tile_lists();
  for (const PeriodicSide& side : domain.sides())
    if (const auto n = normal_of(side, tile)) {
      normals_[side.shift] = *n;
    } else {
      all_ = false;
    }
}

bool FlatSides::is_flat(const PeriodicSide& side, const PeriodicTile& tile, const Vec3& normal) const {
  const Vec3 first = point(tile, side.master.corners.front());
  return std::ranges::all_of(side.master.corners, [&](Index v) {
    return std::abs(dot(point(tile, v) - first, normal)) <= rounding * domain_.diagonal();
  });
}

// Where a plane is that of two axes, it is taken to be just that: then coordinates stay the same ones.
std::optional<Vec3> FlatSides::normal_of(const PeriodicSide& side, const PeriodicTile& tile) const {
  for (const Vec3& axis : axes)
    if (std::abs(dot(axis, tile_normal_)) < rounding && is_flat(side, tile, axis)) return axis;
  Vec3 largest{};
  for (std::size_t f = 0; f < side.master.size(); ++f) {
    const auto v = side.master.facet(f);
    const Vec3 a = point(tile, v[0]), b = point(tile, v[1]);
    const Vec3 n = v.size() == 2 ? cross(b - a, tile_normal_) : cross(b - a, point(tile, v[2]) - a);
    if (n.norm() > largest.norm()) largest = n;
  }
  const Vec3 normal = largest.unit_or_zero();
  if (normal == Vec3{} || !is_flat(side, tile, normal)) return std::nullopt;
  return normal;
}

// Orthogonal to each other.
std::vector<Vec3> FlatSides::normals_at(Index v) const {
  const MultiMesh& tree = domain_.tree();
  const Mesh& mesh = tree.mesh(domain_.tile());
  DartBuffer copies;
  tree.to_child(domain_.tile(), tree.to_parent(domain_.tile(), mesh.dart_of(0, v)), 0, copies);
  std::vector<Vec3> normals;
  const auto& offsets = domain_.offsets();
  for (const Dart c : copies)
    for (const Dart d : copies) {
      const auto side = normals_.find(offsets[mesh.vertex(d)] - offsets[mesh.vertex(c)]);
      if (side == normals_.end()) continue;
      Vec3 n = side->second;
      for (const Vec3& m : normals) n -= dot(n, m) * m;
      constexpr double independent = 1e-6;
      if (n.norm() > independent) normals.push_back(is_axis(n) ? n : n.unit_or_zero());
    }
  return normals;
}

Vec3 FlatSides::allowed(Index v, const Vec3& x) const {
  if (normals_.empty()) return x;
  const std::vector<Vec3> normals = normals_at(v);
  const Vec3& here = domain_.positions()[v];
  if (normals.size() == 3) return here;
  Vec3 place = x;
  for (const Vec3& n : normals)
    if (!is_axis(n)) place -= dot(place - here, n) * n;
  for (const Vec3& n : normals)
    for (std::size_t i = 0; i < 3; ++i)
      if (n == axes[i]) place[i] = here[i];
  return place;
}

bool PeriodicDomain::has_flat_sides() const {
  return FlatSides(*this).are_all();
}

}  // namespace multimesh
