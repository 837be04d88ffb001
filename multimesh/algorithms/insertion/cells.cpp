// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insertion/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace multimesh::insertion {

Cells::Cells(const FacetList& tets, std::span<const std::array<double, 3>> points)
    : mesh_(tets),
      planes_(points.size()),
      segments_(mesh_.add_simplex_property<char>(1, "segments")),
      faces_(mesh_.add_simplex_property<char>(2, "faces")) {
  points_.reserve(points.size());
  for (const auto& p : points) points_.emplace_back(Vec3(p));
}

void Cells::add_plane(Index v, Index polygon) {
  auto& list = planes_[v];
  const auto at = std::ranges::lower_bound(list, polygon);
  if (at == list.end() || *at != polygon) list.insert(at, polygon);
}

int Cells::side(Index polygon, const std::array<Index, 3>& plane, Index v) const {
  if (std::ranges::binary_search(planes_[v], polygon)) return 0;
  return orientation(plane[0], plane[1], plane[2], v);
}

bool Cells::is_beside_polygon(Dart edge) const {
  mesh_.star(edge, 1, star_);
  return std::ranges::any_of(star_, [&](Dart d) {
    return is_in_polygon(d) || is_in_polygon(mesh_.reorder(d, permutation(0, 1, 3, 2)));
  });
}

Dart Cells::positive(Dart d) const {
  const Permutation p{static_cast<std::uint8_t>(code(d) & 31U)};
  return is_even(p) ? d : mesh_.reorder(d, permutation(0, 1, 3, 2));
}

std::array<Index, 4> Cells::corners(Dart d) const {
  std::array<Index, 4> v{};
  mesh_.vertices(d, v.data());
  return v;
}

Dart Cells::find_edge(Index a, Index b) const {
  mesh_.star(mesh_.dart_of(0, a), 0, star_);
  return find_edge(star_, b);
}

Dart Cells::find_edge(const DartBuffer& star, Index b) const {
  for (const Dart d : star) {
    const auto v = corners(d);
    if (v[1] == b) return d;
    if (v[2] == b) return mesh_.reorder(d, permutation(0, 2, 1, 3));
    if (v[3] == b) return mesh_.reorder(d, permutation(0, 3, 2, 1));
  }
  return no_dart;
}

bool Cells::may_split_edge(Dart edge, const exact::Point& at) const {
  mesh_.star(edge, 1, star_);
  return std::ranges::all_of(star_, [&](Dart d) {
    const auto [a, b, x, y] = corners(positive(d));
    return exact::orient3d(points_[a], at, points_[x], points_[y]) > 0 &&
           exact::orient3d(at, points_[b], points_[x], points_[y]) > 0;
  });
}

bool Cells::may_split_face(Dart face, const exact::Point& at) const {
  const auto beside = [&](Dart d) {
    const bool even = positive(d) == d;
    const auto [x, y, z, w] = corners(d);
    const auto positive_with = [&](const exact::Point& a, const exact::Point& b, const exact::Point& c) {
      return exact::orient3d(a, b, c, points_[w]) == (even ? 1 : -1);
    };
    return positive_with(at, points_[y], points_[z]) && positive_with(points_[x], at, points_[z]) &&
           positive_with(points_[x], points_[y], at);
  };
  const Dart beyond = mesh_.switch_dart(face, 3);
  return beside(face) && (beyond == no_dart || beside(beyond));
}

Index Cells::add_vertex(Index v, exact::Point at, std::vector<Index> planes) {
  if (v >= points_.size()) {
    points_.resize(v + 1, exact::Point(Vec3(0, 0, 0)));
    planes_.resize(v + 1);
  }
  points_[v] = std::move(at);
  planes_[v] = std::move(planes);
  return v;
}

Index Cells::split_edge(Dart edge, exact::Point at, std::vector<Index> planes) {
  mesh_.split_edge(edge, split_);
  mesh_.forget();
  return add_vertex(split_.vertex, std::move(at), std::move(planes));
}

Index Cells::split_face(Dart face, exact::Point at, std::vector<Index> planes) {
  const Dart made = mesh_.split_face(face);
  mesh_.forget();
  return add_vertex(mesh_.vertex(made), std::move(at), std::move(planes));
}

// A vertex in the face that goes to the far apex.
void Cells::swap_face(Dart face) {
  const Dart made = mesh_.split_face(face);
  mesh_.collapse_edge(mesh_.reorder(made, permutation(0, 3, 1, 2)), collapse_);
  mesh_.forget();
}

bool Cells::collapse(Index v, Index p) {
  const Dart edge = find_edge(v, p);
  mesh_.star(edge, 0, star_);
  const bool stay_positive = std::ranges::all_of(star_, [&](Dart d) {
    const auto [a, x, y, z] = corners(positive(d));
    return x == p || y == p || z == p || orientation(p, x, y, z) > 0;
  });
  if (!stay_positive || !mesh_.link_condition(edge)) return false;
  mesh_.collapse_edge(edge, collapse_);
  mesh_.forget();
  return true;
}

std::vector<Index> Cells::common_planes(std::span<const Index> vertices) const {
  std::vector<Index> common = planes_[vertices[0]], both;
  for (const Index v : vertices.subspan(1)) {
    both.clear();
    std::ranges::set_intersection(common, planes_[v], std::back_inserter(both));
    std::swap(common, both);
  }
  return common;
}

bool Cells::may_move(Index v, const exact::Point& to) const {
  mesh_.star(mesh_.dart_of(0, v), 0, star_);
  return std::ranges::all_of(star_, [&](Dart d) {
    const auto [a, x, y, z] = corners(positive(d));
    return exact::orient3d(to, points_[x], points_[y], points_[z]) > 0;
  });
}

namespace {

/// The doubles around p, `steps` units in the last place of its largest coordinate away; p first.
std::vector<Vec3> doubles_near(const Vec3& p, double steps) {
  if (steps == 0) return {p};
  double largest = 0;
  for (const double x : p) largest = std::max(largest, std::abs(x));
  const double unit = steps * largest * std::numeric_limits<double>::epsilon();
  std::vector<Vec3> near;
  for (const double x : {0.0, -unit, unit})
    for (const double y : {0.0, -unit, unit})
      for (const double z : {0.0, -unit, unit}) near.push_back(p + Vec3(x, y, z));
  return near;
}

}  // namespace

bool Cells::round(Index v, double steps) {
  for (const Vec3& p : doubles_near(points_[v].nearest(), steps))
    if (const exact::Point to(p); may_move(v, to)) {
      points_[v] = to;
      return true;
    }
  return false;
}

// Between tetrahedra that are thinner than the distance of doubles there may be no room.
bool Cells::round_with_a_neighbour(Index v, Index first) {
  std::vector<Index> neighbours;
  mesh_.star(mesh_.dart_of(0, v), 0, star_);
  for (const Dart d : star_)
    for (const Index n : corners(d))
      if (n != v && n >= first) neighbours.push_back(n);
  std::ranges::sort(neighbours);
  const auto repeated = std::ranges::unique(neighbours);
  neighbours.erase(repeated.begin(), repeated.end());
  for (const Index n : neighbours) {
    const exact::Point before = points_[n];
    for (const double steps : {8, 512})
      for (const Vec3& p : doubles_near(before.nearest(), steps)) {
        if (!may_move(n, p)) continue;
        points_[n] = exact::Point(p);
        if (round(v, 0) || round(v, 8) || round(v, 64)) return true;
        points_[n] = before;
      }
  }
  return false;
}

// One that is rounded makes room for its neighbours.
std::size_t Cells::round(Index first) {
  std::vector<Index> left;
  for (Index v = 0; v < points_.size(); ++v)
    if (mesh_.is_live(0, v) && !points_[v].is_double()) left.push_back(v);
  for (const double steps : {0, 1, 8, 64, 512})
    for (std::size_t gone = 1; gone > 0 && !left.empty();)
      gone = std::erase_if(left, [&](Index v) { return round(v, steps); });
  constexpr std::size_t few = 32;  // more of them lie together, and have no room
  if (left.size() <= few) std::erase_if(left, [&](Index v) { return round_with_a_neighbour(v, first); });
  return left.size();
}

std::size_t Cells::exact_points() const {
  std::size_t n = 0;
  for (Index v = 0; v < points_.size(); ++v) n += mesh_.is_live(0, v) && !points_[v].is_double();
  return n;
}

}  // namespace multimesh::insertion
