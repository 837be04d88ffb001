// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/subdivide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "adapters/openmesh/root_surface.hpp"
#include "adapters/openmesh/temporary_property.hpp"
#include "multimesh/tree_strata.hpp"

namespace multimesh {

namespace {

/// One mesh with coordinates: the rules for its vertices, by its neighbours before anything is done.
class Rules {
 public:
  Rules(const MultiMesh& tree, Coordinates& at, TreeStrata& strata, Subdivision scheme)
      : tree_(tree), mesh_(tree.mesh(at.node())), at_(at), strata_(strata), scheme_(scheme) {}

  NodeId node() const { return at_.node(); }
  /// Of the new vertex on the edge of (a, b, ..).
  Vec3 edge_point(Dart e);
  /// Of an old vertex.
  Vec3 vertex_point(Dart v);
  void set(Index v, const Vec3& x) { at_.set(v, x); }

 private:
  Vec3 at(Dart d) const { return at_.at(mesh_.vertex(d)); }
  Vec3 other_end(Dart d) const { return at(mesh_.reorder(d, exchange_ends)); }
  bool is_line(Dart e) { return !strata_.is_plain(tree_.to_root(node(), e)); }

  const MultiMesh& tree_;
  const Mesh& mesh_;
  Coordinates& at_;
  TreeStrata& strata_;
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
  const Freedom freedom = strata_.freedom(tree_.to_root(node(), v));
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
  Subdivider(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
             Subdivision scheme)
      : operations_(operations), tree_(operations.tree()), root_(tree_.mesh(NodeId::root)), strata_(tree_) {
    rules_.emplace_back(tree_, positions, strata_, scheme);
    for (Coordinates* c : below) rules_.emplace_back(tree_, *c, strata_, scheme);
  }
  /// `source`: a property of the root's faces.
  void run(std::vector<Index>& source);

 private:
  struct Point {
    std::size_t rules;
    Index a, b;  ///< the edge's ends, or twice the old vertex
    Vec3 at;
  };
  void plan_edges();
  void plan_vertices();
  void split_edges();
  void swap_edges(const std::vector<Index>& source);
  void move(const Point& p);

  Propagation& operations_;
  const MultiMesh& tree_;
  const Mesh& root_;
  TreeStrata strata_;
  std::vector<Rules> rules_;
  std::vector<Index> edges_;        // of the root, before
  std::vector<std::size_t> begin_;  // per edge, its first point
  std::vector<Point> edge_points_, vertex_points_;
  std::vector<Point> new_points_;  // by new vertex
};

void Subdivider::plan_edges() {
  DartBuffer copies;
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    edges_.push_back(e);
    begin_.push_back(edge_points_.size());
    for (std::size_t r = 0; r < rules_.size(); ++r) {
      copies.clear();
      if (r == 0)
        copies.push_back(root_.dart_of(1, e));
      else
        tree_.to_descendant(NodeId::root, root_.dart_of(1, e), 1, rules_[r].node(), copies);
      const Mesh& mesh = tree_.mesh(rules_[r].node());
      for (const Dart d : copies)
        edge_points_.push_back(
            {r, mesh.vertex(d), mesh.vertex(mesh.reorder(d, exchange_ends)), rules_[r].edge_point(d)});
    }
  }
  begin_.push_back(edge_points_.size());
}

void Subdivider::plan_vertices() {
  for (std::size_t r = 0; r < rules_.size(); ++r) {
    const Mesh& mesh = tree_.mesh(rules_[r].node());
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart)
        vertex_points_.push_back({r, v, v, rules_[r].vertex_point(mesh.dart_of(0, v))});
  }
}

// An edge that is not split yet has the ends that it had: by them its copies are known again.
void Subdivider::split_edges() {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Dart e = root_.dart_of(1, edges_[i]);
    std::vector<std::array<Index, 2>> ends;
    Copies before;
    before.collect(tree_, e, 1);
    for (const Copy& c : before.all()) {
      const Mesh& mesh = tree_.mesh(c.node);
      ends.push_back({mesh.vertex(c.dart), mesh.vertex(mesh.reorder(c.dart, exchange_ends))});
    }
    const Outcome o = operations_.split(NodeId::root, e);
    if (!o) throw UsageError("subdivide: an invariant refused a split: " + std::string(o.refusal.invariant));
    const Copies& after = operations_.copies();
    for (std::size_t c = 0; c < after.size(); ++c)
      for (std::size_t p = begin_[i]; p < begin_[i + 1]; ++p) {
        const Point& point = edge_points_[p];
        if (rules_[point.rules].node() != after[c].node ||
            std::minmax(point.a, point.b) != std::minmax(ends[c][0], ends[c][1]))
          continue;
        const Mesh& mesh = tree_.mesh(after[c].node);
        const Index v = mesh.vertex(mesh.reorder(after[c].dart, exchange_ends));
        new_points_.push_back({point.rules, v, v, point.at});
      }
  }
}

void Subdivider::swap_edges(const std::vector<Index>& source) {
  std::vector<bool> is_new(root_.capacity(0), false);
  for (const Point& p : new_points_)
    if (p.rules == 0) is_new[p.a] = true;
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    const Dart d = root_.dart_of(1, e), beyond = root_.switch_dart(d, 2);
    if (beyond == no_dart || source[root_.facet(d)] != source[root_.facet(beyond)]) continue;
    if (is_new[root_.vertex(d)] == is_new[root_.vertex(root_.reorder(d, exchange_ends))]) continue;
    const Outcome o = operations_.swap(NodeId::root, d);
    if (!o) throw UsageError("subdivide: an invariant refused a swap: " + std::string(o.refusal.invariant));
  }
}

// As a relocation, so that what follows coordinates (those of corners) follows.
void Subdivider::move(const Point& p) {
  const NodeId n = rules_[p.rules].node();
  const Outcome o = operations_.relocate(n, tree_.mesh(n).dart_of(0, p.a),
                                         [&](const Event&) { rules_[p.rules].set(p.a, p.at); });
  if (!o) throw UsageError("subdivide: an invariant refused a move: " + std::string(o.refusal.invariant));
}

void Subdivider::run(std::vector<Index>& source) {
  for (Index f = 0; f < source.size(); ++f) source[f] = f;
  plan_edges();
  plan_vertices();
  Transaction step = operations_.transaction();
  split_edges();
  swap_edges(source);
  for (const auto* points : {&vertex_points_, &new_points_})
    for (const Point& p : *points) move(p);
  step.commit();
}

}  // namespace

void subdivide(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
               Subdivision scheme) {
  openmesh::TemporaryProperty<OpenMesh::FPropHandleT<Index>> source(
      openmesh::root_surface(operations, "subdivide"), "mm:source");
  Subdivider(operations, positions, below, scheme).run(source.values());
}

}  // namespace multimesh
