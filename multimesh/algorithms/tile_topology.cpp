// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/tile_topology.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace multimesh {

namespace {

long euler_of(const FacetList& faces) {
  std::set<std::array<Index, 2>> edges;
  std::set<Index> vertices;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto v = faces.facet(f);
    for (std::size_t j = 0; j < v.size(); ++j) {
      vertices.insert(v[j]);
      for (std::size_t i = 0; i < j; ++i) edges.insert({std::min(v[i], v[j]), std::max(v[i], v[j])});
    }
  }
  const long n = static_cast<long>(vertices.size()) - static_cast<long>(edges.size());
  return faces.dimension == 2 ? n + static_cast<long>(faces.size()) : n;
}

/// Faces of the root as lists: its boundary, and those between regions.
class FacesOfRoot {
 public:
  explicit FacesOfRoot(const PeriodicDomain& domain)
      : domain_(domain), root_(domain.tree().mesh(NodeId::root)), tile_(domain.tree().mesh(domain.tile())) {
    const int k = root_.dimension() - 1;
    boundary.dimension = interface.dimension = k;
    boundary.vertices = interface.vertices = root_.capacity(0);
    for (Index s = 0; s < root_.capacity(k); ++s) {
      if (!root_.is_live(k, s)) continue;
      const Dart d = root_.dart_of(k, s);
      root_.star(d, k, star_);
      if (star_.size() == 1) add(d, boundary);
      if (star_.size() == 2 && region(star_[0]) != region(star_[1])) add(d, interface);
    }
  }
  FacetList boundary, interface;

 private:
  void add(Dart face, FacetList& list) const {
    Index v[4];
    root_.vertices(face, v);
    list.corners.insert(list.corners.end(), v, v + list.corners_per_facet());
  }
  PeriodicTile::Region region(Dart facet) {
    copies_.clear();
    domain_.tree().to_child(domain_.tile(), facet, root_.dimension(), copies_);
    return domain_.region(tile_.facet(copies_.front()));
  }

  const PeriodicDomain& domain_;
  const Mesh& root_;
  const Mesh& tile_;
  DartBuffer star_, copies_;
};

FacetList facets_of(const Mesh& mesh) {
  FacetList list{mesh.dimension(), mesh.capacity(0), {}};
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f) {
    if (!mesh.is_live(mesh.dimension(), f)) continue;
    Index v[4];
    mesh.vertices(mesh.dart_of(mesh.dimension(), f), v);
    list.corners.insert(list.corners.end(), v, v + list.corners_per_facet());
  }
  return list;
}

long euler_of(const Mesh& mesh) {
  long sum = 0;
  for (int k = 0; k <= mesh.dimension(); ++k)
    for (Index s = 0; s < mesh.capacity(k); ++s)
      if (mesh.is_live(k, s) && mesh.dart_of(k, s) != no_dart) sum += k % 2 == 0 ? 1 : -1;
  return sum;
}

}  // namespace

TileTopology topology_of(const PeriodicDomain& domain) {
  const Mesh &root = domain.tree().mesh(NodeId::root), &tile = domain.tree().mesh(domain.tile());
  const FacesOfRoot faces(domain);
  TileTopology t;
  t.euler = euler_of(root);
  t.betti = betti_numbers(facets_of(root));
  t.surface_euler = euler_of(faces.boundary);
  t.interface_euler = euler_of(faces.interface);
  t.surface = betti_numbers(faces.boundary);
  t.interface = betti_numbers(faces.interface);
  const Vec3 normal = mean_normal(domain);
  for (Index f = 0; f < tile.capacity(tile.dimension()); ++f) {
    if (!tile.is_live(tile.dimension(), f)) continue;
    t.sizes[domain.region(f)] += signed_measure(domain, f, normal);
    t.inverted += orientation(domain, f, normal) <= 0;
  }
  t.mismatch = domain.mismatch();
  return t;
}

std::vector<std::string> differences(const TileTopology& before, const TileTopology& after, double sizes) {
  std::vector<std::string> found;
  const auto compare = [&](const char* what, auto was, auto is) {
    if (was == is) return;
    std::ostringstream text;
    text << what << ": " << was << ", now " << is;
    found.push_back(text.str());
  };
  compare("Euler characteristic of the glued tile", before.euler, after.euler);
  compare("its components", before.betti.components, after.betti.components);
  compare("its loops", before.betti.handles, after.betti.handles);
  compare("Euler characteristic of the surface", before.surface_euler, after.surface_euler);
  compare("components of the surface", before.surface.components, after.surface.components);
  compare("loops of the surface", before.surface.handles, after.surface.handles);
  compare("Euler characteristic of the interfaces", before.interface_euler, after.interface_euler);
  compare("components of the interfaces", before.interface.components, after.interface.components);
  if (after.inverted > before.inverted) compare("inverted facets", before.inverted, after.inverted);
  if (!(after.mismatch <= std::max(1e-14, before.mismatch)))
    compare("mismatch of copies", before.mismatch, after.mismatch);
  compare("regions", before.sizes.size(), after.sizes.size());
  for (const auto& [region, size] : before.sizes) {
    const auto now = after.sizes.find(region);
    if (now != after.sizes.end() && std::abs(now->second - size) > sizes * std::abs(size))
      compare(("size of region " + std::to_string(region)).c_str(), size, now->second);
  }
  return found;
}

}  // namespace multimesh
