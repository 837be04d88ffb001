// SPDX-License-Identifier: BSD-3-Clause
#include "periodic_tile.hpp"

#include <cmath>
#include <numbers>

#include "multimesh/algorithms/decimate_domain.hpp"
#include "multimesh/algorithms/remesh_tile.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "svg.hpp"

namespace multimesh::figures {
namespace {

constexpr double pi = std::numbers::pi;

/// A unit square of n x n squares in wavy layers; columns, and vertices in them, are shaken.
PeriodicTile layers(Index n) {
  PeriodicTile tile;
  tile.facets = {2, (n + 1) * (n + 1), {}};
  const auto shake = [n](Index i, Index j) {
    return i % n == 0 ? 0.0 : 0.42 * std::sin(12.9 * i + 78.2 * (j % n)) / n;
  };
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) {
      const double x = static_cast<double>(i) / n + shake(i, j), y = static_cast<double>(j) / n;
      tile.points.push_back({x, y + 0.09 * std::sin(2 * pi * x) * std::pow(std::sin(pi * y), 2), 0});
    }
  const auto v = [n](Index i, Index j) { return i * (n + 1) + j; };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      for (const Index c : {v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j), v(i + 1, j + 1), v(i, j + 1)})
        tile.facets.corners.push_back(c);
      tile.regions.insert(tile.regions.end(), 2, j >= n / 3 && j < 2 * n / 3 ? 1 : 0);
    }
  return tile;
}

/// Two along each period.
void draw(Svg& svg, const PeriodicDomain& domain, Vec2 corner, double size, const std::string& name) {
  const PeriodicTile tile = domain.tile_lists();
  const Fit fit({{0, 0}, {2, 2}}, corner, {size, size});
  for (const Vec2& cell : {Vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const auto at = [&](Index v) { return fit(Vec2{tile.points[v][0], tile.points[v][1]} + cell); };
    for (std::size_t f = 0; f < tile.facets.size(); ++f) {
      const auto c = tile.facets.facet(f);
      svg.polygon({at(c[0]), at(c[1]), at(c[2])}, tile.regions[f] == 1 ? "#fdd0a2" : "#deebf7");
    }
    for (const PeriodicSide& side : domain.sides())
      for (const FacetList* edges : {&side.master, &side.slave})
        for (std::size_t e = 0; e < edges->size(); ++e) {
          const auto c = edges->facet(e);
          svg.line(at(c[0]), at(c[1]), side.shift[0] != 0 ? "#c00" : "#06c", 1.8);
        }
  }
  svg.text({corner[0] + size / 2, corner[1] + size + 16}, name);
}

}  // namespace

void periodic_tiles(const std::filesystem::path& directory) {
  const PeriodicTile tile = layers(9);
  PeriodicOptions options;
  options.interfaces = true;
  const PeriodicDomain before(tile, options);
  PeriodicDomain even(tile, options), coarse(tile, options);
  TileRemeshOptions remeshing;
  remeshing.length = 0.11;
  (void)remesh(even, remeshing);
  SurfaceDecimateOptions decimating;
  decimating.faces = tile.facets.size() / 3;
  decimating.max_aspect_ratio = 5;
  (void)decimate(coarse, TileSides::flat, decimating);
  Svg svg(640, 245, "A periodic tile, remeshed and decimated",
          "A square tile of two materials in wavy layers, repeated two by two: as it came in, with thin "
          "triangles; with even triangles; and with a third of them. The sides of all match.");
  draw(svg, before, {10, 10}, 200, "a tile, repeated");
  draw(svg, even, {220, 10}, 200, "remeshed");
  draw(svg, coarse, {430, 10}, 200, "decimated to a third");
  svg.write(directory / "tile.svg");
}

}  // namespace multimesh::figures
