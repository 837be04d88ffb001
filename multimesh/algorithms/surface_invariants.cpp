// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/surface_invariants.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "multimesh/algorithms/bounding_box.hpp"

namespace multimesh {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;

void CopiesStayApart::collect_labelled_neighbours(const Mesh& mesh, Dart vertex, std::vector<Index>& out) {
  out.clear();
  mesh.star(vertex, 0, star_);
  for (const Dart d : star_) {
    std::array<Index, 4> v{};
    mesh.vertices(d, v.data());
    for (const Index x : {v[1], v[2]})
      if (mesh.is_locked(x) && std::find(out.begin(), out.end(), x) == out.end()) out.push_back(x);
  }
}

bool CopiesStayApart::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  Dart stays = event.copies[0].dart, goes = mesh.reorder(stays, exchange_ends);
  if (!mesh.is_locked(mesh.vertex(stays))) std::swap(stays, goes);
  collect_labelled_neighbours(mesh, stays, kept_);
  collect_labelled_neighbours(mesh, goes, gained_);
  const Index merged = mesh.vertex(stays);
  std::erase_if(gained_, [&](Index x) {
    return x == merged || std::find(kept_.begin(), kept_.end(), x) != kept_.end();
  });
  if (mesh.is_locked(merged)) {
    if (!gained_.empty()) return false;  // an edge of two copies: another sheet may have it
    mesh.star(goes, 0, around_);         // a vertex that has an edge with another copy of the merged one
    for (const Dart d : around_)
      for (const Permutation neighbour : {exchange_ends, permutation(2, 0, 1)}) {
        const Dart at = mesh.reorder(d, neighbour);
        if (mesh.vertex(at) == merged) continue;
        collect_labelled_neighbours(mesh, at, other_);
        for (const Index x : other_)
          if (x != merged && source_[x] == source_[merged]) return false;
      }
    return true;
  }
  return std::none_of(gained_.begin(), gained_.end(), [&](Index x) {
    return std::any_of(kept_.begin(), kept_.end(), [&](Index y) { return source_[x] == source_[y]; });
  });
}

NormalTurn::NormalTurn(const std::vector<Vec3d>& positions, double max_turn)
    : Invariant("normal turn"), positions_(positions), min_cosine_(std::cos(max_turn)) {}

bool NormalTurn::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  const Dart a = event.copies[0].dart, b = mesh.reorder(a, exchange_ends);
  const Vec3d merged = positions_[mesh.vertex(a)] * (1 - event.t) + positions_[mesh.vertex(b)] * event.t;
  return keeps_normals(mesh, a, mesh.vertex(b), merged) &&
         (event.t >= 1 || keeps_normals(mesh, b, mesh.vertex(a), merged));
}

// The triangles around one end, without those over the edge, when that end moves.
bool NormalTurn::keeps_normals(const Mesh& mesh, Dart end, Index other, const Vec3d& moved) {
  mesh.star(end, 0, star_);
  for (const Dart d : star_) {
    std::array<Index, 4> v{};
    mesh.vertices(d, v.data());
    if (v[1] == other || v[2] == other) continue;
    const Vec3d &p = positions_[v[0]], &q = positions_[v[1]], &r = positions_[v[2]];
    const Vec3d before = cross(q - p, r - p), after = cross(q - moved, r - moved);
    const double had = before.sqrnorm(), has = after.sqrnorm();
    if (!(had > 0)) continue;
    const double turned = dot(before, after);
    const double longest = std::max((q - moved).sqrnorm(), (r - moved).sqrnorm());
    if (has <= 1e-20 * longest * longest) return false;
    if (turned < min_cosine_ * std::sqrt(had * has)) return false;
  }
  return true;
}

namespace {

/// Doubled area that counts as none, relative to the squared diagonal of the bounding box.
constexpr double relative_no_area = 1e-11;

double doubled_area(const std::array<Vec2d, 3>& t) {
  const Vec2d u = t[1] - t[0], v = t[2] - t[0];
  return u[0] * v[1] - u[1] * v[0];
}

}  // namespace

TextureOrientation::TextureOrientation(const MultiMesh& tree, NodeId texture,
                                       const std::vector<Vec2d>& texcoords)
    : Invariant("texture orientation", texture), texture_(texture), texcoords_(texcoords) {
  const double diagonal = bounding_box_diagonal(texcoords);
  no_area_ = relative_no_area * diagonal * diagonal;
  orient_charts(tree.mesh(texture));
}

void TextureOrientation::orient_charts(const Mesh& mesh) {
  chart_of_.assign(mesh.capacity(2), no_index);
  std::vector<Index> chart;
  std::vector<Vec2d> points;
  for (Index start = 0; start < mesh.capacity(2); ++start) {
    if (chart_of_[start] != no_index || !mesh.is_live(2, start)) continue;
    const auto id = static_cast<Index>(charts_.size());
    chart_of_[start] = id;
    chart.assign(1, start);
    points.clear();
    double total = 0;
    for (std::size_t i = 0; i < chart.size(); ++i) {
      Dart d = mesh.dart_of(2, chart[i]);
      std::array<Index, 4> v{};
      mesh.vertices(d, v.data());
      total += doubled_area({texcoords_[v[0]], texcoords_[v[1]], texcoords_[v[2]]});
      for (std::size_t j = 0; j < 3; ++j) points.push_back(texcoords_[v[j]]);
      for (int side = 0; side < 3; ++side, d = mesh.reorder(d, edge_bx)) {
        const Dart across = mesh.switch_dart(d, 2);
        if (across == no_dart || chart_of_[mesh.facet(across)] != no_index) continue;
        chart_of_[mesh.facet(across)] = id;
        chart.push_back(mesh.facet(across));
      }
    }
    const double diagonal = bounding_box_diagonal(points);
    charts_.push_back({static_cast<signed char>(total > 0   ? 1
                                                : total < 0 ? -1
                                                            : 0),
                       relative_no_area * diagonal * diagonal});
  }
}

int TextureOrientation::sign(double area, Index facet) const {
  const double none = charts_[chart_of_[facet]].no_area;
  return area > none ? 1 : area < -none ? -1 : 0;
}

bool TextureOrientation::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(texture_);
  for (const Copy& c : event.copies.of(texture_)) {
    const Dart a = c.dart, b = mesh.reorder(a, exchange_ends);
    const Vec2d merged = texcoords_[mesh.vertex(a)] * (1 - event.t) + texcoords_[mesh.vertex(b)] * event.t;
    if (!keeps_signs(mesh, a, mesh.vertex(b), merged)) return false;
    if (event.t < 1 && !keeps_signs(mesh, b, mesh.vertex(a), merged)) return false;
  }
  return true;
}

bool TextureOrientation::keeps_signs(const Mesh& mesh, Dart end, Index other, const Vec2d& moved) {
  mesh.star(end, 0, star_);
  // All darts of a star go round their facets as the facet's own dart does, or all against it: the sign of
  // the area is taken in the same sense before and after, and the chart's in that of dart_of.
  for (const Dart d : star_) {
    std::array<Index, 4> v{};
    mesh.vertices(d, v.data());
    if (v[1] == other || v[2] == other) continue;
    const Index facet = mesh.facet(d);
    const double before = doubled_area({texcoords_[v[0]], texcoords_[v[1]], texcoords_[v[2]]});
    const double after = doubled_area({moved, texcoords_[v[1]], texcoords_[v[2]]});
    const int had = sign(before, facet), has = sign(after, facet);
    if (has != had && has != charts_[chart_of_[facet]].sign) return false;
    if (std::abs(before) > no_area_ && std::abs(after) <= no_area_) return false;
  }
  return true;
}

// The texture coordinates that a vertex of the texture will have.
Vec2d SeamsStayOpen::merged(const Event& event, Index vertex) const {
  const Mesh& mesh = event.tree.mesh(texture_);
  for (const Copy& c : event.copies.of(texture_)) {
    const Index a = mesh.vertex(c.dart), b = mesh.vertex(mesh.reorder(c.dart, exchange_ends));
    if (vertex == a || vertex == b) return texcoords_[a] * (1 - event.t) + texcoords_[b] * event.t;
  }
  return texcoords_[vertex];
}

bool SeamsStayOpen::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& texture = event.tree.mesh(texture_);
  const Mesh& root = event.tree.mesh(NodeId::root);
  const Dart a = event.copies[0].dart;
  bool seam_at_a = false, seam_at_b = false;
  for (const Copy& c : event.copies.of(texture_)) {
    seam_at_a |= texture.is_boundary(c.dart, 0);
    seam_at_b |= texture.is_boundary(texture.reorder(c.dart, exchange_ends), 0);
  }
  return (!seam_at_a || open_around(event, a)) &&
         (!seam_at_b || event.t >= 1 || open_around(event, root.reorder(a, exchange_ends)));
}

bool SeamsStayOpen::open_around(const Event& event, Dart end) const {
  const Mesh& root = event.tree.mesh(NodeId::root);
  const Mesh& texture = event.tree.mesh(texture_);
  const Index edge = root.simplex(event.copies[0].dart, 1);
  root.star(end, 0, star_);
  for (const Dart d : star_) {
    if (root.simplex(d, 1) == edge) continue;
    sides_.clear();
    event.tree.to_child(texture_, d, 1, sides_);
    if (sides_.size() != 2) continue;
    const auto near_end = [&](Dart side) { return merged(event, texture.vertex(side)); };
    const auto far_end = [&](Dart side) {
      return texcoords_[texture.vertex(texture.reorder(side, exchange_ends))];
    };
    if (far_end(sides_[0]) == far_end(sides_[1]) && near_end(sides_[0]) == near_end(sides_[1])) return false;
  }
  return true;
}

}  // namespace multimesh
