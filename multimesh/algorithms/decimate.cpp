// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "multimesh/algorithms/bounding_box.hpp"
#include "multimesh/algorithms/quadric.hpp"
#include "multimesh/algorithms/surface_invariants.hpp"
#include "multimesh/scheduler.hpp"

namespace multimesh {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;

namespace {

/// How much a vertex is bound: a vertex moves to the one that is bound more.
enum Rank : std::uint8_t { free_vertex, on_curve, fixed_point };

/// The collapse of one edge as the queue sees it.
struct Plan {
  double t = 0.5;     ///< the merged vertex is (1-t) a + t b
  double length = 0;  ///< cost, absolute
};

class Decimator {
 public:
  Decimator(TexturedSurface& surface, const DecimateOptions& options);
  DecimateResult run();

  // The scheduler's policy.
  std::optional<double> cost(Dart e) { return plan(e).length; }
  Outcome apply(Dart e, double cost);
  bool finished(double next_cost);

 private:
  void rank_vertices();
  void add_face_quadrics();
  void add_curve_quadrics();
  bool is_curve(Dart e) const;
  Plan plan(Dart e) const;
  Plan plan_at(Index a, Index b, double t) const;
  std::vector<RefusalCount> blocking(const std::vector<Index>& edges);
  void count(const Outcome& outcome, std::map<std::string, std::size_t>& counts) const;

  TexturedSurface& surface_;
  const DecimateOptions& options_;
  const Mesh& root_;
  double diagonal_;
  std::size_t faces_;
  DecimateResult result_;

  std::vector<Quadric> quadrics_;
  std::vector<std::uint8_t> ranks_;
  VertexAttribute<Vec3d> positions_;
  std::optional<VertexAttribute<Vec2d>> texcoords_;
  VertexAttribute<Quadric> quadric_attribute_;
  VertexAttribute<std::uint8_t> rank_attribute_;
  CopiesStayApart copies_stay_apart_;
  NormalTurn normal_turn_;
  std::optional<TextureOrientation> texture_orientation_;
  std::optional<SeamsStayOpen> seams_stay_open_;
  Propagation operations_;
  std::map<std::string, std::size_t> refused_;
};

Decimator::Decimator(TexturedSurface& surface, const DecimateOptions& options)
    : surface_(surface),
      options_(options),
      root_(surface.tree().mesh(NodeId::root)),
      diagonal_(bounding_box_diagonal(surface.positions())),
      faces_(surface.live_triangles()),
      quadrics_(root_.capacity(0)),
      ranks_(root_.capacity(0), free_vertex),
      positions_(NodeId::root, surface.positions()),
      quadric_attribute_(
          NodeId::root, quadrics_,
          [this](Operation, const VertexChange& c) { return quadrics_[c.a] + quadrics_[c.b]; }),
      rank_attribute_(
          NodeId::root, ranks_,
          [this](Operation, const VertexChange& c) { return std::max(ranks_[c.a], ranks_[c.b]); }),
      copies_stay_apart_(surface.source_positions()),
      normal_turn_(surface.positions(), options.max_normal_turn),
      operations_(surface.tree()) {
  operations_.add(positions_).add(rank_attribute_);
  if (surface.cut_report().copied_vertices > 0) operations_.add(copies_stay_apart_);
  if (const auto texture = surface.texture()) {
    texcoords_.emplace(*texture, surface.texcoords());
    texture_orientation_.emplace(surface.tree(), *texture, surface.texcoords());
    seams_stay_open_.emplace(*texture, surface.texcoords());
    operations_.add(*texcoords_).add(*texture_orientation_).add(*seams_stay_open_);
  }
  operations_.add(normal_turn_).set(LegalityOptions{.contact = true});  // seams may not touch the boundary
  rank_vertices();
  if (options.cost == DecimateCost::quadric) {
    operations_.add(quadric_attribute_);
    add_face_quadrics();
    add_curve_quadrics();
  }
}

bool Decimator::is_curve(Dart e) const {
  if (root_.is_boundary(e, 1)) return true;
  const auto seams = surface_.seams();
  return seams && surface_.tree().facet_over(*seams, e) != no_index;
}

// Curves: boundaries and seams. Fixed points: labelled vertices, and where curves end or meet.
void Decimator::rank_vertices() {
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    const Dart d = root_.dart_of(1, e);
    if (!is_curve(d)) continue;
    for (const Dart end : {d, root_.switch_dart(d, 0)})
      ranks_[root_.vertex(end)] = std::max<std::uint8_t>(ranks_[root_.vertex(end)], on_curve);
  }
  for (Index v = 0; v < root_.capacity(0); ++v)
    if (root_.is_locked(v)) ranks_[v] = fixed_point;
  const auto seams = surface_.seams();
  if (!seams) return;
  const Mesh& curves = surface_.tree().mesh(*seams);
  for (Index v = 0; v < curves.capacity(0); ++v) {
    if (!curves.is_live(0, v)) continue;
    const Dart d = curves.dart_of(0, v);
    if (curves.is_boundary(d, 0)) ranks_[root_.vertex(surface_.tree().to_parent(*seams, d))] = fixed_point;
  }
}

void Decimator::add_face_quadrics() {
  for (Index f = 0; f < root_.capacity(2); ++f) {
    if (!root_.is_live(2, f)) continue;
    std::array<Index, 4> v{};
    root_.vertices(root_.dart_of(2, f), v.data());
    const Vec3d& p = surface_.positions()[v[0]];
    Vec3d n = cross(surface_.positions()[v[1]] - p, surface_.positions()[v[2]] - p);
    const double doubled_area = n.norm();
    if (!(doubled_area > 0)) continue;
    n /= doubled_area;
    const Quadric q = Quadric::plane(n, -dot(n, p), doubled_area / 6);
    for (std::size_t i = 0; i < 3; ++i) quadrics_[v[i]] += q;
  }
}

// Planes through the curves, orthogonal to the faces beside them, hold the curves' shape.
void Decimator::add_curve_quadrics() {
  DartBuffer beside;
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e) || !is_curve(root_.dart_of(1, e))) continue;
    root_.star(root_.dart_of(1, e), 1, beside);
    for (const Dart d : beside) {
      std::array<Index, 4> v{};
      root_.vertices(d, v.data());
      const Vec3d& p = surface_.positions()[v[0]];
      const Vec3d along = surface_.positions()[v[1]] - p;
      const Vec3d face_normal = cross(along, surface_.positions()[v[2]] - p);
      Vec3d n = cross(along, face_normal);
      const double length = n.norm();
      if (!(length > 0)) continue;
      n /= length;
      Quadric q = Quadric::plane(n, -dot(n, p), options_.curve_weight * along.sqrnorm());
      q.weight = 0;  // it shapes the result, but is not part of the surface whose distance is reported
      quadrics_[v[0]] += q, quadrics_[v[1]] += q;
    }
  }
}

Plan Decimator::plan_at(Index a, Index b, double t) const {
  const Vec3d& pa = surface_.positions()[a];
  const Vec3d& pb = surface_.positions()[b];
  if (options_.cost == DecimateCost::length) return {t, (pb - pa).norm()};
  const Quadric q = quadrics_[a] + quadrics_[b];
  const double error = q(pa * (1 - t) + pb * t);
  return {t, q.weight > 0 ? std::sqrt(error / q.weight) : 0};
}

Plan Decimator::plan(Dart e) const {
  const Index a = root_.vertex(e), b = root_.vertex(root_.reorder(e, exchange_ends));
  if (ranks_[a] != ranks_[b]) return plan_at(a, b, ranks_[a] > ranks_[b] ? 0 : 1);
  if (options_.cost == DecimateCost::length) return plan_at(a, b, 0.5);
  // Along the edge the quadric is a parabola: f(t) = f0 + (slope) t + (curvature) t^2.
  const Vec3d& pa = surface_.positions()[a];
  const Vec3d d = surface_.positions()[b] - pa;
  const Quadric q = quadrics_[a] + quadrics_[b];
  const double curvature = dot(d, q.times(d));
  const double slope = 2 * (dot(d, q.times(pa)) + q.x * d[0] + q.y * d[1] + q.z * d[2]);
  double t = 0.5;
  if (curvature > 1e-12 * q.weight * d.sqrnorm()) t = std::clamp(-slope / (2 * curvature), 0.0, 1.0);
  return plan_at(a, b, t);
}

Outcome Decimator::apply(Dart e, double cost) {
  const std::size_t removed = root_.is_boundary(e, 1) ? 1 : 2;
  const double t = plan(e).t;
  const Outcome outcome = operations_.collapse(NodeId::root, e, Placement{t, false, true});
  count(outcome, refused_);
  if (!outcome) return outcome;
  faces_ -= removed;
  result_.max_cost = std::max(result_.max_cost, cost);
  if (options_.progress && operations_.statistics().done % 1024 == 0) options_.progress(faces_);
  return outcome;
}

bool Decimator::finished(double next_cost) {
  if (options_.faces > 0 && faces_ <= options_.faces) {
    result_.stop = DecimateResult::Stop::faces;
    return true;
  }
  if (next_cost > options_.max_error * diagonal_) {
    result_.stop = DecimateResult::Stop::max_error;
    return true;
  }
  return false;
}

void Decimator::count(const Outcome& outcome, std::map<std::string, std::size_t>& counts) const {
  if (outcome) return;
  const Refusal& r = outcome.refusal;
  ++counts[std::string(r.check == Check::invariant ? r.invariant : to_string(r.check))];
}

namespace {

std::vector<RefusalCount> by_frequency(const std::map<std::string, std::size_t>& counts) {
  std::vector<RefusalCount> list;
  for (const auto& [reason, n] : counts) list.push_back({reason, n});
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.count > y.count; });
  return list;
}

}  // namespace

DecimateResult Decimator::run() {
  result_.faces_before = faces_;
  PriorityScheduler scheduler(operations_);
  const PriorityScheduler::Stop stop = scheduler.run(*this);
  result_.tried = operations_.statistics().tried;
  result_.collapsed = operations_.statistics().done;
  if (stop == PriorityScheduler::Stop::exhausted) {
    result_.stop = options_.faces > 0 && faces_ <= options_.faces ? DecimateResult::Stop::faces
                                                                  : DecimateResult::Stop::exhausted;
    // The last pass asked every edge that is left and changed nothing.
    std::map<std::string, std::size_t> counts;
    for (const Index edge : scheduler.refused_edges()) {
      const Dart e = root_.dart_of(1, edge);
      count(operations_.collapse(NodeId::root, e, Placement{plan(e).t, false, true}), counts);
    }
    if (result_.stop == DecimateResult::Stop::exhausted) result_.blocking = by_frequency(counts);
  }
  result_.faces_after = faces_;
  result_.seconds = scheduler.seconds();
  result_.refused = by_frequency(refused_);
  result_.max_cost /= diagonal_ > 0 ? diagonal_ : 1;
  return std::move(result_);
}

}  // namespace

DecimateResult decimate(TexturedSurface& surface, const DecimateOptions& options) {
  if (options.faces == 0 && !std::isfinite(options.max_error))
    throw InputError("decimate: no target; give a number of faces or a maximal error");
  return Decimator(surface, options).run();
}

}  // namespace multimesh
