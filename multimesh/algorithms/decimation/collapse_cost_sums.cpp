// SPDX-License-Identifier: BSD-3-Clause
// The forms at the vertices: sums over triangles, and how they are kept up to date.
#include <algorithm>
#include <cmath>

#include "multimesh/algorithms/decimation/collapse_cost.hpp"

namespace multimesh::decimation {

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

void CollapseCost::note_copies(const SurfaceTriangle& t) {
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (t.sets[k].facet == no_index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      Index& copy = sets_[k].only_copy[t.vertices[i]];
      copy = copy == no_index || copy == t.sets[k].vertices[i] ? t.sets[k].vertices[i] : several_copies;
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

namespace {

/// Where the edges a-l and b-l of a dead triangle became one, the triangle beyond either has the curves of
/// both.
void inherit_curves(const PredictedStar& star, End end, SurfaceTriangle& t) {
  const std::size_t near = end == End::a ? 0 : 1;
  for (const PredictedStar::Face& dead : star.faces()) {
    if (!dead.dies || !dead.before.has_curves || dead.before.vertices[near] != t.vertices[0]) continue;
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

/// Which vertex corner 0 of a face is after the collapse.
Index merged_vertex(const CollapsePlan& plan, const PredictedStar::Face& f, End kept) {
  Index merged = f.before.vertices[0];
  plan.for_each_sheet([&](Index a, Index b) {
    if (f.before.vertices[0] == (f.end == End::a ? a : b)) merged = kept == End::a ? a : b;
  });
  return merged;
}

}  // namespace

void CollapseCost::collapsed(const PredictedStar& star, const CollapsePlan& plan, End kept) {
  if (options_.cost != DecimateCost::quadric) return;
  replace_triangles(star, plan, kept);
  if (memory_.empty()) return;
  const Vec3 from_a = (plan.position - plan.at_a) * memory_unit_.length;
  const Vec3 from_b = (plan.position - plan.at_b) * memory_unit_.length;
  plan.for_each_sheet([&](Index a, Index b) {
    memory_[a].move(from_a);
    memory_[b].move(from_b);
  });
  plan.for_each_sheet([&](Index a, Index b) {
    kept == End::a ? memory_[a].merge(memory_[b]) : memory_[b].merge(memory_[a]);
  });
}

void CollapseCost::replace_triangles(const PredictedStar& star, const CollapsePlan& plan, End kept) {
  const auto faces = star.faces();
  // A triangle that stays as it is can still get a curve.
  const bool curves =
      std::any_of(faces.begin(), faces.end(), [](const auto& f) { return f.before.has_curves; });
  for (const PredictedStar::Face& f : faces)
    if (f.changes || curves) add(f.before, -1);
  plan.for_each_sheet([&](Index a, Index b) {
    position_forms_[kept == End::a ? a : b].add(position_forms_[kept == End::a ? b : a], 1);
  });
  for (const CollapsePlan::Copy& c : plan.copies()) {
    auto& forms = sets_[c.set].forms;
    forms[kept == End::a ? c.a : c.b].add(forms[kept == End::a ? c.b : c.a], 1);
  }
  SurfaceTriangle after;
  for (const PredictedStar::Face& f : faces) {
    if (f.dies || !(f.changes || curves)) continue;
    after = f.before;
    if (curves) inherit_curves(star, f.end, after);
    after.vertices[0] = merged_vertex(plan, f, kept);
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
