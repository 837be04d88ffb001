// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/recut.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "multimesh/domains/periodic_domain/moved_tile.hpp"

namespace multimesh {

namespace {

/// Calls visit(index, value) for the middles of facets, in units of the periods.
template <class Visit>
void for_middles(const PeriodicDomain& domain, const Visit& visit) {
  const Mesh& tile = domain.tree().mesh(domain.tile());
  const int d = tile.dimension();
  for (Index f = 0; f < tile.capacity(d); ++f) {
    if (!tile.is_live(d, f)) continue;
    Index v[4];
    tile.vertices(tile.dart_of(d, f), v);
    Vec3 sum{};
    for (int i = 0; i <= d; ++i) sum += domain.positions()[v[i]];
    visit(f, domain.lattice().coordinates(sum / (d + 1)));
  }
}

/// Calls visit(k, image in the root, label) for all that is listed.
template <class Visit>
void for_listed(const PeriodicDomain& domain, const Visit& visit) {
  for (int k = 0; k < domain.tree().mesh(domain.tile()).dimension(); ++k) {
    const std::optional<NodeId> node = domain.listed(k);
    if (!node) continue;
    const Mesh& mesh = domain.tree().mesh(*node);
    for (Index s = 0; s < mesh.capacity(k); ++s)
      if (mesh.is_live(k, s) && !domain.label(k, s).copies.empty())
        visit(k, domain.tree().to_parent(*node, mesh.dart_of(k, s)), domain.label(k, s));
  }
}

bool is_in_sides(const PeriodicDomain& domain, int k, Dart image) {
  DartBuffer copies;
  domain.tree().to_child(domain.tile(), image, k, copies);
  return copies.size() > 1;
}

/// The moved tile. What is listed has one copy each. `dropped`: if not null, what lies in the sides is left
/// out, and counted.
PeriodicDomain glued(const PeriodicDomain& from, std::vector<LatticeVector> by, std::size_t* dropped) {
  const MovedTile moved(from, std::move(by));
  PeriodicTile lists = moved.lists();
  for_listed(from, [&](int k, Dart image, const PeriodicLabel& label) {
    if (dropped && is_in_sides(from, k, image)) return void(++*dropped);
    const MovedTile::Copy copy = moved.copies_of(image, k).front();
    auto& listed = lists.listed[static_cast<std::size_t>(k)];
    listed.simplices.corners.insert(listed.simplices.corners.end(), copy.vertices.begin(),
                                    copy.vertices.begin() + k + 1);
    listed.tags.push_back(label.copies.front().tag);
  });
  return PeriodicDomain(lists, moved.gluing());
}

}  // namespace

RecutTile::RecutTile(const PeriodicDomain& home, const Vec3& at, bool drop)
    : domain_(moved(home, at, drop)) {}

PeriodicDomain RecutTile::moved(const PeriodicDomain& home, const Vec3& at, bool drop) {
  const Lattice& lattice = home.lattice();
  const Mesh& tile = home.tree().mesh(home.tile());
  origin_ = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  for (Index v = 0; v < tile.capacity(0); ++v)
    if (tile.is_live(0, v) && tile.dart_of(0, v) != no_dart)
      origin_ = min(origin_, lattice.coordinates(home.positions()[v]));
  std::vector<LatticeVector> by(tile.capacity(tile.dimension()));
  for_middles(home, [&](Index f, const Vec3& middle) {
    for (std::size_t i = 0; i < 3; ++i)
      by[f][i] = lattice.is_periodic(static_cast<int>(i)) && middle[i] - origin_[i] < at[i];
  });
  return glued(home, std::move(by), drop ? &dropped_ : nullptr);
}

PeriodicDomain RecutTile::back() const {
  const Mesh& tile = domain_.tree().mesh(domain_.tile());
  std::vector<LatticeVector> by(tile.capacity(tile.dimension()));
  for_middles(domain_, [&](Index f, const Vec3& middle) {
    for (std::size_t i = 0; i < 3; ++i)
      if (domain_.lattice().is_periodic(static_cast<int>(i)))
        by[f][i] = -static_cast<int>(std::floor(middle[i] - origin_[i]));
  });
  return glued(domain_, std::move(by), nullptr);
}

}  // namespace multimesh
