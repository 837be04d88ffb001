// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/collapse_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multimesh/geometry/bounding_box.hpp"

namespace multimesh::decimation {

namespace {

constexpr Index several = no_index - 1;

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

/// The metric of one triangle, the same at each corner.
struct CollapseCost::Shape {
  Vec3 normal;
  double weight = 0;                  ///< a third of the area
  std::array<Vec3, max_sets> du, dv;  ///< derivatives of position by texture coordinates
  std::array<bool, max_sets> has_texture{};

  Shape(const SurfaceTriangle& t, std::size_t n_sets) {
    const Vec3 e = t.positions[1] - t.positions[0], f = t.positions[2] - t.positions[0];
    normal = cross(e, f);
    const double doubled_area = normal.norm();
    if (!(doubled_area > 0)) return;
    normal /= doubled_area;
    weight = doubled_area / 6;
    for (std::size_t k = 0; k < n_sets; ++k) {
      if (t.sets[k].facet == no_index) continue;
      const auto& s = t.sets[k].texcoords;
      const Vec2 u = s[1] - s[0], v = s[2] - s[0];
      const double determinant = u[0] * v[1] - u[1] * v[0];
      // A triangle without area in the texture says nothing about where its content belongs.
      has_texture[k] = std::abs(determinant) > 1e-12 * std::max(u.squared_norm(), v.squared_norm());
      if (!has_texture[k]) continue;
      du[k] = (e * v[1] - f * u[1]) / determinant;
      dv[k] = (f * u[0] - e * v[0]) / determinant;
    }
  }
};

/// Edge i of a triangle, and the direction in its plane that is orthogonal to it.
struct CollapseCost::Edge {
  double squared_length;
  Vec3 across;

  Edge(const SurfaceTriangle& t, const Shape& shape, std::size_t i) {
    const Vec3 along = t.positions[(i + 1) % 3] - t.positions[i];
    squared_length = along.squared_norm();
    if (squared_length > 0) across = cross(shape.normal, along) / std::sqrt(squared_length);
  }
};

CollapseCost::CollapseCost(const TexturedSurface& surface, const DecimateOptions& options, Strata& strata,
                           const TriangleReader& reader)
    : options_(options),
      tree_(surface.tree()),
      root_(tree_.mesh(NodeId::root)),
      strata_(strata),
      reader_(reader),
      positions_(surface.positions()),
      position_forms_(root_.capacity(0)) {
  for (const NodeId n : surface.textures()) {
    sets_.push_back({n, surface.texcoords(sets_.size()), std::vector<TextureForm>(tree_.mesh(n).capacity(0)),
                     std::vector<Index>(root_.capacity(0), no_index)});
  }
  const bool quadric = options_.cost == DecimateCost::quadric;
  if (quadric && options_.memory_weight > 0) {
    memory_.resize(root_.capacity(0));
    memory_unit_ = Unit(power_of_two_near(bounding_box_diagonal(positions_)));
  }
  SurfaceTriangle t;
  for (Index f = 0; f < root_.capacity(2); ++f) {
    if (!root_.is_live(2, f)) continue;
    reader_.read(root_.dart_of(2, f), t);
    if (quadric) add(t, 1);
    if (!memory_.empty()) remember(t);
    note_copies(t);
  }
}

void CollapseCost::note_copies(const SurfaceTriangle& t) {
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (t.sets[k].facet == no_index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      Index& copy = sets_[k].only_copy[t.vertices[i]];
      copy = copy == no_index || copy == t.sets[k].vertices[i] ? t.sets[k].vertices[i] : several;
    }
  }
}

void CollapseCost::remember(const SurfaceTriangle& t) {
  const Shape shape(t, 0);
  if (shape.weight == 0) return;
  const double unit = options_.memory_weight * memory_unit_.length * memory_unit_.length;  // of areas
  for (const Index v : t.vertices) memory_[v].add_plane(shape.normal, unit * shape.weight);
  if (!t.has_curves) return;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(t.curve_weights[i] > 0)) continue;
    const Edge edge(t, shape, i);
    if (!(edge.squared_length > 0)) continue;
    const double weight = unit * t.curve_weights[i] * edge.squared_length;
    for (const std::size_t corner : {i, (i + 1) % 3})
      memory_[t.vertices[corner]].add_plane(edge.across, weight);
  }
}

// With n the normal and J the derivative of position by texture coordinates: |n.x|^2 + w |Tx - Jy|^2, where
// T x = x - n (n.x).
void CollapseCost::add(const SurfaceTriangle& t, double sign) {
  const Shape shape(t, sets_.size());
  if (shape.weight == 0) return;
  const double uv = options_.uv_weight * shape.weight;
  double across = shape.weight, along = 0;
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (!shape.has_texture[k]) continue;
    across -= uv, along += uv;
    const Vec3 &u = shape.du[k], &v = shape.dv[k];
    const TextureForm form{-uv * u[0], -uv * v[0],     -uv * u[1],     -uv * v[1],    -uv * u[2],
                           -uv * v[2], uv * dot(u, u), uv * dot(u, v), uv * dot(v, v)};
    for (const Index w : t.sets[k].vertices) sets_[k].forms[w].add(form, sign);
  }
  PositionForm form = PositionForm::plane(shape.normal, across);
  form.add(PositionForm::point(along), 1);
  for (const Index v : t.vertices) position_forms_[v].add(form, sign);
  if (t.has_curves) add_curves(t, shape, sign);
}

// For each edge that is a curve, the distance to the plane through it, orthogonal to the triangle; for each
// that is open in a texture, the distance between the edge and the content that the vertex would have.
void CollapseCost::add_curves(const SurfaceTriangle& t, const Shape& shape, double sign) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Edge edge(t, shape, i);
    if (!(edge.squared_length > 0)) continue;
    if (t.curve_weights[i] > 0) {
      const PositionForm form = PositionForm::plane(edge.across, t.curve_weights[i] * edge.squared_length);
      position_forms_[t.vertices[i]].add(form, sign);
      position_forms_[t.vertices[j]].add(form, sign);
    }
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      if (!shape.has_texture[k] || !t.sets[k].open[i]) continue;
      const double weight = options_.uv_weight * options_.uv_curve_weight * edge.squared_length;
      const double u = dot(edge.across, shape.du[k]), v = dot(edge.across, shape.dv[k]);
      const TextureForm form{0, 0, 0, 0, 0, 0, weight * u * u, weight * u * v, weight * v * v};
      sets_[k].forms[t.sets[k].vertices[i]].add(form, sign);
      sets_[k].forms[t.sets[k].vertices[j]].add(form, sign);
    }
  }
}

// A vertex inside a chart has one copy, and so has an edge at it.
void CollapseCost::find_copies(Dart e, CollapsePlan& plan) const {
  plan.n_copies = 0;
  const bool inside = strata_.rank(plan.a) == Rank::free || strata_.rank(plan.b) == Rank::free;
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    const Index a = sets_[k].only_copy[plan.a], b = sets_[k].only_copy[plan.b];
    if (inside && a < several && b < several) {
      plan.copy_list[plan.n_copies++] = {k, a, b, {}};
      continue;
    }
    found_.clear();
    tree_.to_child(sets_[k].node, e, 1, found_);
    const Mesh& texture = tree_.mesh(sets_[k].node);
    for (const Dart d : found_)
      plan.copy_list[plan.n_copies++] = {
          k, texture.vertex(d), texture.vertex(texture.reorder(d, exchange_ends)), {}};
  }
}

double CollapseCost::deviation(const CollapsePlan& plan) const {
  const Vec3 from_a = plan.position - plan.at_a, from_b = plan.position - plan.at_b;
  double sum = 0;
  if (!memory_.empty()) {
    const double u = memory_unit_.length;
    sum = (memory_[plan.a](from_a * u) + memory_[plan.b](from_b * u)) * memory_unit_.per_4th;
  }
  if (plan.moves(End::a)) sum += position_forms_[plan.a](from_a);
  if (plan.moves(End::b)) sum += position_forms_[plan.b](from_b);
  for (const CollapsePlan::Copy& c : plan.copies()) {
    const auto& texcoords = sets_[c.set].texcoords;
    if (plan.moves(End::a)) sum += sets_[c.set].forms[c.a](from_a, c.texcoord - texcoords[c.a]);
    if (plan.moves(End::b)) sum += sets_[c.set].forms[c.b](from_b, c.texcoord - texcoords[c.b]);
  }
  const double area = position_forms_[plan.a].trace() + position_forms_[plan.b].trace();
  return std::max(sum, 0.0) + length_cost * area * (plan.at_b - plan.at_a).squared_norm();
}

void CollapseCost::start(Dart e, CollapsePlan& plan) const {
  std::array<Index, 4> v;
  root_.vertices(e, v.data());
  plan.a = v[0];
  plan.b = v[1];
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
  if (!strata_.may_collapse(e, plan.a, plan.b)) return false;
  const Rank a = strata_.rank(plan.a), b = strata_.rank(plan.b);
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

// With x and y the displacements from the middle of the edge, in space and in each copy, the deviation is
// x'Ax + 2 f.x + sum over copies (2 x'My + y'Sy + 2 g.y) and a constant. Texture coordinates are eliminated
// copy by copy: the best ones are linear in x.
void CollapseCost::minimize(CollapsePlan& plan) const {
  const Vec3 half = (plan.at_b - plan.at_a) * 0.5;
  const PositionForm &form_a = position_forms_[plan.a], &form_b = position_forms_[plan.b];
  PositionForm A = form_a + form_b;
  const double area = A.trace(), pull = pull_to_middle * area;
  Vec3 f = (form_a - form_b).times(half);
  if (!memory_.empty()) {
    const PlanesForm &in_a = memory_[plan.a], &in_b = memory_[plan.b];
    const PositionForm quadratic_a = in_a.quadratic(), quadratic_b = in_b.quadratic();
    A.add(quadratic_a + quadratic_b, memory_unit_.per_square);
    f += ((quadratic_a - quadratic_b).times(half * memory_unit_.length) + in_a.linear() + in_b.linear()) *
         memory_unit_.per_cube;
  }
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
  plan.cost = deviation(plan);
}

namespace {

/// Where the edges a-l and b-l of a dead triangle became one, the triangle beyond either has the curves of
/// both.
void inherit_curves(const PredictedStar& star, End end, SurfaceTriangle& t) {
  for (const PredictedStar::Face& dead : star.faces()) {
    if (!dead.dies || !dead.before.has_curves) continue;
    const std::size_t far = end == End::a ? 1 : 2;  // of the dead one's edges a-b, b-l, l-a
    for (const auto& [corner, edge] : {std::pair<std::size_t, std::size_t>{1, 0}, {2, 2}}) {
      if (t.vertices[corner] != dead.before.vertices[2]) continue;
      if (!t.has_curves) clear_curves(t);
      t.has_curves = true;
      t.curve_weights[edge] = std::max(t.curve_weights[edge], dead.before.curve_weights[far]);
      for (std::size_t k = 0; k < star.n_sets(); ++k)
        if (dead.before.sets[k].facet != no_index) t.sets[k].open[edge] |= dead.before.sets[k].open[far];
    }
  }
}

}  // namespace

void CollapseCost::collapsed(const PredictedStar& star, const CollapsePlan& plan, End kept) {
  const Index stays = kept == End::a ? plan.a : plan.b, goes = kept == End::a ? plan.b : plan.a;
  strata_.merge(stays, goes);
  if (options_.cost != DecimateCost::quadric) return;
  replace_triangles(star, plan, kept);
  if (memory_.empty()) return;
  memory_[plan.a].move((plan.position - plan.at_a) * memory_unit_.length);
  memory_[plan.b].move((plan.position - plan.at_b) * memory_unit_.length);
  memory_[stays].merge(memory_[goes]);
}

void CollapseCost::replace_triangles(const PredictedStar& star, const CollapsePlan& plan, End kept) {
  const Index stays = kept == End::a ? plan.a : plan.b, goes = kept == End::a ? plan.b : plan.a;
  const auto faces = star.faces();
  // A triangle that stays as it is can still get a curve.
  const bool curves =
      std::any_of(faces.begin(), faces.end(), [](const auto& f) { return f.before.has_curves; });
  for (const PredictedStar::Face& f : faces)
    if (f.changes || curves) add(f.before, -1);
  position_forms_[stays].add(position_forms_[goes], 1);
  for (const CollapsePlan::Copy& c : plan.copies()) {
    auto& forms = sets_[c.set].forms;
    forms[kept == End::a ? c.a : c.b].add(forms[kept == End::a ? c.b : c.a], 1);
  }
  SurfaceTriangle after;
  for (const PredictedStar::Face& f : faces) {
    if (f.dies || !(f.changes || curves)) continue;
    after = f.before;
    if (curves) inherit_curves(star, f.end, after);
    after.vertices[0] = stays;
    after.positions[0] = f.position;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      if (after.sets[k].facet == no_index) continue;
      after.sets[k].texcoords[0] = f.texcoords[k];
      for (const CollapsePlan::Copy& c : plan.copies())
        if (c.set == k && after.sets[k].vertices[0] == (f.end == End::a ? c.a : c.b))
          after.sets[k].vertices[0] = kept == End::a ? c.a : c.b;
    }
    add(after, 1);
  }
}

}  // namespace multimesh::decimation
