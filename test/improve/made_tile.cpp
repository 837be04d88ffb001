// SPDX-License-Identifier: BSD-3-Clause
#include "test/improve/made_tile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "multimesh/validate.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {

namespace {

std::array<double, 3> centre_of(const PeriodicTile& tile, std::size_t f) {
  std::array<double, 3> c{};
  const auto corners = tile.facets.facet(f);
  for (const Index v : corners)
    for (std::size_t i = 0; i < 3; ++i) c[i] += tile.points[v][i] / static_cast<double>(corners.size());
  return c;
}

}  // namespace

PeriodicOptions with_interfaces(bool x, bool y, bool z) {
  PeriodicOptions o = along(x, y, z);
  o.interfaces = true;
  return o;
}

void add_ball(PeriodicTile& tile, const std::array<double, 3>& centre, double radius) {
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto c = centre_of(tile, f);
    double squared = 0;
    for (std::size_t i = 0; i < 3; ++i) squared += std::pow(std::remainder(c[i] - centre[i], 1), 2);
    tile.regions.push_back(squared < radius * radius ? 2 : 1);
  }
}

void bend(PeriodicTile& tile) {
  const auto wave = [](double x) { return std::sin(2 * std::numbers::pi * x) / 40; };
  for (auto& p : tile.points) {
    const auto [x, y, z] = p;
    p = {x + wave(x) * std::cos(2 * std::numbers::pi * y), y + wave(y), z + wave(z)};
    for (double& c : p)  // exactly on the sides
      if (std::abs(c - std::round(c)) < 1e-12) c = std::round(c);
  }
}

void cut_hole(PeriodicTile& tile) {
  std::vector<Index> corners;
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    if (std::ranges::all_of(centre_of(tile, f), [](double x) { return x > 1. / 3 && x < 2. / 3; })) continue;
    const auto of_facet = tile.facets.facet(f);
    corners.insert(corners.end(), of_facet.begin(), of_facet.end());
  }
  tile.facets.corners = corners;
}

bool has_box(const PeriodicDomain& domain) {
  const PeriodicTile tile = domain.tile_lists();
  return std::ranges::all_of(domain.sides(), [&](const PeriodicSide& side) {
    for (std::size_t i = 0; i < 3; ++i)
      if (side.shift[i] != 0)
        for (const Index v : side.slave.corners)
          if (tile.points[v][i] != 1) return false;
    return true;
  });
}

std::string fault(const TileTopology& before, const PeriodicDomain& domain, double sizes) {
  if (!copies_fit(domain)) return "copies lie apart";
  if (inverted(domain) > 0) return "inverted";
  std::vector<std::string> faults = validate(domain.tree());
  if (faults.empty()) faults = differences(before, topology_of(domain), sizes);
  if (!faults.empty()) return faults.front();
  const PeriodicDomain again(domain.tile_lists(), domain.gluing());
  return again.report().euler == before.euler ? "" : "another topology when glued again";
}

}  // namespace multimesh::test
