// SPDX-License-Identifier: BSD-3-Clause
#include "test/algorithms/made_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace multimesh::test {

namespace {

constexpr Index side = 20;  // squares of a planar grid

constexpr AffineMap plain{{{{0.04, 0.01, 0, 0}, {-0.005, 0.03, 0, 0}}}};
constexpr AffineMap shifted{{{{0.03, 0, 0, 2}, {0, 0.05, 0, 1}}}};
constexpr AffineMap mirrored{{{{-0.03, 0.01, 0, 4}, {0, 0.05, 0, 1}}}};
constexpr AffineMap point{{{{0, 0, 0, 3}, {0, 0, 0, 3}}}};

std::size_t half(const Vec3& p) {
  return p[0] < side / 2.0 ? 0 : 1;
}

Vec3 vec(const Point& p) {
  return {p[0], p[1], p[2]};
}

Vec3 centroid(const TexturedTriangles& s, std::size_t t) {
  Vec3 sum(0, 0, 0);
  for (const auto& c : s.triangles[t]) sum += s.positions[static_cast<std::size_t>(c.position)];
  return sum / 3.0;
}

/// Joins `other` on; its vertices that lie on one of ours in space become that one.
void append(Shape& shape, const Shape& other) {
  std::vector<Index> number;
  for (const Point& p : other.points) {
    const auto found = std::find(shape.points.begin(), shape.points.end(), p);
    number.push_back(static_cast<Index>(found - shape.points.begin()));
    if (found == shape.points.end()) shape.points.push_back(p);
  }
  for (const Index v : other.facets.corners) shape.facets.corners.push_back(number[v]);
  shape.facets.vertices = static_cast<Index>(shape.points.size());
}

template <class F>
Shape moved(Shape shape, const F& f) {
  for (Point& p : shape.points) p = f(p);
  return shape;
}

std::size_t octant(const Vec3& p) {
  return (p[0] < 0 ? 1U : 0U) + (p[1] < 0 ? 2U : 0U) + (p[2] < 0 ? 4U : 0U);
}

// The projection along z mirrors the lower octants; the projections along the others' signs do not.
std::vector<AffineMap> octant_maps() {
  std::vector<AffineMap> maps;
  for (int i = 0; i < 8; ++i) {
    const double mirror = i % 2 ? -1 : 1;
    maps.push_back({{{{mirror * 0.1, 0.02, 0, 0.5 * i}, {0, 0.1, 0.03, 0.25 * (i / 2)}}}});
  }
  return maps;
}

}  // namespace

Vec2 AffineMap::operator()(const Vec3& p) const {
  const auto at = [&](const std::array<double, 4>& r) {
    return r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3];
  };
  return {at(rows[0]), at(rows[1])};
}

TexturedTriangles bare(const Shape& shape) {
  TexturedTriangles s;
  for (const Point& p : shape.points) s.positions.push_back(vec(p));
  for (std::size_t f = 0; f < shape.facets.size(); ++f) {
    const auto v = shape.facets.facet(f);
    std::array<TexturedTriangles::Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i].position = static_cast<std::int32_t>(v[i]);
    s.triangles.push_back(corners);
  }
  return s;
}

void add_texture(TexturedTriangles& surface, const Unwrap& unwrap) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (auto& c : surface.triangles[t]) {
      c.texcoord = static_cast<std::int32_t>(surface.texcoords.size());
      surface.texcoords.push_back(unwrap(t, surface.positions[static_cast<std::size_t>(c.position)]));
    }
}

MadeSurface with_charts(std::string name, const Shape& shape,
                        const std::function<std::size_t(const Vec3& centroid)>& chart,
                        std::vector<AffineMap> maps) {
  MadeSurface m{std::move(name), bare(shape), {}, std::move(maps)};
  for (std::size_t t = 0; t < m.input.triangles.size(); ++t) m.chart.push_back(chart(centroid(m.input, t)));
  add_texture(m.input, [&](std::size_t t, const Vec3& p) {
    return m.chart[t] == no_texture ? Vec2(0, 0) : m.maps[m.chart[t]](p);
  });
  for (std::size_t t = 0; t < m.chart.size(); ++t)
    if (m.chart[t] == no_texture)
      for (auto& c : m.input.triangles[t]) c.texcoord = -1;
  return m;
}

MadeSurface one_chart() {
  return with_charts("OneChart", grid(side, side), [](const Vec3&) { return 0; }, {plain});
}
MadeSurface two_charts() {
  return with_charts("TwoCharts", grid(side, side), half, {plain, shifted});
}
MadeSurface mirrored_chart() {
  return with_charts("MirroredChart", grid(side, side), half, {plain, mirrored});
}
MadeSurface zero_area_chart() {
  return with_charts("ZeroAreaChart", grid(side, side), half, {plain, point});
}

MadeSurface half_without() {
  const auto chart = [](const Vec3& p) { return half(p) == 0 ? 0 : no_texture; };
  return with_charts("HalfWithoutTexture", grid(side, side), chart, {plain});
}

MadeSurface touching_charts() {
  const auto quadrant = [](const Vec3& p) {
    return (p[0] < side / 2.0) == (p[1] < side / 2.0) ? 0U : p[0] < p[1] ? 1U : 2U;
  };
  const AffineMap far{{{{0.03, 0, 0, 7}, {0, 0.05, 0, 3}}}};
  return with_charts("TouchingCharts", grid(side, side), quadrant, {plain, shifted, far});
}

MadeSurface slit() {
  MadeSurface m{"Slit", bare(grid(side, side)), {}, {}};
  m.chart.assign(m.input.triangles.size(), 0);
  const double middle = side / 2.0;
  std::vector<bool> right;
  for (std::size_t t = 0; t < m.chart.size(); ++t) right.push_back(centroid(m.input, t)[0] > middle);
  add_texture(m.input, [&](std::size_t t, const Vec3& p) {
    return Vec2(p[0] + (right[t] ? 0.3 * std::max(0.0, p[1] - middle) : 0), p[1]);
  });
  return m;
}

MadeSurface polar_annulus() {
  MadeSurface m{"PolarAnnulus", bare(annulus(48, 8)), {}, {}};
  m.chart.assign(m.input.triangles.size(), 0);
  add_texture(m.input, [&](std::size_t t, const Vec3& p) {
    const Vec3 c = centroid(m.input, t);
    double turn = std::atan2(p[1], p[0]) / (2 * std::numbers::pi);
    const double around = std::atan2(c[1], c[0]) / (2 * std::numbers::pi);
    if (turn < around - 0.5) turn += 1;
    if (turn > around + 0.5) turn -= 1;
    return Vec2(turn, std::hypot(p[0], p[1]) / 4);
  });
  return m;
}

MadeSurface tiled_torus() {
  const Index n = 24;
  const Tile tile = tile_of_torus(n, n);
  MadeSurface m{"TiledTorus", bare(torus(n, n)), {}, {}};
  m.chart.assign(m.input.triangles.size(), 0);
  for (const Point& p : tile.grid.points) m.input.texcoords.push_back({p[0] / n, p[1] / n});
  for (std::size_t t = 0; t < m.input.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      m.input.triangles[t][i].position = static_cast<std::int32_t>(tile.over.facet(t)[i]);
      m.input.triangles[t][i].texcoord = static_cast<std::int32_t>(tile.grid.facets.facet(t)[i]);
    }
  return m;
}

MadeSurface octahedron() {
  const Shape flat = moved(sphere(4), [](const Point& p) {
    const double sum = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    return Point{p[0] / sum, p[1] / sum, p[2] / sum};
  });
  return with_charts("Octahedron", flat, octant, octant_maps());
}

MadeSurface sphere_with_charts() {
  MadeSurface m = octahedron();
  m.name = "SphereWithCharts";
  m.maps.clear();
  for (Vec3& p : m.input.positions) p = p.normalized();
  return m;
}

MadeSurface book() {
  const Shape page = grid(side / 2, side);
  Shape s = page;
  append(s, moved(page, [](const Point& p) { return Point{-p[0], p[1], 0}; }));
  append(s, moved(page, [](const Point& p) { return Point{0, p[1], p[0]}; }));
  const AffineMap upright{{{{0, 0.01, 0.04, 5}, {0, 0.03, -0.005, 2}}}};
  const auto chart = [](const Vec3& p) { return p[2] > 0 ? 2U : p[0] < 0 ? 1U : 0U; };
  return with_charts("Book", s, chart, {plain, shifted, upright});
}

MadeSurface pinched() {
  Shape s = grid(side / 2, side / 2);
  append(s, moved(s, [](const Point& p) { return Point{-p[0], -p[1], 0}; }));
  return with_charts("Pinched", s, [](const Vec3& p) { return p[0] < 0 ? 1U : 0U; }, {plain, shifted});
}

MadeSurface self_touching() {
  MadeSurface m{"SelfTouching", bare(grid(side, side)), {}, {}};
  m.chart.assign(m.input.triangles.size(), 0);
  add_texture(m.input, [](std::size_t, const Vec3& p) { return Vec2(p[0], p[1]) / side; });
  const std::int32_t here = 7, there = 13;  // both on the boundary x = 0
  for (auto& t : m.input.triangles)
    for (auto& c : t)
      if (c.position == there) c.position = here;
  m.input.positions[here] = Vec3(0, side / 2.0, 1);
  return m;
}

MadeSurface half_reversed() {
  MadeSurface m = two_charts();
  m.name = "HalfReversed";
  for (std::size_t t = 0; t < m.chart.size(); ++t)
    if (centroid(m.input, t)[1] > side / 2.0) std::swap(m.input.triangles[t][0], m.input.triangles[t][1]);
  return m;
}

std::vector<MadeSurface> made_surfaces() {
  return {one_chart(),          two_charts(), mirrored_chart(), half_without(),  zero_area_chart(),
          touching_charts(),    slit(),       polar_annulus(),  tiled_torus(),   octahedron(),
          sphere_with_charts(), book(),       pinched(),        self_touching(), half_reversed()};
}

}  // namespace multimesh::test
