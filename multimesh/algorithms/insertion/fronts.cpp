// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insertion/fronts.hpp"

#include "multimesh/error.hpp"

namespace multimesh::insertion {

void Front::add(Index from, Index to) {
  if (open_.erase(key(to, from)) > 0) return;
  open_.insert(key(from, to));
  waiting_.push_back({from, to});
}

bool Front::start(const Polygon& polygon) {
  waiting_.clear();
  open_.clear();
  for (const auto& [a, b] : polygon.boundary) {
    const std::vector<Index> chain = walk_.chain(a, b);
    if (chain.empty()) return false;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) add(chain[i], chain[i + 1]);
  }
  return true;
}

std::vector<Front::Face> Front::cover(const Polygon& polygon, Index number, bool may_split) {
  std::vector<Face> faces;
  if (!start(polygon)) return faces;
  while (!waiting_.empty()) {
    const Edge edge = waiting_.back();
    waiting_.pop_back();
    if (open_.erase(key(edge[0], edge[1])) == 0) continue;
    const auto [vertex, face] = find(polygon, number, edge, may_split);
    if (vertex == no_index) return {};
    faces.push_back({edge[0], edge[1], vertex});
    if (may_split) cells_.mark_face(face);
    add(edge[0], vertex);
    add(vertex, edge[1]);
  }
  return faces;
}

// Counter-clockwise around u-w, the inside of the polygon follows what is below its plane and precedes what
// is above.
Front::Found Front::find(const Polygon& polygon, Index number, const Edge& edge, bool may_split) {
  const tet::TetMesh& mesh = cells_.mesh();
  mesh.star(cells_.positive(cells_.find_edge(edge[0], edge[1])), 1, ring_);
  for (const Dart d : ring_) {
    const auto [u, w, x, y] = cells_.corners(d);
    const int below = cells_.side(number, polygon.plane, x);
    if (below > 0) continue;
    const int above = cells_.side(number, polygon.plane, y);
    if (below == 0 && above > 0) return {x, d};
    if (below < 0 && above == 0) return {y, mesh.reorder(d, permutation(0, 1, 3, 2))};
    if (below == 0 || above < 0) continue;
    if (!may_split) return {no_index, no_dart};
    const Index c = split(polygon, number, mesh.reorder(d, permutation(2, 3, 0, 1)));
    return {c, face_with(u, w, c)};
  }
  throw UsageError("insertion: the front of a polygon leaves the box");
}

Dart Front::face_with(Index u, Index w, Index c) {
  const tet::TetMesh& mesh = cells_.mesh();
  mesh.star(cells_.find_edge(u, w), 1, ring_);
  for (const Dart d : ring_) {
    const auto v = cells_.corners(d);
    if (v[2] == c) return d;
    if (v[3] == c) return mesh.reorder(d, permutation(0, 1, 3, 2));
  }
  throw UsageError("insertion: there is no face at a split edge");
}

// Any point of the plane near the crossing does, unless the edge is in a segment or another polygon.
Index Front::split(const Polygon& polygon, Index number, Dart crossing) {
  const auto [x, y, u, w] = cells_.corners(crossing);
  const auto& [p, q, r] = polygon.plane;
  exact::Point at =
      exact::crossing(cells_.point(x), cells_.point(y), cells_.point(p), cells_.point(q), cells_.point(r));
  ++counts_.planes;
  if (snap_ && !at.is_double() && !cells_.is_on_segment(crossing) && !cells_.is_beside_polygon(crossing)) {
    const auto [s, t] = exact::position_in_plane(at, cells_.point(p), cells_.point(q), cells_.point(r));
    const exact::Point near = exact::in_plane(cells_.point(p), cells_.point(q), cells_.point(r), s, t);
    if (cells_.may_split_edge(crossing, near)) {
      ++counts_.snapped;
      return cells_.split_edge(crossing, near, {number});
    }
  }
  const Index c = cells_.split_edge(crossing, at, cells_.common_planes(std::array{x, y}));
  cells_.add_plane(c, number);
  return c;
}

}  // namespace multimesh::insertion
