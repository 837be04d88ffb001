// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/exact_place.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "multimesh/geometry/orient2d.hpp"
#include "multimesh/geometry/orient3d.hpp"

namespace multimesh::improvement {

namespace {

/// The sign of the triangle's area without this coordinate. In one plane that is not parallel to the axis, it
/// tells orientations apart; it is 0 just if the triangle's plane is parallel to the axis.
int turn_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int i = axis == 0 ? 1 : 0, j = axis == 2 ? 1 : 2;
  const double p[2] = {a[i], a[j]}, q[2] = {b[i], b[j]}, r[2] = {c[i], c[j]};
  return orient2d(p, q, r);
}

/// Coordinate axes, that most nearly normal to the triangle's plane first: without that coordinate, signs of
/// areas are the clearest.
std::array<int, 3> clearest_axes(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) {
    return std::abs(normal[std::size_t(i)]) > std::abs(normal[std::size_t(j)]);
  });
  return axes;
}

/// Whether (p,b,c), in the plane of (a,b,c), has the same orientation there.
bool same_turn(const Vec3& a, const Vec3& p, const Vec3& b, const Vec3& c) {
  for (const int axis : clearest_axes(a, b, c))
    if (const int turn = turn_without(axis, a, b, c); turn != 0) return turn_without(axis, p, b, c) == turn;
  return false;  // a triangle without area
}

/// Whether p lies strictly between a and b. \pre on one line
bool between(const Vec3& a, const Vec3& p, const Vec3& b) {
  for (int i = 0; i < 3; ++i)
    if (a[i] != b[i]) return std::min(a[i], b[i]) < p[i] && p[i] < std::max(a[i], b[i]);
  return false;
}

}  // namespace

bool ExactPlace::read(Dart at_v) {
  v_ = work_.mesh().vertex(at_v);
  faces_.clear();
  seen_.clear();
  n_curve_edges_ = 0;
  curve_ = {};
  envelope_ = nullptr;
  is_exact_ = (work_.strata().of(work_.mesh().vertex(at_v)) & Strata::on_curve) != 0;
  const std::uint8_t strata = work_.strata().of(v_);
  if (strata & Strata::fixed) return false;
  work_.read_copies(at_v, 0, copies_);
  for (const Dart copy : copies_) {
    work_.mesh().star(copy, 0, star_);
    if (strata & Strata::on_face) read_faces(copy);
    if (strata & Strata::on_curve) read_curves(copy);
  }
  drop_repeated_faces();
  if (strata & Strata::on_curve) {
    n_curve_edges_ = seen_.size();
    if (n_curve_edges_ != 2) return false;
    curve_ = {seen_[0], seen_[1]};
    if (!curve_is_straight()) return false;
  }
  if (is_exact_) envelope_ = nullptr;
  if (!join_sheets()) return false;
  if (!envelope_) return sheets_are_plane();
  return std::ranges::all_of(faces_, [](const Face& f) { return f.sheet == 0; });
}

void ExactPlace::read_faces(Dart copy) {
  const Mesh& mesh = work_.mesh();
  const Index v = mesh.vertex(copy);
  for (const Dart t : star_)
    for (const Permutation p : {Permutation{}, permutation(0, 1, 3, 2), permutation(0, 2, 3, 1)}) {
      const Dart f = mesh.reorder(t, p);
      if (!work_.strata().is_wall(f)) continue;
      const StaysInEnvelope* held_by = is_exact_ ? nullptr : work_.envelope_of(f);
      is_exact_ = !held_by || (envelope_ && envelope_ != &held_by->envelope());
      envelope_ = is_exact_ ? nullptr : &held_by->envelope();
      Index c[4];
      mesh.vertices(f, c);
      const auto [low, high] = std::minmax({beside(v, c[1]), beside(v, c[2])});
      faces_.push_back({low, high, 0});
    }
}

void ExactPlace::drop_repeated_faces() {
  const auto order = [](const Face& f, const Face& g) {
    return std::tie(f.p.name, f.q.name) < std::tie(g.p.name, g.q.name);
  };
  const auto same = [](const Face& f, const Face& g) { return f.p == g.p && f.q == g.q; };
  std::sort(faces_.begin(), faces_.end(), order);
  faces_.erase(std::unique(faces_.begin(), faces_.end(), same), faces_.end());
}

void ExactPlace::read_curves(Dart copy) {
  const Mesh& mesh = work_.mesh();
  for (const Dart t : star_)
    for (const Permutation p : {Permutation{}, permutation(0, 2, 1, 3), permutation(0, 3, 1, 2)}) {
      const Dart e = mesh.reorder(t, p);
      if (!work_.strata().is_curve(e)) continue;
      const Beside w = beside(mesh.vertex(copy), mesh.vertex(mesh.reorder(e, exchange_ends)));
      if (std::find(seen_.begin(), seen_.end(), w) == seen_.end()) seen_.push_back(w);
    }
}

bool ExactPlace::curve_is_straight() const {
  const Vec3 &v = work_.point(v_), a = point(curve_[0]), b = point(curve_[1]);
  return flatness_.collinear(a, v, b) && between(a, v, b);
}

// Faces that meet in an edge that is no curve are of one sheet. False unless just two meet in each of these.
bool ExactPlace::join_sheets() {
  for (std::size_t i = 0; i < faces_.size(); ++i) faces_[i].sheet = i;
  for (const Face& f : faces_)
    for (const Beside& p : {f.p, f.q}) {
      if (is_curve_end(p)) continue;
      std::size_t n = 0;
      for (const Face& g : faces_) n += g.p == p || g.q == p;
      if (n != 2) return false;
    }
  for (bool changed = true; changed;) {
    changed = false;
    for (Face& f : faces_)
      for (Face& g : faces_) {
        const bool meet = (!is_curve_end(f.p) && (f.p == g.p || f.p == g.q)) ||
                          (!is_curve_end(f.q) && (f.q == g.p || f.q == g.q));
        if (meet && f.sheet > g.sheet) f.sheet = g.sheet, changed = true;
      }
  }
  return true;
}

bool ExactPlace::sheets_are_plane() const {
  const Vec3& v = work_.point(v_);
  return std::all_of(faces_.begin(), faces_.end(), [&](const Face& f) {
    const Face& first = faces_[f.sheet];  // sheets are named after their first face
    return (n_curve_edges_ > 0 || f.sheet == 0) &&
           flatness_.coplanar(v, point(first.p), point(first.q), point(f.p)) &&
           flatness_.coplanar(v, point(first.p), point(first.q), point(f.q));
  });
}

bool ExactPlace::allows_merging(Index b) const {
  const Index name = work_.name(b);
  if (n_curve_edges_ > 0) return is_curve_end({b, v_, name}) && allows(work_.point(b), name);
  const bool on_sheet = std::any_of(faces_.begin(), faces_.end(),
                                    [&](const Face& f) { return f.p.name == name || f.q.name == name; });
  return on_sheet && allows(work_.point(b), name);
}

bool ExactPlace::stays_inside(const Vec3& p, Index merged) const {
  return std::all_of(faces_.begin(), faces_.end(), [&](const Face& f) {
    return f.p.name == merged || f.q.name == merged || envelope_->contains({p, point(f.p), point(f.q)});
  });
}

// The faces are not oriented alike: that of each is made to agree with the first.
Vec3 ExactPlace::normal() const {
  const Vec3& v = work_.point(v_);
  Vec3 sum{};
  for (const Face& f : faces_) {
    const Vec3 n = cross(point(f.p) - v, point(f.q) - v);
    sum += dot(sum, n) < 0 ? -n : n;
  }
  return sum.unit_or_zero();
}

bool ExactPlace::allows(const Vec3& p, Index merged) const {
  if (envelope_) return stays_inside(p, merged);
  const Vec3& v = work_.point(v_);
  if (n_curve_edges_ > 0) {
    const Vec3 a = point(curve_[0]), b = point(curve_[1]);
    if (!flatness_.collinear(a, p, b)) return false;
    if (merged == no_index && !between(a, p, b)) return false;
  }
  return std::all_of(faces_.begin(), faces_.end(), [&](const Face& f) {
    if (f.p.name == merged || f.q.name == merged) return true;
    const Vec3 at_p = point(f.p), at_q = point(f.q);
    return flatness_.coplanar(v, at_p, at_q, p) && same_turn(v, p, at_p, at_q);
  });
}

std::array<bool, 3> ExactPlace::axes() const {
  if (envelope_) return {true, true, true};
  std::array<bool, 3> free{};
  for (int axis = 0; axis < 3; ++axis) {
    bool parallel = true;
    if (n_curve_edges_ > 0)
      for (int i = 0; i < 3; ++i)
        parallel = parallel && (i == axis || point(curve_[0])[i] == point(curve_[1])[i]);
    for (const Face& f : faces_)
      parallel = parallel && turn_without(axis, work_.point(v_), point(f.p), point(f.q)) == 0;
    free[static_cast<std::size_t>(axis)] = parallel;
  }
  return free;
}

bool may_exchange_diagonals(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y, Flatness flatness) {
  if (!flatness.coplanar(a, b, x, y)) return false;
  for (const int axis : clearest_axes(a, b, x)) {
    const int side = turn_without(axis, a, b, x);
    if (side == 0) continue;
    return turn_without(axis, a, b, y) == -side && turn_without(axis, x, y, b) == side &&
           turn_without(axis, x, y, a) == -side;
  }
  return false;
}

bool lies_flat(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y, Flatness flatness) {
  if (!flatness.coplanar(a, b, x, y)) return false;
  for (const int axis : clearest_axes(a, b, x))
    if (const int side = turn_without(axis, a, b, x); side != 0) return turn_without(axis, a, b, y) == -side;
  return false;
}

bool lies_flat_split_at(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y, const Vec3& m) {
  return lies_flat(a, b, x, y) && Flatness{}.coplanar(a, b, x, m) && same_turn(a, m, b, x) &&
         same_turn(b, m, a, x) && same_turn(a, m, b, y) && same_turn(b, m, a, y);
}

}  // namespace multimesh::improvement
