// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "adapters/io/polygon_clipper.hpp"

namespace multimesh::io {
namespace {

using Point3 = std::array<double, 3>;
using Corner = PolygonSoup::Corner;

Point3 minus(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Triangulator {
 public:
  explicit Triangulator(const PolygonSoup& soup) : soup_(soup) {}

  TriangleSoup run() {
    const std::size_t count = soup_.corners.size() - 2 * soup_.face_count();
    result_.triangles.reserve(count);
    result_.polygon.reserve(count);
    for (polygon_ = 0; polygon_ < soup_.face_count(); ++polygon_) cut(soup_.face(polygon_));
    return std::move(result_);
  }

 private:
  void cut(std::span<const Corner> face) {
    if (face.size() == 3) return add(face[0], face[1], face[2]);
    if (face.size() == 4) return quad(face);
    ears(face);
  }

  void add(const Corner& a, const Corner& b, const Corner& c) {
    result_.triangles.push_back({a, b, c});
    result_.polygon.push_back(static_cast<std::uint32_t>(polygon_));
  }

  /// The value of the two triangles at the diagonal from corner i; more is better.
  std::tuple<bool, bool, double> diagonal_value(std::span<const Corner> quad, std::size_t i,
                                                const Point3& normal) const {
    const Corner &a = quad[i], &b = quad[i + 1], &c = quad[i + 2], &d = quad[(i + 3) % 4];
    const bool proper = a.v != c.v;
    const double first = dot(normal, cross(minus(at(b), at(a)), minus(at(c), at(a))));
    const double second = dot(normal, cross(minus(at(c), at(a)), minus(at(d), at(a))));
    const double least = std::min(first, second);
    const Point3 diagonal = minus(at(c), at(a));
    return {proper, least > 0, least > 0 ? -dot(diagonal, diagonal) : least};
  }

  void quad(std::span<const Corner> f) {
    const Point3 normal = cross(minus(at(f[2]), at(f[0])), minus(at(f[3]), at(f[1])));
    if (diagonal_value(f, 0, normal) >= diagonal_value(f, 1, normal)) {
      add(f[0], f[1], f[2]);
      add(f[0], f[2], f[3]);
    } else {
      add(f[1], f[2], f[3]);
      add(f[1], f[3], f[0]);
    }
  }

  void ears(std::span<const Corner> face) {
    names_.clear();
    for (const Corner& c : face) names_.push_back(c.v);
    project(face);
    for (const auto& [a, b, c] : clipper_.clip(points_, names_)) add(face[a], face[b], face[c]);
  }

  /// The polygon in the plane of its vector area, seen from the side where it runs counter-clockwise.
  void project(std::span<const Corner> face) {
    const Point3 origin = at(face[0]);
    Point3 normal{};
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Point3 n = cross(minus(at(face[i]), origin), minus(at(face[i + 1]), origin));
      for (std::size_t k = 0; k < 3; ++k) normal[k] += n[k];
    }
    const auto [u, w] = plane_axes(normal);
    points_.clear();
    for (const Corner& c : face) {
      const Point3 d = minus(at(c), origin);
      points_.push_back({dot(u, d), dot(w, d)});
    }
  }

  /// Two unit vectors that are orthogonal to n and to each other, with u × w along n. Any two if n is 0.
  static std::array<Point3, 2> plane_axes(Point3 n) {
    const double length = std::sqrt(dot(n, n));
    if (!(length > 0))
      n = {0, 0, 1};
    else
      for (double& x : n) x /= length;
    const bool along_x = std::abs(n[0]) > 0.6;
    Point3 u = cross(along_x ? Point3{0, 1, 0} : Point3{1, 0, 0}, n);
    const double scale = 1 / std::sqrt(dot(u, u));
    for (double& x : u) x *= scale;
    return {u, cross(n, u)};
  }

  const Point3& at(const Corner& c) const { return soup_.positions[static_cast<std::size_t>(c.v)]; }

  const PolygonSoup& soup_;
  TriangleSoup result_;
  std::size_t polygon_ = 0;
  PolygonClipper clipper_;
  std::vector<Point2> points_;
  std::vector<std::int32_t> names_;
};

}  // namespace

TriangleSoup triangulate(const PolygonSoup& soup) {
  return Triangulator(soup).run();
}

}  // namespace multimesh::io
