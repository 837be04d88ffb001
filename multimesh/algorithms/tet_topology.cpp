// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/tet_topology.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "multimesh/algorithms/betti_numbers.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/pair_numbers.hpp"
#include "multimesh/tet_sides.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

using Point = TetDomain::Point;

Point point(const TaggedTetrahedra& t, Index v) {
  return {t.points[v][0], t.points[v][1], t.points[v][2]};
}

std::size_t count_sets(UnionFind& sets, const std::vector<bool>& used) {
  std::size_t n = 0;
  for (Index i = 0; i < used.size(); ++i) n += used[i] && sets.find(i) == i;
  return n;
}

std::size_t count(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

/// Every face once: what its sides tell.
class Faces {
 public:
  Faces(const TaggedTetrahedra& in, const FacetList& tets, TetTopology& out)
      : in_(in),
        tets_(tets),
        out_(out),
        parts_(tets.size()),
        rims_(tets.vertices),
        on_rim_(tets.vertices, false),
        rim_edges_(tets.vertices) {}

  void read() {
    for_each_face(tets_, [&](std::span<const Index> sides) { read_face(sides); });
    out_.face_components = count_sets(parts_, std::vector<bool>(tets_.size(), true));
    out_.boundary_components = count_sets(rims_, on_rim_);
    out_.pinched_edges = static_cast<std::size_t>(
        std::count_if(rim_faces_.begin(), rim_faces_.end(), [](std::uint32_t n) { return n != 2; }));
    out_.boundary_euler_characteristic = static_cast<long>(count(on_rim_)) -
                                         static_cast<long>(rim_edges_.size()) +
                                         static_cast<long>(out_.boundary_faces);
  }

 private:
  void read_face(std::span<const Index> sides) {
    ++out_.faces;
    for (const Index s : sides) parts_.join(sides[0] / 4, s / 4);
    out_.crowded_faces += sides.size() > 2;
    if (sides.size() == 1) read_boundary_face(sides[0]);
  }

  void read_boundary_face(Index side) {
    const auto vertex_of = [&](Index corner) { return tets_.corners[corner]; };
    const auto c = side_corners(side, vertex_of);
    const Index v[3] = {vertex_of(c[0]), vertex_of(c[1]), vertex_of(c[2])};
    ++out_.boundary_faces;
    out_.boundary_area +=
        cross(point(in_, v[1]) - point(in_, v[0]), point(in_, v[2]) - point(in_, v[0])).norm() / 2;
    for (int i = 0; i < 3; ++i) {
      on_rim_[v[i]] = true;
      rims_.join(v[0], v[i]);
      const Index e = rim_edges_(v[i], v[(i + 1) % 3]);
      if (e == rim_faces_.size()) rim_faces_.push_back(0);
      ++rim_faces_[e];
    }
  }

  const TaggedTetrahedra& in_;
  const FacetList& tets_;
  TetTopology& out_;
  UnionFind parts_, rims_;
  std::vector<bool> on_rim_;
  PairNumbers rim_edges_;
  std::vector<std::uint32_t> rim_faces_;  // by edge of the boundary
};

void count_low_simplices(const TaggedTetrahedra& t, TetTopology& out) {
  std::vector<bool> used(t.points.size(), false);
  PairNumbers edges(t.points.size(), t.tets.corners);
  for (std::size_t i = 0; i < t.tets.size(); ++i) {
    const auto v = t.tets.facet(i);
    for (const Index w : v) used[w] = true;
    for (const auto& [a, b] : edge_corners) edges(v[a], v[b]);
  }
  out.vertices = count(used);
  out.edges = edges.size();
}

/// Collects sentences about numbers that differ.
class Differences {
 public:
  template <class Number>
  void compare(const char* what, Number before, Number after, Number tolerance = 0) {
    if (std::abs(before - after) <= tolerance) return;
    std::ostringstream text;
    text.precision(10);
    text << what << ": " << before << " before, " << after << " after";
    list.push_back(text.str());
  }
  void compare_counts(const char* what, std::size_t before, std::size_t after) {
    compare(what, static_cast<long>(before), static_cast<long>(after));
  }
  std::vector<std::string> list;
};

}  // namespace

TetTopology topology_of(const TaggedTetrahedra& in) {
  TetTopology t;
  t.tets = in.tets.size();
  const FacetList tets{3, static_cast<Index>(in.points.size()), in.tets.corners};
  count_low_simplices(in, t);
  Faces(in, tets, t).read();
  const BettiNumbers betti = betti_numbers(tets);
  t.components = betti.components;
  t.handles = static_cast<long>(betti.handles);
  t.euler_characteristic = static_cast<long>(t.vertices) - static_cast<long>(t.edges) +
                           static_cast<long>(t.faces) - static_cast<long>(t.tets);
  t.cavities = t.euler_characteristic - static_cast<long>(t.components) + t.handles;
  for (std::size_t i = 0; i < in.tets.size(); ++i) {
    const auto v = in.tets.facet(i);
    t.volumes[in.regions.empty() ? 0 : in.regions[i]] +=
        six_volume(point(in, v[0]), point(in, v[1]), point(in, v[2]), point(in, v[3])) / 6;
  }
  return t;
}

std::vector<std::string> differences(const TetTopology& a, const TetTopology& b, double rounding) {
  Differences d;
  d.compare_counts("connected components", a.components, b.components);
  d.compare_counts("components connected through faces", a.face_components, b.face_components);
  d.compare("Euler characteristic", a.euler_characteristic, b.euler_characteristic);
  d.compare("handles", a.handles, b.handles);
  d.compare("cavities", a.cavities, b.cavities);
  d.compare_counts("faces with three or more tetrahedra", a.crowded_faces, b.crowded_faces);
  d.compare_counts("edges at which the boundary is pinched", a.pinched_edges, b.pinched_edges);
  d.compare_counts("components of the boundary", a.boundary_components, b.boundary_components);
  d.compare("Euler characteristic of the boundary", a.boundary_euler_characteristic,
            b.boundary_euler_characteristic);
  // Displacing the points of a surface by `rounding` changes its area by at most about that times the lengths
  // of its edges, and the volume below it by that times its area.
  const double faces = static_cast<double>(std::max(a.boundary_faces, b.boundary_faces));
  const double area = std::max(a.boundary_area, b.boundary_area);
  d.compare("area of the boundary", a.boundary_area, b.boundary_area,
            1e-9 * area + 10 * rounding * std::sqrt(faces * area));
  double total = 0;
  for (const auto& [tag, volume] : a.volumes) total += std::abs(volume);
  std::map<TetDomain::Tag, double> volumes = b.volumes;
  for (const auto& [tag, volume] : a.volumes) volumes.try_emplace(tag, 0);
  for (const auto& [tag, volume] : volumes) {
    const auto before = a.volumes.find(tag);
    d.compare(("volume of region " + std::to_string(tag)).c_str(),
              before == a.volumes.end() ? 0.0 : before->second, volume, 1e-9 * total + 10 * rounding * area);
  }
  return d.list;
}

}  // namespace multimesh
