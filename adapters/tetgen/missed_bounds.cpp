// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/missed_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "adapters/tetgen/surface_measure.hpp"

namespace multimesh::tetgen {

namespace {

using Edge = std::array<Index, 2>;

/// Rounding of TetGen's targets.
constexpr double slack = 1 + 1e-6;

Edge edge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

double length(const std::vector<Point>& p, const Edge& e) {
  return std::hypot(p[e[0]][0] - p[e[1]][0], p[e[0]][1] - p[e[1]][1], p[e[0]][2] - p[e[1]][2]);
}

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(4);
  (out << ... << parts);
  return out.str();
}

std::vector<Edge> edges_of(const TetrahedraList& mesh) {
  std::vector<Edge> edges;
  edges.reserve(6 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) edges.push_back(edge(mesh.tets.facet(t)[i], mesh.tets.facet(t)[j]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::string missed_length(const TetrahedraList& mesh, const FacetList& triangles,
                          const TetrahedralizeOptions& options) {
  std::set<Edge> on_surface;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      on_surface.insert(edge(triangles.facet(f)[k], triangles.facet(f)[(k + 1) % 3]));
  const std::vector<Edge> edges = edges_of(mesh);
  std::size_t longer = 0, surface = 0;
  double longest = 0;
  for (const Edge& e : edges) {
    const double l = length(mesh.points, e);
    if (l <= options.edge_length * slack) continue;
    ++longer;
    surface += on_surface.contains(e);
    longest = std::max(longest, l);
  }
  if (longer == 0) return {};
  return text("edge length ", options.edge_length, " missed: ", longer, " of ", edges.size(),
              " edges are longer, ", surface, " of them on the surface; the longest is ", longest, ", ",
              longest / options.edge_length, " times the length");
}

/// In radians, the smallest one of a tetrahedron.
double least_dihedral(std::span<const Point> points, const std::array<Index, 4>& c) {
  std::array<LongVector, 4> normals;
  for (std::size_t k = 0; k < 4; ++k)
    normals[k] =
        area_vector(points, {c[outward_faces[k][0]], c[outward_faces[k][1]], c[outward_faces[k][2]]});
  long double least = std::numbers::pi_v<long double>;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const long double size = std::sqrt(dot(normals[i], normals[i]) * dot(normals[j], normals[j]));
      const long double cosine = -dot(normals[i], normals[j]) / size;
      least = std::min(least, std::acos(std::clamp(cosine, -1.0L, 1.0L)));
    }
  return static_cast<double>(least);
}

/// Circumradius by shortest edge, by the formula of Crelle.
double radius_edge_ratio(const std::vector<Point>& p, const std::array<Index, 4>& c) {
  const auto l = [&](std::size_t i, std::size_t j) { return length(p, edge(c[i], c[j])); };
  const double x = l(0, 1) * l(2, 3), y = l(0, 2) * l(1, 3), z = l(0, 3) * l(1, 2), s = (x + y + z) / 2;
  const double area = std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z)));
  const double radius = area / (6 * static_cast<double>(volume_of(p, c)));
  return radius / std::min({l(0, 1), l(0, 2), l(0, 3), l(1, 2), l(1, 3), l(2, 3)});
}

/// How many tetrahedra miss a bound, and the worst value.
struct Missed {
  std::size_t count = 0;
  double worst = 0;

  void add(double value, double bound, bool is_upper) {
    if (is_upper ? value <= bound * slack : value * slack >= bound) return;
    worst = count == 0 ? value : is_upper ? std::max(worst, value) : std::min(worst, value);
    ++count;
  }
  void tell(const std::string& what, double bound, std::size_t all,
            std::vector<std::string>& sentences) const {
    if (count > 0)
      sentences.push_back(text(what, " ", bound, " missed: by ", count, " of ", all,
                               " tetrahedra, of which the worst has ", worst));
  }
};

}  // namespace

std::vector<std::string> missed_bounds(const TetrahedraList& mesh, const FacetList& surface,
                                       const TetrahedralizeOptions& options) {
  std::vector<std::string> sentences;
  if (options.edge_length > 0)
    if (std::string s = missed_length(mesh, surface, options); !s.empty()) sentences.push_back(std::move(s));
  Missed volume, ratio, angle;
  const double degrees = 180 / std::numbers::pi;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto f = mesh.tets.facet(t);
    const std::array<Index, 4> c{f[0], f[1], f[2], f[3]};
    if (options.max_volume > 0)
      volume.add(static_cast<double>(volume_of(mesh.points, c)), options.max_volume, true);
    if (options.radius_edge_ratio > 0)
      ratio.add(radius_edge_ratio(mesh.points, c), options.radius_edge_ratio, true);
    if (options.min_dihedral > 0)
      angle.add(least_dihedral(mesh.points, c) * degrees, options.min_dihedral, false);
  }
  volume.tell("volume", options.max_volume, mesh.tets.size(), sentences);
  ratio.tell("radius-edge ratio", options.radius_edge_ratio, mesh.tets.size(), sentences);
  angle.tell("dihedral angle", options.min_dihedral, mesh.tets.size(), sentences);
  return sentences;
}

}  // namespace multimesh::tetgen
