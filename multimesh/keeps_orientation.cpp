// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/keeps_orientation.hpp"

#include <algorithm>
#include <array>

#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/swapped.hpp"

namespace multimesh {

namespace {

/// The largest doubled area that cannot be seen.
double no_area(const Coordinates& at, const Mesh& mesh) {
  Vec3 low(HUGE_VAL, HUGE_VAL, 0), high(-HUGE_VAL, -HUGE_VAL, 0);
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v)) low = min(low, at.at(v)), high = max(high, at.at(v));
  return low[0] <= high[0] ? KeepsSide::relative_no_area * (high - low).squared_norm() : 0;
}

}  // namespace

KeepsOrientation::KeepsOrientation(const Coordinates& positions, const Vec3& normal)
    : Invariant("facets keep their orientation", positions.node()), positions_(positions), normal_(normal) {}

KeepsOrientation::KeepsOrientation(const Coordinates& places, const Mesh& charts)
    : Invariant("triangles of charts keep their side", places.node()),
      positions_(places),
      charts_(true),
      keeps_{no_area(places, charts)} {}

KeepsOrientation::KeepsOrientation(std::unique_ptr<Coordinates> own, const Mesh* charts, const Vec3& normal)
    : Invariant(charts ? "triangles of charts keep their side" : "facets keep their orientation",
                own->node()),
      own_(std::move(own)),
      positions_(*own_),
      charts_(charts != nullptr),
      normal_(normal),
      keeps_{charts ? no_area(positions_, *charts) : 0} {}

bool KeepsOrientation::before(const Event& event) {
  if (event.operation == Operation::collapse) return allows_collapse(event);
  if (!charts_) return true;
  if (event.operation == Operation::split) before_split_ = count_sides(event, 1);
  if (event.operation != Operation::flip) return true;
  const std::span<const Copy> copies = event.copies.of(node());
  return std::ranges::all_of(copies,
                             [&](const Copy& c) { return allows_swap(event.tree.mesh(node()), c.dart); });
}

// Rounding may put the middle of a thin triangle's edge on its other side.
bool KeepsOrientation::after(const Event& event) {
  const std::span<const Copy> copies = event.copies.of(node());
  if (charts_) return event.operation != Operation::split || copies.empty() || halved(count_sides(event, 0));
  // Where one of several copies is put right by what keeps them in step, its place was not foreseen to the
  // last digit.
  if (event.operation == Operation::collapse && copies.size() < 2) return true;
  return std::ranges::all_of(copies, [&](const Copy& c) {
    const Mesh& mesh = event.tree.mesh(node());
    const bool split = event.operation == Operation::split;
    return is_positive_around(mesh, split ? mesh.reorder(c.dart, exchange_ends) : c.dart,
                              event.operation == Operation::flip);
  });
}

// Around either end, without the facets that die, with both ends where the merged vertex goes.
bool KeepsOrientation::allows_collapse(const Event& event) {
  const std::size_t first = event.copies.first(node());
  for (std::size_t i = first; i < first + event.copies.count(node()); ++i) {
    const Mesh& mesh = event.tree.mesh(node());
    const Dart at_a = event.copies[i].dart, at_b = mesh.reorder(at_a, exchange_ends);
    const Index a = mesh.vertex(at_a), b = mesh.vertex(at_b);
    const Vec3 place = positions_.merged(event.collapse_of(i));
    if (!allows_merged(mesh, at_a, b, place) || !allows_merged(mesh, at_b, a, place)) return false;
  }
  return true;
}

bool KeepsOrientation::allows_merged(const Mesh& mesh, Dart end, Index other, const Vec3& place) {
  const Index v = mesh.vertex(end);
  if (positions_.at(v) == place) return true;
  if (charts_) return allows(mesh, end, place, other);
  mesh.star(end, 0, star_);
  return std::ranges::all_of(star_, [&](Dart facet) {
    std::array<Index, 4> w;
    w.fill(no_index);
    mesh.vertices(facet, w.data());
    return std::ranges::find(w, other) != w.end() || is_positive(mesh, facet, v, place);
  });
}

// --- in space

// Of the facet of a dart, with `by` for the place of the vertex `replaced`.
bool KeepsOrientation::is_positive(const Mesh& mesh, Dart facet, Index replaced, const Vec3& by) const {
  const int d = mesh.dimension();
  std::array<Index, 4> v{};
  mesh.facet_vertices(mesh.facet(facet), v.data());
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i)
    p[i] = v[i] == replaced ? by : positions_.at(v[i]);
  return orientation_of_facet(d, p.data(), normal_) > 0;
}

bool KeepsOrientation::is_positive_around(const Mesh& mesh, Dart d, int k) {
  mesh.star(d, k, star_);
  return std::ranges::all_of(star_,
                             [&](Dart facet) { return is_positive(mesh, facet, no_index, Vec3(0, 0, 0)); });
}

// --- charts

// In the orientation of the mesh, whatever that of the dart.
Corners<3> KeepsOrientation::triangle(const Mesh& mesh, Dart d) const {
  std::array<Index, 4> v{};
  mesh.facet_vertices(mesh.facet(d), v.data());
  return {positions_.at(v[0]), positions_.at(v[1]), positions_.at(v[2])};
}

/// That of the triangles in star_; 0 if they have both.
int KeepsOrientation::common_side(const Mesh& mesh) const {
  int common = 0;
  for (const Dart t : star_) {
    const int s = side_of(triangle(mesh, t));
    if (s != 0 && s == -common) return 0;
    if (s != 0) common = s;
  }
  return common;
}

bool KeepsOrientation::allows(const Mesh& mesh, Dart vertex, const Vec3& to, Index without) {
  mesh.star(vertex, 0, star_);
  const int common = common_side(mesh);
  const Index moved = mesh.vertex(vertex);
  return std::ranges::all_of(star_, [&](Dart t) {
    std::array<Index, 4> v{};
    mesh.facet_vertices(mesh.facet(t), v.data());
    const Corners<3> before{positions_.at(v[0]), positions_.at(v[1]), positions_.at(v[2])};
    Corners<3> after = before;
    for (std::size_t i = 0; i < 3; ++i) {
      if (v[i] == without) return true;
      if (v[i] == moved) after[i] = to;
    }
    return keeps_(before, after, common);
  });
}

bool KeepsOrientation::allows_swap(const Mesh& mesh, Dart edge) {
  mesh.star(edge, 1, star_);
  if (star_.size() != 2) return false;
  const Swapped t(mesh, positions_, star_);
  const int sum = side_of(t.left) + side_of(t.right);
  if (sum == 0) return false;
  const int common = sum > 0 ? 1 : -1;
  return t.keeps_all(
      [&](const Corners<3>& before, const Corners<3>& after) { return keeps_(before, after, common); });
}

// Of the triangles around the edge in all copies before a split, or of the new vertex after it.
KeepsOrientation::Sides KeepsOrientation::count_sides(const Event& event, int k) {
  Sides sum;
  for (const Copy& c : event.copies.of(node())) {
    const Mesh& mesh = event.tree.mesh(node());
    mesh.star(k == 0 ? mesh.reorder(c.dart, exchange_ends) : c.dart, k, star_);
    for (const Dart t : star_) {
      const Corners<3> corners = triangle(mesh, t);
      const int s = side_of(corners);
      sum.left += s > 0, sum.right += s < 0, sum.none += s == 0;
      sum.unseen += std::abs(doubled_area(corners)) <= keeps_.no_area;
    }
  }
  return sum;
}

/// Whether no triangle changed its side or vanished when each was halved.
bool KeepsOrientation::halved(const Sides& after) const {
  const Sides& before = before_split_;
  const bool none_may_be_left = before.right == 0 && before.left > 0;
  const bool none_may_be_right = before.left == 0 && before.right > 0;
  return after.left >= 2 * before.left && (after.left == 2 * before.left || none_may_be_left) &&
         after.right >= 2 * before.right && (after.right == 2 * before.right || none_may_be_right) &&
         after.unseen <= 2 * before.unseen;
}

}  // namespace multimesh
