// SPDX-License-Identifier: BSD-3-Clause
#include "test/improve/flat_list_check.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace multimesh::test {

namespace {

using P = std::array<double, 3>;

P minus(const P& a, const P& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const P& a, const P& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
P cross(const P& a, const P& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const P& a) {
  return std::sqrt(dot(a, a));
}

struct Groups {
  explicit Groups(std::size_t n) : of(n) { std::iota(of.begin(), of.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) const {
    while (of[i] != i) i = of[i];
    return i;
  }
  void merge(std::size_t i, std::size_t j) { of[root(i)] = root(j); }
  long count() const {
    long n = 0;
    for (std::size_t i = 0; i < of.size(); ++i) n += of[i] == i;
    return n;
  }
  std::vector<std::size_t> of;
};

bool hangs(const P& p, const P& a, const P& b, const P& c) {
  constexpr double eps = 1e-11;
  const P n = cross(minus(b, a), minus(c, a));
  const double area = norm(n);
  if (std::abs(dot(minus(p, a), n)) > eps * area) return false;
  const double u = dot(cross(minus(b, p), minus(c, p)), n) / (area * area);
  const double v = dot(cross(minus(c, p), minus(a, p)), n) / (area * area);
  const double w = 1 - u - v;
  return u > -eps && v > -eps && w > -eps && u < 1 - eps && v < 1 - eps && w < 1 - eps;
}

}  // namespace

FlatListFacts facts_of(const TaggedTetrahedra& list) {
  FlatListFacts facts;
  std::map<P, int> number;
  std::vector<P> points;
  std::vector<std::array<int, 4>> tets;
  for (std::size_t t = 0; t < list.tets.corners.size() / 4; ++t) {
    auto& tet = tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const P p = list.points[list.tets.corners[4 * t + i]];
      const auto [known, is_new] = number.try_emplace(p, static_cast<int>(points.size()));
      if (is_new) points.push_back(p);
      tet[i] = known->second;
    }
    const P a = points[static_cast<std::size_t>(tet[0])];
    const auto from_a = [&](std::size_t i) { return minus(points[static_cast<std::size_t>(tet[i])], a); };
    facts.volumes[list.regions.empty() ? 0 : list.regions[t]] +=
        dot(cross(from_a(1), from_a(2)), from_a(3)) / 6;
  }
  std::set<std::set<int>> edges;
  std::map<std::set<int>, std::vector<std::size_t>> faces;
  Groups by_points(points.size()), by_faces(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      std::set<int> face(tets[t].begin(), tets[t].end());
      face.erase(tets[t][i]);
      faces[face].push_back(t);
      for (std::size_t j = 0; j < i; ++j) edges.insert({tets[t][i], tets[t][j]});
      by_points.merge(static_cast<std::size_t>(tets[t][i]), static_cast<std::size_t>(tets[t][0]));
    }
  std::map<std::set<int>, int> rim_edges;
  std::set<int> rim_points;
  std::vector<std::array<int, 3>> rim;
  for (const auto& [face, around] : faces) {
    for (const std::size_t t : around) by_faces.merge(t, around.front());
    facts.crowded_faces += around.size() > 2;
    if (around.size() != 1) continue;
    const std::vector<int> v(face.begin(), face.end());
    rim.push_back({v[0], v[1], v[2]});
    for (std::size_t i = 0; i < 3; ++i) {
      ++rim_edges[{v[i], v[(i + 1) % 3]}];
      rim_points.insert(v[i]);
    }
  }
  const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
  for (const auto& f : rim) {
    facts.boundary_area += norm(cross(minus(at(f[1]), at(f[0])), minus(at(f[2]), at(f[0])))) / 2;
    for (const int p : rim_points)
      if (p != f[0] && p != f[1] && p != f[2]) facts.hanging += hangs(at(p), at(f[0]), at(f[1]), at(f[2]));
  }
  for (const auto& [edge, n] : rim_edges) facts.pinched_edges += n != 2;
  const auto size = [](const auto& list_of) { return static_cast<long>(list_of.size()); };
  facts.components = by_points.count();
  facts.face_components = by_faces.count();
  facts.euler = size(points) - size(edges) + size(faces) - size(tets);
  facts.boundary_euler = size(rim_points) - size(rim_edges) + size(rim);
  return facts;
}

std::string compare(const FlatListFacts& a, const FlatListFacts& b, double relative) {
  std::ostringstream text;
  const auto same = [&](const char* what, auto before, auto after, double tolerance) {
    if (std::abs(static_cast<double>(before - after)) > tolerance)
      text << what << ' ' << before << " -> " << after << "; ";
  };
  same("components", a.components, b.components, 0);
  same("face components", a.face_components, b.face_components, 0);
  same("euler", a.euler, b.euler, 0);
  same("boundary euler", a.boundary_euler, b.boundary_euler, 0);
  same("pinched edges", a.pinched_edges, b.pinched_edges, 0);
  same("crowded faces", a.crowded_faces, b.crowded_faces, 0);
  same("hanging", a.hanging, b.hanging, 0);
  same("boundary area", a.boundary_area, b.boundary_area, relative * a.boundary_area);
  if (a.volumes.size() != b.volumes.size()) text << "other regions; ";
  for (const auto& [region, volume] : a.volumes)
    same("volume", volume, b.volumes.contains(region) ? b.volumes.at(region) : 0, relative * volume);
  return text.str();
}

}  // namespace multimesh::test
