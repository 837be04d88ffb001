// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/subdivide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "multimesh/column.hpp"
#include "multimesh/strata.hpp"

namespace multimesh {

namespace {

/// One mesh with coordinates, the surface or a chart below it: the rules for its vertices, from the original
/// neighbours.
class Rules {
 public:
  Rules(const EmbeddedMesh& surface, Coordinates& at, Strata& strata, Subdivision scheme)
      : tree_(surface.tree()),
        surface_(surface.node()),
        mesh_(tree_.mesh(at.node())),
        at_(at),
        strata_(strata),
        scheme_(scheme) {}

  NodeId node() const { return at_.node(); }
  const Mesh& mesh() const { return mesh_; }
  /// Of the new vertex on the edge of (a, b, ..).
  Vec3 edge_point(Dart e);
  /// Of an old vertex.
  Vec3 vertex_point(Dart v);
  Vec3 at(Index v) const { return at_.at(v); }
  void set(Index v, const Vec3& x) { at_.set(v, x); }

 private:
  Vec3 at(Dart d) const { return at_.at(mesh_.vertex(d)); }
  Vec3 other_end(Dart d) const { return at(mesh_.reorder(d, exchange_ends)); }
  Dart on_surface(Dart d) const { return tree_.to_ancestor(node(), d, surface_); }
  bool is_line(Dart e) { return !strata_.is_plain(on_surface(e)); }

  const MultiMesh& tree_;
  NodeId surface_;
  const Mesh& mesh_;
  Coordinates& at_;
  Strata& strata_;
  Subdivision scheme_;
  DartBuffer edges_;
};

Vec3 Rules::edge_point(Dart e) {
  const Vec3 middle = (at(e) + other_end(e)) / 2;
  if (scheme_ == Subdivision::midpoint || is_line(e)) return middle;
  const Dart beyond = mesh_.switch_dart(e, 2);
  const Vec3 left = at(mesh_.reorder(e, permutation(2, 0, 1))),
             right = at(mesh_.reorder(beyond, permutation(2, 0, 1)));
  return middle * 0.75 + (left + right) / 8;
}

Vec3 Rules::vertex_point(Dart v) {
  const Vec3 here = at(v);
  if (scheme_ == Subdivision::midpoint) return here;
  const Freedom freedom = strata_.freedom(on_surface(v));
  if (freedom == Freedom::none) return here;
  edges_around(mesh_, v, edges_);
  Vec3 sum(0, 0, 0);
  std::size_t n = 0;
  for (const Dart e : edges_) {
    if (freedom == Freedom::line && !is_line(e)) continue;
    sum += other_end(e);
    ++n;
  }
  if (freedom == Freedom::line) return n == 2 ? here * 0.75 + sum / 8 : here;
  const double k = static_cast<double>(n), c = 3 + 2 * std::cos(2 * std::numbers::pi / k);
  const double alpha = (40 - c * c) / 64;
  return here * (1 - alpha) + sum * (alpha / k);
}

class Subdivider {
 public:
  Subdivider(EmbeddedMesh& surface, Subdivision scheme)
      : operations_(surface.operations()),
        tree_(surface.tree()),
        node_(surface.node()),
        mesh_(surface.mesh()),
        strata_(tree_, node_),
        source_(mesh_.capacity(2)),
        source_column_(node_, 2, source_) {
    rules_.emplace_back(surface, surface.positions(), strata_, scheme);
    for (Coordinates* c : surface.charts()) rules_.emplace_back(surface, *c, strata_, scheme);
    operations_.add(source_column_);
  }
  SubdivideResult run();

 private:
  struct Point {
    std::size_t rules;
    Index a, b;  ///< the edge's ends, or twice the vertex
    Vec3 at;
  };
  struct Edge {
    Index edge, a, b;         ///< of the surface, before
    std::size_t first, last;  ///< the points of all its copies
  };
  std::array<Index, 2> ends(const Mesh& mesh, Dart e) const {
    return {mesh.vertex(e), mesh.vertex(mesh.reorder(e, exchange_ends))};
  }
  void split_tets_with_several_faces();
  void plan_edges();
  void plan_vertices();
  void split(const Edge& edge);
  void swap_edges();
  void move(const Point& p);
  bool move(const Point& p, const Vec3& to);

  Propagation& operations_;
  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  Strata strata_;
  std::vector<Index> source_;  // per triangle: the original of which it is part
  Column<Index> source_column_;
  std::vector<Rules> rules_;
  std::vector<Edge> edges_;
  std::vector<Point> edge_points_, vertex_points_, new_points_;
  Copies copies_;
  SubdivideResult result_;
};

SubdivideResult Subdivider::run() {
  Transaction step = operations_.transaction();
  split_tets_with_several_faces();
  source_.resize(mesh_.capacity(2));
  for (Index f = 0; f < source_.size(); ++f) source_[f] = f;
  plan_edges();
  plan_vertices();
  for (const Edge& e : edges_) split(e);
  swap_edges();
  for (const auto* points : {&vertex_points_, &new_points_})
    for (const Point& p : *points) move(p);
  step.commit();
  return result_;
}

// A face can be divided if the tetrahedra beside it have no other face on the surface.
void Subdivider::split_tets_with_several_faces() {
  NodeId n = node_;
  while (n != NodeId::root && tree_.mesh(n).dimension() < 3) n = tree_.parent(n);
  const Mesh& mesh = tree_.mesh(n);
  if (mesh.dimension() < 3) return;
  const auto corners = [&](Dart d) {
    std::array<Index, 4> v{};
    mesh.vertices(d, v.data());
    std::ranges::sort(v);
    return v;
  };
  std::vector<std::array<Index, 4>> tets;  // by vertices: the split one's neighbours change indices
  DartBuffer star;
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    mesh.star(tree_.to_ancestor(node_, mesh_.dart_of(2, f), n), 2, star);
    for (const Dart d : star) tets.push_back(corners(d));
  }
  std::ranges::sort(tets);
  for (std::size_t i = 1; i < tets.size(); ++i) {
    if (tets[i] != tets[i - 1] || (i > 1 && tets[i] == tets[i - 2])) continue;
    mesh.star(mesh.dart_of(0, tets[i][0]), 0, star);
    const auto tet = std::ranges::find_if(star, [&](Dart d) { return corners(d) == tets[i]; });
    if (tet != star.end()) result_.split_tets += bool(operations_.split_simplex(n, *tet, 3));
  }
}

// Handles all copies of an edge in the surface at once, at the first one.
void Subdivider::plan_edges() {
  std::vector<bool> planned(mesh_.capacity(1), false);
  for (Index e = 0; e < planned.size(); ++e) {
    if (!mesh_.is_live(1, e) || planned[e]) continue;
    const auto [a, b] = ends(mesh_, mesh_.dart_of(1, e));
    edges_.push_back({e, a, b, edge_points_.size(), 0});
    copies_.collect(tree_, node_, mesh_.dart_of(1, e), 1);
    for (std::size_t r = 0; r < rules_.size(); ++r)
      for (const Copy& c : copies_.of(rules_[r].node())) {
        const auto [p, q] = ends(rules_[r].mesh(), c.dart);
        edge_points_.push_back({r, p, q, rules_[r].edge_point(c.dart)});
        if (r == 0) planned[mesh_.simplex(c.dart, 1)] = true;
      }
    edges_.back().last = edge_points_.size();
  }
}

void Subdivider::plan_vertices() {
  for (std::size_t r = 0; r < rules_.size(); ++r) {
    const Mesh& mesh = rules_[r].mesh();
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart)
        vertex_points_.push_back({r, v, v, rules_[r].vertex_point(mesh.dart_of(0, v))});
  }
}

// An edge that is not split yet has the ends that it had: by them its copies are known again.
void Subdivider::split(const Edge& edge) {
  const Dart e = mesh_.dart_of(1, edge.edge);
  copies_.collect(tree_, node_, e, 1);
  std::vector<std::array<Index, 2>> before;
  for (const Copy& c : copies_.all()) before.push_back(ends(tree_.mesh(c.node), c.dart));
  if (!operations_.split(node_, e)) {
    ++result_.refused_splits;
    return;
  }
  ++result_.splits;
  const Copies& after = operations_.copies();
  for (std::size_t c = 0; c < after.size(); ++c)
    for (std::size_t p = edge.first; p < edge.last; ++p) {
      const Point& point = edge_points_[p];
      const Rules& rules = rules_[point.rules];
      if (rules.node() != after[c].node ||
          std::minmax(point.a, point.b) != std::minmax(before[c][0], before[c][1]))
        continue;
      const Index v = rules.mesh().vertex(rules.mesh().reorder(after[c].dart, exchange_ends));
      new_points_.push_back({point.rules, v, v, point.at});
    }
}

void Subdivider::swap_edges() {
  std::vector<bool> is_new(mesh_.capacity(0), false);
  for (const Point& p : new_points_)
    if (p.rules == 0) is_new[p.a] = true;
  for (Index e = 0; e < mesh_.capacity(1); ++e) {
    if (!mesh_.is_live(1, e)) continue;
    const Dart d = mesh_.dart_of(1, e), beyond = mesh_.switch_dart(d, 2);
    if (beyond == no_dart || source_[mesh_.facet(d)] != source_[mesh_.facet(beyond)]) continue;
    const auto [a, b] = ends(mesh_, d);
    if (a >= is_new.size() || b >= is_new.size() || is_new[a] == is_new[b]) continue;
    ++(operations_.swap(node_, d) ? result_.swaps : result_.refused_swaps);
  }
}

// As far as the rest of the tree allows.
void Subdivider::move(const Point& p) {
  const Vec3 here = rules_[p.rules].at(p.a);
  if (p.at == here || move(p, p.at)) return;
  for (const double share : {0.5, 0.25, 0.125})
    if (move(p, here + (p.at - here) * share)) {
      ++result_.shortened_moves;
      return;
    }
  ++result_.refused_moves;
}

// By a relocation, so that values that follow coordinates (those of corners) are updated.
bool Subdivider::move(const Point& p, const Vec3& to) {
  const Rules& rules = rules_[p.rules];
  const Outcome o = operations_.relocate(rules.node(), rules.mesh().dart_of(0, p.a),
                                         [&](const Event&) { rules_[p.rules].set(p.a, to); });
  result_.moves += bool(o);
  return bool(o);
}

}  // namespace

SubdivideResult subdivide(const Embedding& embedding, NodeId surface, const SubdivideOptions& options) {
  if (embedding.tree().mesh(surface).dimension() != 2)
    throw UsageError("subdivide: the mesh must be a surface");
  EmbeddedMesh mesh(embedding, surface);
  return Subdivider(mesh, options.scheme).run();
}

}  // namespace multimesh
