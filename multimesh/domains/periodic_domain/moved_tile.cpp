// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/moved_tile.hpp"

#include <algorithm>

namespace multimesh {

namespace {

/// A dart of the facet that begins with its i-th vertex.
Dart at_corner(const Mesh& mesh, Dart d, int i) {
  return i == 0   ? d
         : i == 1 ? mesh.reorder(d, permutation(1, 0, 2, 3))
         : i == 2 ? mesh.reorder(d, permutation(2, 1, 0, 3))
                  : mesh.reorder(d, permutation(3, 1, 2, 0));
}

}  // namespace

MovedTile::MovedTile(const PeriodicDomain& from, std::vector<LatticeVector> by)
    : domain_(from),
      tile_(from.tree().mesh(from.tile())),
      root_(from.tree().mesh(NodeId::root)),
      by_(std::move(by)) {
  find_keys();
}

void MovedTile::find_keys() {
  const int d = tile_.dimension();
  keys_.resize(root_.capacity(0));
  for (Index f = 0; f < tile_.capacity(d); ++f) {
    if (!tile_.is_live(d, f)) continue;
    for (int i = 0; i <= d; ++i) {
      const Dart corner = at_corner(tile_, tile_.dart_of(d, f), i);
      auto& keys = keys_[root_vertex(corner)];
      if (std::ranges::find(keys, offset(corner)) == keys.end()) keys.push_back(offset(corner));
    }
  }
  Index next = 0;
  for (auto& keys : keys_) {
    std::ranges::sort(keys);
    first_.push_back(next);
    next += static_cast<Index>(keys.size());
  }
}

Index MovedTile::number(Dart d) const {
  const Index r = root_vertex(d);
  return first_[r] + static_cast<Index>(std::ranges::lower_bound(keys_[r], offset(d)) - keys_[r].begin());
}

PeriodicTile MovedTile::lists() const {
  const int d = tile_.dimension();
  const Lattice& lattice = domain_.lattice();
  PeriodicTile out;
  DartBuffer copies;
  for (Index r = 0; r < keys_.size(); ++r) {
    if (keys_[r].empty()) continue;
    copies.clear();
    domain_.tree().to_child(domain_.tile(), root_.dart_of(0, r), 0, copies);
    const Index v = tile_.vertex(copies[0]);
    const Vec3 first = domain_.positions()[v] + lattice.shift(keys_[r][0] - domain_.offsets()[v]);
    for (const LatticeVector& key : keys_[r]) {
      const Vec3 p = first + lattice.shift(key - keys_[r][0]);
      out.points.push_back({p[0], p[1], p[2]});
    }
  }
  out.facets = {d, static_cast<Index>(out.points.size()), {}};
  for (Index f = 0; f < tile_.capacity(d); ++f) {
    if (!tile_.is_live(d, f)) continue;
    for (int i = 0; i <= d; ++i)
      out.facets.corners.push_back(number(at_corner(tile_, tile_.dart_of(d, f), i)));
    out.regions.push_back(domain_.region(f));
  }
  for (auto& listed : out.listed) listed.simplices.vertices = out.facets.vertices;
  return out;
}

PeriodicOptions MovedTile::gluing() const {
  PeriodicOptions options = domain_.gluing();
  options.pairs.clear();
  for (Index r = 0; r < keys_.size(); ++r)
    for (Index i = 1; i < keys_[r].size(); ++i) options.pairs.push_back({first_[r] + i, first_[r]});
  return options;
}

std::vector<MovedTile::Copy> MovedTile::copies_of(Dart simplex, int k) const {
  DartBuffer in_tile, star;
  domain_.tree().to_child(domain_.tile(), simplex, k, in_tile);
  std::vector<Copy> out;
  for (const Dart copy : in_tile) {
    tile_.star(copy, k, star);
    for (const Dart d : star) {
      const LatticeVector at = offset(d);
      if (std::ranges::any_of(out, [&](const Copy& c) { return c.offset == at; })) continue;
      out.push_back({at, {}});
      for (int i = 0; i <= k; ++i)
        out.back().vertices[static_cast<std::size_t>(i)] = number(at_corner(tile_, d, i));
    }
  }
  std::ranges::sort(out, {}, &Copy::offset);
  return out;
}

}  // namespace multimesh
