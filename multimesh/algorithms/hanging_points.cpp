// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "multimesh/algorithms/tet_topology.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh {

namespace {

using Point = TetDomain::Point;

struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity, infinity}, high = -low;
  void add(const Point& p) {
    low = min(low, p);
    high = max(high, p);
  }
  bool has(const Point& p) const { return min(p, low) == low && max(p, high) == high; }
};

/// Points in halves of halves, for the questions which of them lie in a box.
class PointTree {
 public:
  PointTree(std::vector<Index> vertices, const std::vector<Point>& points)
      : points_(points), vertices_(std::move(vertices)) {
    arrange(0, vertices_.size(), 0);
  }
  template <class Visit>
  void visit_box(const Box& box, const Visit& visit) const {
    search(box, 0, vertices_.size(), 0, visit);
  }

 private:
  void arrange(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return vertices_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](Index v, Index w) { return points_[v][axis] < points_[w][axis]; });
    arrange(begin, middle, (axis + 1) % 3);
    arrange(middle + 1, end, (axis + 1) % 3);
  }
  template <class Visit>
  void search(const Box& box, std::size_t begin, std::size_t end, std::size_t axis,
              const Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Point& p = points_[vertices_[middle]];
    if (box.low[axis] <= p[axis]) search(box, begin, middle, (axis + 1) % 3, visit);
    if (box.has(p)) visit(vertices_[middle]);
    if (p[axis] <= box.high[axis]) search(box, middle + 1, end, (axis + 1) % 3, visit);
  }

  const std::vector<Point>& points_;
  std::vector<Index> vertices_;
};

/// Whether p lies in the segment or the triangle but not at a corner of it.
bool is_inside_edge(const Point& p, const Point& a, const Point& b, double tolerance) {
  const Point along = (b - a).normalized();
  const double at = dot(p - a, along);
  return at > tolerance && at < (b - a).norm() - tolerance && ((p - a) - at * along).norm() <= tolerance;
}

bool is_inside_face(const Point& p, const Point (&c)[3], double tolerance) {
  for (int i = 0; i < 3; ++i)
    if (is_inside_edge(p, c[i], c[(i + 1) % 3], tolerance)) return true;
  const Point normal = cross(c[1] - c[0], c[2] - c[0]).unit_or_zero();
  if (std::abs(dot(p - c[0], normal)) > tolerance) return false;
  for (int i = 0; i < 3; ++i)
    if (dot(cross(c[(i + 1) % 3] - c[i], p - c[i]), normal) <= 0) return false;
  return true;
}

}  // namespace

std::vector<Index> hanging_points(const TaggedTetrahedra& in) {
  const std::vector<Point> points(in.points.begin(), in.points.end());
  Box all;
  double largest = 0;
  for (const Point& p : points) {
    all.add(p);
    for (const double x : p) largest = std::max(largest, std::abs(x));
  }
  const double tolerance = 1e-12 * (all.high - all.low).norm() + 1e-15 * largest;
  std::vector<std::array<Index, 3>> faces;
  std::vector<bool> is_on(points.size(), false);
  const FacetList tets{3, static_cast<Index>(in.points.size()), in.tets.corners};
  for_each_face(tets, [&](std::span<const Index> sides) {
    if (sides.size() != 1) return;
    const auto vertex_of = [&](Index c) { return in.tets.corners[c]; };
    const auto c = side_corners(sides[0], vertex_of);
    faces.push_back({vertex_of(c[0]), vertex_of(c[1]), vertex_of(c[2])});
    for (const Index v : faces.back()) is_on[v] = true;
  });
  std::vector<Index> boundary;
  for (Index v = 0; v < is_on.size(); ++v)
    if (is_on[v]) boundary.push_back(v);
  const PointTree tree(boundary, points);
  std::vector<Index> hanging;
  for (const auto& f : faces) {
    const Point c[3] = {points[f[0]], points[f[1]], points[f[2]]};
    Box box;
    for (const Point& p : c) box.add(p);
    const Point margin{tolerance, tolerance, tolerance};
    box.low -= margin;
    box.high += margin;
    tree.visit_box(box, [&](Index v) {
      const bool at_corner =
          std::any_of(c, c + 3, [&](const Point& q) { return (points[v] - q).norm() <= tolerance; });
      if (!at_corner && is_inside_face(points[v], c, tolerance)) hanging.push_back(v);
    });
  }
  std::sort(hanging.begin(), hanging.end());
  hanging.erase(std::unique(hanging.begin(), hanging.end()), hanging.end());
  return hanging;
}

}  // namespace multimesh
