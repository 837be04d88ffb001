// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insertion/segments.hpp"

#include <algorithm>

#include "multimesh/error.hpp"

namespace multimesh::insertion {

// In the tetrahedron (v,x,y,z) that is entered, b is on the inner side of all three faces at v, or on them.
SegmentWalk::Way SegmentWalk::find_way(Index v, Index a, Index b) const {
  const tet::TetMesh& mesh = cells_.mesh();
  mesh.star(mesh.dart_of(0, v), 0, star_);
  if (const Dart direct = cells_.find_edge(star_, b); direct != no_dart) return {Meets::vertex, direct};
  for (const Dart s : star_) {
    const Dart d = cells_.positive(s);
    const auto [at, x, y, z] = cells_.corners(d);
    const int to_x = cells_.orientation(a, b, y, z);
    if (to_x < 0) continue;
    const int to_y = cells_.orientation(a, b, z, x);
    if (to_y < 0) continue;
    const int to_z = cells_.orientation(a, b, x, y);
    if (to_z < 0) continue;
    if (to_x > 0 && to_y > 0 && to_z > 0) return {Meets::face, d};
    if (to_y == 0 && to_z == 0) return {Meets::vertex, d};
    if (to_x == 0 && to_z == 0) return {Meets::vertex, mesh.reorder(d, permutation(0, 2, 1, 3))};
    if (to_x == 0 && to_y == 0) return {Meets::vertex, mesh.reorder(d, permutation(0, 3, 2, 1))};
    if (to_x == 0) return {Meets::edge, mesh.reorder(d, permutation(0, 2, 3, 1))};
    if (to_y == 0) return {Meets::edge, mesh.reorder(d, permutation(0, 1, 3, 2))};
    return {Meets::edge, d};
  }
  throw UsageError("insertion: a segment leaves the box");
}

void SegmentWalk::insert(Index a, Index b, std::span<const Index> beside) {
  for (Index v = a; v != b;) {
    const Way way = find_way(v, a, b);
    Index next = no_index;
    switch (way.what) {
      case Meets::vertex:
        next = cells_.corners(way.dart)[1];
        break;
      case Meets::edge:
        next = meet_edge(way, a, b, beside);
        break;
      case Meets::face:
        next = meet_face(way, a, b, beside);
        break;
    }
    cells_.mark_segment(cells_.find_edge(v, next));
    for (const Index polygon : beside) cells_.add_plane(next, polygon);
    v = next;
  }
}

std::vector<Index> SegmentWalk::chain(Index a, Index b) const {
  std::vector<Index> found{a};
  while (found.back() != b) {
    const Way way = find_way(found.back(), a, b);
    if (way.what != Meets::vertex) return {};
    found.push_back(cells_.corners(way.dart)[1]);
  }
  return found;
}

// A point of the segment near the crossing, with few digits, does as well, unless the edge is part of another
// segment.
Index SegmentWalk::meet_edge(const Way& way, Index a, Index b, std::span<const Index> beside) {
  const tet::TetMesh& mesh = cells_.mesh();
  const auto [v, y, z, x] = cells_.corners(way.dart);
  const Dart edge = mesh.reorder(way.dart, permutation(1, 2, 0, 3));
  exact::Point at =
      exact::crossing(cells_.point(y), cells_.point(z), cells_.point(a), cells_.point(b), cells_.point(x));
  ++counts_.edges;
  if (snap_ && !at.is_double() && !cells_.is_on_segment(edge)) {
    const double t = exact::position_on_segment(at, cells_.point(a), cells_.point(b));
    const exact::Point near = exact::on_segment(cells_.point(a), cells_.point(b), t);
    if (cells_.may_split_edge(edge, near)) {
      ++counts_.snapped;
      return cells_.split_edge(edge, near, {beside.begin(), beside.end()});
    }
  }
  return cells_.split_edge(edge, at, cells_.common_planes(std::array{y, z}));
}

// Two planes through the line, to which v does not belong.
bool SegmentWalk::is_on_line(Index v, Index a, Index b, Index x, Index y) const {
  return cells_.orientation(a, b, x, v) == 0 && cells_.orientation(a, b, y, v) == 0;
}

Index SegmentWalk::meet_face(const Way& way, Index a, Index b, std::span<const Index> beside) {
  const tet::TetMesh& mesh = cells_.mesh();
  const auto [v, x, y, z] = cells_.corners(way.dart);
  const Dart face = mesh.reorder(way.dart, permutation(1, 2, 3, 0));
  if (const Dart beyond = mesh.switch_dart(face, 3); beyond != no_dart) {
    const Index far = cells_.corners(beyond)[3];
    if (far == b || is_on_line(far, a, b, x, y)) {
      ++counts_.swaps;
      cells_.swap_face(face);
      return far;
    }
  }
  exact::Point at =
      exact::crossing(cells_.point(a), cells_.point(b), cells_.point(x), cells_.point(y), cells_.point(z));
  ++counts_.faces;
  if (snap_ && !at.is_double()) {
    const double t = exact::position_on_segment(at, cells_.point(a), cells_.point(b));
    const exact::Point near = exact::on_segment(cells_.point(a), cells_.point(b), t);
    if (cells_.may_split_face(face, near)) {
      ++counts_.snapped;
      return cells_.split_face(face, near, {beside.begin(), beside.end()});
    }
  }
  return cells_.split_face(face, at, cells_.common_planes(std::array{x, y, z}));
}

}  // namespace multimesh::insertion
