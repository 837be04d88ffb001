// SPDX-License-Identifier: BSD-3-Clause
#include "test/insertion/check.hpp"

#include <algorithm>
#include <set>

#include "adapters/exact/fractions.hpp"
#include "multimesh/tetgen/delaunay.hpp"

namespace multimesh::test {

using exact::Rational;
using exact::RationalPoint;

BackgroundMesh background_of(const TriangleSoup& soup, double grid_spacing) {
  std::vector<tetgen::Point> points;
  for (const Vec3& p : soup.points) points.push_back(p);
  auto made = tetgen::delaunay(points, {.grid_spacing = grid_spacing});
  return {std::move(made.points), std::move(made.tets), std::move(made.merged_to)};
}

namespace {

RationalPoint sum(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

Rational six_volume(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                    const RationalPoint& d) {
  return dot(cross(b - a, c - a), d - a);
}

/// Twice its area, as a vector.
RationalPoint area(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return cross(b - a, c - a);
}

class Check {
 public:
  Check(const TriangleSoup& soup, const BackgroundMesh& background, const Arrangement& arrangement)
      : soup_(soup), background_(background), arrangement_(arrangement) {
    for (const exact::Point& p : arrangement.points) points_.push_back(rational(p));
  }

  std::vector<std::string> run() {
    tets();
    polygons();
    return std::move(faults_);
  }

 private:
  void tets() {
    Rational volume, box;
    for (std::size_t t = 0; t < arrangement_.tets.size(); ++t) {
      const auto v = arrangement_.tets.facet(t);
      const Rational here = six_volume(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]);
      if (here <= 0) faults_.push_back("tetrahedron " + std::to_string(t) + " is not positive");
      volume += here;
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<Index, 3> face{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]};
        std::ranges::sort(face);
        faces_.insert(face);
      }
    }
    for (std::size_t t = 0; t < background_.tets.size(); ++t) {
      const auto v = background_.tets.facet(t);
      const auto at = [&](std::size_t i) { return exact::rational(Vec3(background_.points[v[i]])); };
      box += six_volume(at(0), at(1), at(2), at(3));
    }
    if (volume != box) faults_.emplace_back("the volumes are not those of the box");
  }

  void polygons() {
    std::vector<RationalPoint> covered(arrangement_.triangles.size());
    for (std::size_t f = 0; f < arrangement_.faces.size(); ++f) {
      const auto v = arrangement_.faces.facet(f);
      std::array<Index, 3> key{v[0], v[1], v[2]};
      std::ranges::sort(key);
      if (!faces_.contains(key)) faults_.push_back("face " + std::to_string(f) + " is none");
      for (std::size_t i = arrangement_.begin[f]; i < arrangement_.begin[f + 1]; ++i) {
        const auto [polygon, reversed] = arrangement_.covers[i];
        const auto w = reversed ? std::array{v[0], v[2], v[1]} : std::array{v[0], v[1], v[2]};
        covered[polygon] = sum(covered[polygon], area(points_[w[0]], points_[w[1]], points_[w[2]]));
        plane(polygon, w);
      }
    }
    std::vector<int> times(soup_.triangles.size(), 0);
    for (std::size_t p = 0; p < arrangement_.triangles.size(); ++p) {
      RationalPoint wanted;
      for (const Index t : arrangement_.triangles[p]) {
        const auto v = soup_.triangles.facet(t);
        wanted = sum(wanted, area(at(v[0]), at(v[1]), at(v[2])));
        ++times[t];
      }
      if (wanted != covered[p]) faults_.push_back("polygon " + std::to_string(p) + " is not covered");
    }
    for (std::size_t t = 0; t < times.size(); ++t) {
      const auto v = soup_.triangles.facet(t);
      const RationalPoint none;
      const bool is_flat = area(at(v[0]), at(v[1]), at(v[2])) == none;
      if (times[t] != (is_flat ? 0 : 1)) faults_.push_back("triangle " + std::to_string(t) + " is lost");
    }
  }

  /// Whether a face turns as the polygon, and lies in its plane.
  void plane(Index polygon, const std::array<Index, 3>& face) {
    const auto v = soup_.triangles.facet(arrangement_.triangles[polygon].front());
    const RationalPoint normal = area(at(v[0]), at(v[1]), at(v[2]));
    for (const Index x : face)
      if (dot(normal, points_[x] - at(v[0])) != 0)
        faults_.push_back("a face of polygon " + std::to_string(polygon) + " leaves its plane");
    if (dot(normal, area(points_[face[0]], points_[face[1]], points_[face[2]])) <= 0)
      faults_.push_back("a face of polygon " + std::to_string(polygon) + " is turned");
  }

  RationalPoint at(Index v) const { return exact::rational(soup_.points[v]); }

  const TriangleSoup& soup_;
  const BackgroundMesh& background_;
  const Arrangement& arrangement_;
  std::vector<RationalPoint> points_;
  std::set<std::array<Index, 3>> faces_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults(const TriangleSoup& soup, const BackgroundMesh& background,
                                const Arrangement& arrangement) {
  return Check(soup, background, arrangement).run();
}

}  // namespace multimesh::test
