// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/tile_topology.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "multimesh/pair_numbers.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh {

namespace {

/// The glued tile as lists. A vertex is that of its copies with the lowest number.
struct GluedLists {
  FacetList facets;
  std::vector<PeriodicTile::Region> regions;
  std::vector<Index> tile_corners;
  std::vector<PeriodicCopy> of_vertex;  // of the tile: from its lowest copy
  std::vector<std::size_t> copies;      // per vertex; 0 for those that are another one

  explicit GluedLists(const PeriodicDomain& domain) {
    PeriodicTile tile = domain.tile_lists();
    facets = std::move(tile.facets);
    regions = std::move(tile.regions);
    of_vertex.resize(tile.points.size());
    for (Index v = 0; v < of_vertex.size(); ++v) of_vertex[v] = {v, v, {}};
    for (const PeriodicCopy& c : domain.copies()) of_vertex[c.slave] = c;
    copies.assign(tile.points.size(), 0);
    for (const PeriodicCopy& c : of_vertex) ++copies[c.master];
    tile_corners = facets.corners;
    for (Index& v : facets.corners) v = of_vertex[v].master;
  }
  const LatticeVector& shift(std::size_t corner) const { return of_vertex[tile_corners[corner]].shift; }
};

/// Reads all simplices of the glued tile.
class Reader {
 public:
  Reader(const GluedLists& lists, TileTopology& out)
      : lists_(lists), facets_(lists.facets), n_(facets_.corners_per_facet()), out_(out) {
    boundary.dimension = interface.dimension = facets_.dimension - 1;
    boundary.vertices = interface.vertices = facets_.vertices;
  }
  FacetList boundary, interface;

  void run() {
    for (const std::size_t n : lists_.copies) {
      if (n >= out_.with_copies.size()) out_.with_copies.resize(n + 1);
      ++out_.with_copies[n];
    }
    out_.simplices[0] = facets_.vertices - out_.with_copies[0];
    out_.with_copies[0] = 0;
    out_.simplices[n_ - 1] = facets_.size();
    const auto read = [&](std::span<const Index> sides) { read_face(sides); };
    read_edges();
    if (n_ == 4)
      for_each_face(facets_, read);
    else
      for_each_edge(read);
  }

 private:
  /// Edges are counted by their ends. That is right, unless two with the same ends lead there by different
  /// lattice vectors.
  void read_edges() {
    PairNumbers edges(facets_.vertices, facets_.corners);
    edges.reserve(facets_.size() * 3 / 2);
    std::vector<LatticeVector> shift;  // from the lower end to the higher one
    for (std::size_t c = 0; c < facets_.corners.size(); ++c)
      for (std::size_t d = c - c % n_; d < c; ++d) {
        const bool is_up = facets_.corners[c] > facets_.corners[d];
        const std::size_t low = is_up ? d : c, high = is_up ? c : d;
        const Index e = edges(facets_.corners[low], facets_.corners[high]);
        const LatticeVector along = lists_.shift(high) - lists_.shift(low);
        if (e == shift.size()) shift.push_back(along);
        out_.improper += along != shift[e] || facets_.corners[low] == facets_.corners[high];
        if (n_ == 3) sides_.push_back({e, static_cast<Index>(3 * (c / 3) + 3 - c % 3 - d % 3)});
      }
    out_.simplices[1] = edges.size();
  }

  /// That of triangles, as for_each_face().
  template <class Visit>
  void for_each_edge(const Visit& visit) {
    std::ranges::sort(sides_);
    std::vector<Index> same;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      same.push_back(sides_[i][1]);
      if (i + 1 < sides_.size() && sides_[i + 1][0] == sides_[i][0]) continue;
      visit(std::span<const Index>(same));
      same.clear();
    }
  }

  /// A side is named by the corner of its facet that it does not have.
  void read_face(std::span<const Index> sides) {
    if (n_ == 4) ++out_.simplices[2];
    if (sides.size() == 1) add(sides[0], boundary);
    if (sides.size() == 2 && region(sides[0]) != region(sides[1])) add(sides[0], interface);
    const bool is_double = sides.size() == 2 && facets_.corners[sides[0]] == facets_.corners[sides[1]];
    out_.improper += sides.size() > 2 || is_double;
  }
  void add(Index side, FacetList& list) const {
    for (std::size_t c = side - side % n_; c < side - side % n_ + n_; ++c)
      if (c != side) list.corners.push_back(facets_.corners[c]);
  }
  PeriodicTile::Region region(Index side) const {
    return lists_.regions.empty() ? 0 : lists_.regions[side / n_];
  }

  const GluedLists& lists_;
  const FacetList& facets_;
  std::size_t n_;
  TileTopology& out_;
  std::vector<std::array<Index, 2>> sides_;  // of triangles: edge and side
};

long euler_of(const FacetList& faces) {
  PairNumbers edges(faces.vertices, faces.corners);
  std::vector<bool> used(faces.vertices, false);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto v = faces.facet(f);
    for (std::size_t j = 0; j < v.size(); ++j) {
      used[v[j]] = true;
      for (std::size_t i = 0; i < j; ++i) (void)edges(v[i], v[j]);
    }
  }
  const long n = std::count(used.begin(), used.end(), true) - static_cast<long>(edges.size());
  return faces.dimension == 2 ? n + static_cast<long>(faces.size()) : n;
}

}  // namespace

TileTopology topology_of(const PeriodicDomain& domain) {
  TileTopology t;
  const GluedLists lists(domain);
  Reader faces(lists, t);
  faces.run();
  for (std::size_t k = 0; k < 4; ++k) t.euler += (k % 2 == 0 ? 1 : -1) * static_cast<long>(t.simplices[k]);
  t.betti = betti_numbers(lists.facets);
  t.surface_euler = euler_of(faces.boundary);
  t.interface_euler = euler_of(faces.interface);
  t.surface = betti_numbers(faces.boundary);
  t.interface = betti_numbers(faces.interface);
  const Mesh& tile = domain.tree().mesh(domain.tile());
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
  if (after.improper > before.improper)
    compare("faults of the glued tile as a simplicial complex", before.improper, after.improper);
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
