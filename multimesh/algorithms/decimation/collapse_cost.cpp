// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/collapse_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multimesh::decimation {

namespace {

/// Where deviation leaves the place open, as in a plane, it is drawn to the middle of the edge.
constexpr double pull_to_middle = 1e-8;
/// Of edges that cost the same, the shorter one first.
constexpr double length_cost = 1e-8;
/// Below it, relative to the squared trace, the best texture coordinates are lost in roundings, and those on
/// the edge are taken: at slivers of the texture.
constexpr double least_determinant = 1e-8;

/// Of the reciprocal of a length.
double power_of_two_near(double length) {
  return length > 0 && std::isfinite(length) ? std::exp2(-std::ilogb(length)) : 1;
}

}  // namespace

CollapseCost::CollapseCost(const DecimateOptions& options, const Ranks& ranks, const TriangleReader& reader)
    : options_(options),
      tree_(reader.tree()),
      mesh_(reader.mesh()),
      ranks_(ranks),
      reader_(reader),
      positions_(reader.positions()),
      is_periodic_(!reader.coordinates().periods().empty()),
      position_forms_(mesh_.capacity(0)) {
  for (std::size_t k = 0; k < reader.n_sets(); ++k) {
    const NodeId n = reader.texture(k);
    sets_.push_back({n, reader.texcoords(k), std::vector<TextureForm>(tree_.mesh(n).capacity(0)),
                     std::vector<Index>(mesh_.capacity(0), no_index)});
  }
  const bool quadric = options_.cost == DecimateCost::quadric;
  if (quadric && options_.memory_weight > 0) {
    memory_.resize(mesh_.capacity(0));
    memory_unit_ = Unit(power_of_two_near(reader.diagonal()));
  }
  SurfaceTriangle t;
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    reader_.read(mesh_.dart_of(2, f), t);
    if (quadric) add(t, 1);
    if (!memory_.empty()) remember(t);
    note_copies(t);
  }
}

// A vertex inside a chart has one copy, and so has an edge at it.
void CollapseCost::find_copies(Dart e, CollapsePlan& plan) const {
  plan.n_copies = 0;
  const bool inside = ranks_.rank(plan.a) == Rank::free || ranks_.rank(plan.b) == Rank::free;
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    const Index a = sets_[k].only_copy[plan.a], b = sets_[k].only_copy[plan.b];
    if (inside && a < several_copies && b < several_copies) {
      plan.copy_list[plan.n_copies++] = {k, a, b, {}};
      continue;
    }
    found_.clear();
    tree_.to_descendant(reader_.node(), e, 1, sets_[k].node, found_);
    for (std::size_t i = 0; i < plan.other_sheets.size(); ++i)
      tree_.to_descendant(reader_.node(), sheets_[i + 1], 1, sets_[k].node, found_);
    const Mesh& texture = tree_.mesh(sets_[k].node);
    for (const Dart d : found_)
      if (plan.n_copies < plan.copy_list.size())
        plan.copy_list[plan.n_copies++] = {
            k, texture.vertex(d), texture.vertex(texture.reorder(d, exchange_ends)), {}};
  }
}

// One sheet is by far the most frequent case: a loop costs a tenth of the function.
template <bool other_sheets>
double CollapseCost::deviation_of(const CollapsePlan& plan) const {
  const Vec3 from_a = plan.position - plan.at_a, from_b = plan.position - plan.at_b;
  double sum = 0, area = 0;
  plan.for_each_sheet_if<other_sheets>([&](Index a, Index b) {
    if (!memory_.empty()) {
      const double u = memory_unit_.length;
      sum += (memory_[a](from_a * u) + memory_[b](from_b * u)) * memory_unit_.per_4th;
    }
    if (plan.moves(End::a)) sum += position_forms_[a](from_a);
    if (plan.moves(End::b)) sum += position_forms_[b](from_b);
    area += position_forms_[a].trace() + position_forms_[b].trace();
  });
  for (const CollapsePlan::Copy& c : plan.copies()) {
    const auto& texcoords = sets_[c.set].texcoords;
    if (plan.moves(End::a)) sum += sets_[c.set].forms[c.a](from_a, c.texcoord - texcoords[c.a]);
    if (plan.moves(End::b)) sum += sets_[c.set].forms[c.b](from_b, c.texcoord - texcoords[c.b]);
  }
  return std::max(sum, 0.0) + length_cost * area * (plan.at_b - plan.at_a).squared_norm();
}

void CollapseCost::find_sheets(Dart e, CollapsePlan& plan) const {
  ranks_.sheets(e, plan.a, plan.b, sheets_);
  plan.other_sheets.clear();
  for (std::size_t i = 1; i < sheets_.size(); ++i)
    plan.other_sheets.push_back(
        {mesh_.vertex(sheets_[i]), mesh_.vertex(mesh_.reorder(sheets_[i], exchange_ends))});
}

void CollapseCost::start(Dart e, CollapsePlan& plan) const {
  std::array<Index, 4> v;
  mesh_.vertices(e, v.data());
  plan.a = v[0];
  plan.b = v[1];
  if (ranks_.has_sheets()) find_sheets(e, plan);
  plan.at_a = positions_[plan.a];
  plan.at_b = positions_[plan.b];
}

CollapsePlan CollapseCost::plan_at(Dart e, double t) const {
  CollapsePlan plan;
  start(e, plan);
  put_at(e, t, plan);
  return plan;
}

void CollapseCost::put_at(Dart e, double t, CollapsePlan& plan) const {
  plan.t = t;
  find_copies(e, plan);
  const auto between = [t](const auto& values, Index a, Index b) {
    return t <= 0 ? values[a] : t >= 1 ? values[b] : values[a] * (1 - t) + values[b] * t;
  };
  plan.position = between(positions_, plan.a, plan.b);
  for (CollapsePlan::Copy& c : plan.copies()) c.texcoord = between(sets_[c.set].texcoords, c.a, c.b);
  plan.cost =
      options_.cost == DecimateCost::quadric ? deviation(plan) : (plan.at_a - plan.at_b).squared_norm();
}

std::optional<CollapsePlan> CollapseCost::plan(Dart e) const {
  std::optional<CollapsePlan> result(std::in_place);
  if (!plan(e, *result)) result.reset();
  return result;
}

bool CollapseCost::plan(Dart e, CollapsePlan& plan) const {
  start(e, plan);
  if (!ranks_.may_collapse(e, plan.a, plan.b)) return false;
  const Rank a = ranks_.rank(plan.a), b = ranks_.rank(plan.b);
  if (a != b) {
    put_at(e, a > b ? 0 : 1, plan);
  } else if (options_.cost == DecimateCost::length) {
    put_at(e, 0.5, plan);
  } else {
    find_copies(e, plan);
    minimize(plan);
  }
  // Coordinates so large that squares overflow: such an edge comes last.
  if (!std::isfinite(plan.cost)) {
    put_at(e, 0.5, plan);
    plan.cost = std::numeric_limits<double>::max();
  }
  return true;
}

/// x'Ax + 2 f.x + a constant.
struct CollapseCost::Quadratic {
  PositionForm A;
  Vec3 f{};
  double area = 0;  ///< the trace of A without memory
};

// With x the displacement from the middle of the edge, but for the textures.
template <bool other_sheets>
CollapseCost::Quadratic CollapseCost::quadratic(const CollapsePlan& plan, const Vec3& half) const {
  Quadratic q;
  plan.for_each_sheet_if<other_sheets>([&](Index a, Index b) {
    const PositionForm &form_a = position_forms_[a], &form_b = position_forms_[b];
    const PositionForm sum = form_a + form_b;
    q.A.add(sum, 1);
    q.f += (form_a - form_b).times(half);
    q.area += sum.trace();
    if (memory_.empty()) return;
    const PlanesForm &in_a = memory_[a], &in_b = memory_[b];
    const PositionForm quadratic_a = in_a.quadratic(), quadratic_b = in_b.quadratic();
    q.A.add(quadratic_a + quadratic_b, memory_unit_.per_square);
    q.f += ((quadratic_a - quadratic_b).times(half * memory_unit_.length) + in_a.linear() + in_b.linear()) *
           memory_unit_.per_cube;
  });
  return q;
}

// Where sides of a tile stay flat, displacements of both ends are in some plane, or along some line: P
// projects there. Elsewhere the form is made steep.
void CollapseCost::stay_in_sides(const CollapsePlan& plan, Quadratic& q) const {
  const double step = (plan.at_b - plan.at_a).norm();
  std::array<Vec3, 3> p, ap;
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 probe = plan.at_a;
    probe[i] += step;
    p[i] = (reader_.coordinates().allowed(plan.a, probe) - plan.at_a) / step;
    ap[i] = q.A.times(p[i]);
  }
  const double steep = q.A.trace();
  const auto entry = [&](std::size_t i, std::size_t j) {
    return dot(p[i], ap[j]) + steep * ((i == j ? 1 : 0) - p[i][j]);
  };
  q.f = {dot(p[0], q.f), dot(p[1], q.f), dot(p[2], q.f)};
  q.A = {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

// With y the displacements in each copy, the deviation is x'Ax + 2 f.x + sum over copies
// (2 x'My + y'Sy + 2 g.y) and a constant. Texture coordinates are eliminated copy by copy: the best ones are
// linear in x.
template <bool other_sheets>
void CollapseCost::minimize_over(CollapsePlan& plan) const {
  const Vec3 half = (plan.at_b - plan.at_a) * 0.5;
  Quadratic q = quadratic<other_sheets>(plan, half);
  auto& [A, f, area] = q;
  const double pull = pull_to_middle * area;
  A.add(PositionForm::point(pull), 1);

  struct Elimination {
    bool possible;
    Vec3 u, v;  ///< y = (u.x, v.x) + constant
    Vec2 constant;
  };
  std::array<Elimination, 2 * max_sets> eliminations;
  for (std::size_t i = 0; i < plan.n_copies; ++i) {
    const CollapsePlan::Copy& copy = plan.copy_list[i];
    const auto& texcoords = sets_[copy.set].texcoords;
    const Vec2 half_y = (texcoords[copy.b] - texcoords[copy.a]) * 0.5;
    const TextureForm &in_a = sets_[copy.set].forms[copy.a], &in_b = sets_[copy.set].forms[copy.b];
    const TextureForm sum = in_a + in_b, difference = in_a - in_b;
    f += difference.mixed(half_y);
    const Vec2 g = difference.mixed(half) + difference.times(half_y);
    const double determinant = sum.uu * sum.vv - sum.uv * sum.uv, trace = sum.uu + sum.vv;
    Elimination& e = eliminations[i];
    e.possible = determinant > least_determinant * trace * trace;
    if (!e.possible) continue;
    const Vec3 mu(sum.xu, sum.yu, sum.zu), mv(sum.xv, sum.yv, sum.zv);
    const double inverse = 1 / determinant;
    e.u = (mv * sum.uv - mu * sum.vv) * inverse;
    e.v = (mu * sum.uv - mv * sum.uu) * inverse;
    e.constant = {(g[1] * sum.uv - g[0] * sum.vv) * inverse, (g[0] * sum.uv - g[1] * sum.uu) * inverse};
    A.xx += mu[0] * e.u[0] + mv[0] * e.v[0];
    A.xy += mu[0] * e.u[1] + mv[0] * e.v[1];
    A.xz += mu[0] * e.u[2] + mv[0] * e.v[2];
    A.yy += mu[1] * e.u[1] + mv[1] * e.v[1];
    A.yz += mu[1] * e.u[2] + mv[1] * e.v[2];
    A.zz += mu[2] * e.u[2] + mv[2] * e.v[2];
    f += mu * e.constant[0] + mv * e.constant[1];
  }

  if (is_periodic_) stay_in_sides(plan, q);
  const Vec3 x = minimum(A, f);
  const double squared_half = half.squared_norm();
  // Off the ends, where the vertex would count as not moved.
  plan.t = std::clamp(0.5 + (squared_half > 0 ? 0.5 * dot(x, half) / squared_half : 0), 1e-3, 1 - 1e-3);
  plan.position = (plan.at_a + plan.at_b) * 0.5 + x;
  for (std::size_t i = 0; i < plan.n_copies; ++i) {
    CollapsePlan::Copy& copy = plan.copy_list[i];
    const auto& texcoords = sets_[copy.set].texcoords;
    const Elimination& e = eliminations[i];
    copy.texcoord = e.possible ? (texcoords[copy.a] + texcoords[copy.b]) * 0.5 +
                                     Vec2(dot(e.u, x) + e.constant[0], dot(e.v, x) + e.constant[1])
                               : texcoords[copy.a] * (1 - plan.t) + texcoords[copy.b] * plan.t;
  }
  // Not from the solution, whose roundings can be far larger.
  plan.cost = deviation_of<other_sheets>(plan);
}

void CollapseCost::minimize(CollapsePlan& plan) const {
  plan.other_sheets.empty() ? minimize_over<false>(plan) : minimize_over<true>(plan);
}

}  // namespace multimesh::decimation
