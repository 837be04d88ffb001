// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/candidates.hpp"

#include <algorithm>

#include "multimesh/faces.hpp"
#include "multimesh/geometry/orient3d.hpp"

namespace multimesh::improvement {

namespace {

constexpr std::size_t largest_ring = 12;  // of a swap; larger ones hardly ever have a good fan

}  // namespace

double Candidates::ring_quality(const Ring& ring) const {
  double worst = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    worst = std::max(worst, work_.quality_of(Corners{ring.a, ring.b, ring.rim[i], ring.next(i)}));
  return worst;
}

double Candidates::star_quality(const std::vector<Corners>& star) const {
  double worst = 0;
  for (const Corners& c : star) worst = std::max(worst, work_.quality_of(c));
  return worst;
}

/// The vertices of an edge in a fixed order.
std::pair<Index, Index> Candidates::ends(Dart e) const {
  Index v[4];
  work_.mesh().vertices(e, v);
  return std::minmax({v[0], v[1]});
}

bool Candidates::read_place(Dart v, const Demand& demand) {
  const Index a = work_.mesh().vertex(v);
  if (demand.remember && refusals_.knows_held(a)) return false;
  if (place_.read(v)) return true;
  if (demand.remember) refusals_.note_held(a);
  return false;
}

// Reads the star of the vertex, unless it is the last one that was read, in the same state.
void Candidates::read_star_at(Dart v) {
  const Index a = work_.mesh().vertex(v);
  if (a == star_of_ && refusals_.stars().of(a) == star_stamp_ && star_stamp_ > 0) return;
  work_.read_star(v, star_);
  star_of_ = a;
  star_stamp_ = refusals_.stars().of(a);
  star_quality_ = star_quality(star_);
}

// --- edges ---------------------------------------------------------------------------------------------

void Candidates::read_edge_state(const Ring& ring) {
  const Strata& strata = work_.strata();
  edge_.curve = strata.is_curve(ring.darts.front());
  edge_.locked = strata.edge_stays(ring.darts.front());
  if (strata.may_facets_stay())
    for (const Dart d : ring.darts) edge_.locked = edge_.locked || strata.facet_stays(work_.tet(d));
  work_.read_walls(ring, edge_.faces);
  for (const std::size_t i : edge_.faces)
    edge_.locked = edge_.locked || strata.wall_stays(work_.face_at(ring, i));
}

// The fan from rim[apex]; of a closed ring without the two tetrahedra at the apex, of an open one without
// that at its end.
double Candidates::fan_quality(const Ring& ring, std::size_t apex, double limit) const {
  const Index x = ring.rim[apex];
  double worst = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index y = ring.rim[i], z = ring.next(i);
    if (y == x || z == x) continue;
    worst = std::max(worst, work_.quality_of(Corners{ring.a, x, y, z}, limit));
    if (worst >= limit) break;
    worst = std::max(worst, work_.quality_of(Corners{x, ring.b, y, z}, limit));
    if (worst >= limit) break;
  }
  return worst;
}

bool Candidates::is_fan_too_long(const Ring& ring, std::size_t apex, const Demand& demand) const {
  const Vec3& x = point(ring.rim[apex]);
  return std::any_of(ring.rim.begin(), ring.rim.end(),
                     [&](Index y) { return demand.is_too_long(x, point(y)); });
}

// Into that of the other diagonal.
bool Candidates::may_swap_wall(const Ring& ring) const {
  const Vec3 &a = point(ring.a), &b = point(ring.b), &x = point(ring.rim[edge_.faces[0]]),
             &y = point(ring.rim[edge_.faces[1]]);
  const StaysInEnvelope* held_by = work_.envelope_of(work_.face_at(ring, edge_.faces[0]));
  if (!held_by || held_by != work_.envelope_of(work_.face_at(ring, edge_.faces[1])))
    return may_exchange_diagonals(a, b, x, y, work_.flatness());
  const Vec3 before = cross(x - a, b - a), at_a = cross(x - a, y - a), at_b = cross(y - b, x - b);
  return dot(before, at_a) > 0 && dot(before, at_b) > 0 && held_by->envelope().contains({a, x, y}) &&
         held_by->envelope().contains({b, x, y});
}

void Candidates::edge_swap(Dart e, const Demand& demand, Candidate& best) {
  const auto [low, high] = ends(e);
  if (is_refused_already(Kind::edge_swap, low, high, demand)) return;
  work_.read_ring(e, ring_);
  read_edge_state(ring_);
  const bool surface = edge_.faces.size() == 2;
  // What is swapped in a torus may not be in its tile.
  if (work_.is_edge_copied(e) || edge_.curve || edge_.locked || (!edge_.is_free() && !surface) ||
      ring_.size() > largest_ring || ring_.rim.size() < 3 || (surface && !may_swap_wall(ring_))) {
    note(Kind::edge_swap, low, high, demand);
    return refuse(Kind::edge_swap, Why::held);
  }
  const double before = ring_quality(ring_);
  double limit = std::min(demand.limit(before), best.after);
  double least = std::numeric_limits<double>::infinity();
  std::size_t apex = ring_.rim.size();
  for (std::size_t i = 0; i < ring_.rim.size(); ++i) {
    if (surface && i != edge_.faces[0] && i != edge_.faces[1]) continue;
    if (is_fan_too_long(ring_, i, demand)) continue;
    const double after = fan_quality(ring_, i, limit);
    least = std::min(least, after);
    if (after < limit) limit = after, apex = i;
  }
  if (apex == ring_.rim.size()) {
    if (!(least < demand.limit(before))) note(Kind::edge_swap, low, high, demand);
    return refuse_worse(Kind::edge_swap, least);
  }
  const Dart d = work_.face_at(ring_, apex);
  best = {Kind::edge_swap, d, before, limit, Vec3{}, 0, !ring_.closed, surface};
}

bool Candidates::may_split_held(const Vec3& middle, HeldSplits splits) const {
  const Vec3 &a = point(ring_.a), &b = point(ring_.b);
  if (splits != HeldSplits::exact) return splits == HeldSplits::rounded;
  return collinear(a.data(), middle.data(), b.data()) ||
         (!edge_.curve && edge_.faces.size() == 2 &&
          lies_flat_split_at(a, b, point(ring_.rim[edge_.faces[0]]), point(ring_.rim[edge_.faces[1]]),
                             middle));
}

void Candidates::read_halves(const Ring& ring) {
  const auto seen = [&](Index v) { return work_.seen_from(ring_.a, ring.a, v); };
  const Vec3 &a = point(ring_.a), &b = point(ring_.b);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 x = seen(ring.rim[i]), y = seen(ring.next(i));
    opposite_.push_back({a, y, x});
    opposite_.push_back({b, x, y});
  }
}

// Adds what is around the other copies of the edge. \return the worst quality there
double Candidates::read_copies_of_edge(Dart e) {
  work_.read_copies(e, 1, copies_);
  double worst = 0;
  const EdgeState here = edge_;
  for (std::size_t i = 1; i < copies_.size(); ++i) {
    work_.read_ring(copies_[i], beside_);
    read_edge_state(beside_);
    edge_.locked = edge_.locked || here.locked;
    edge_.faces.insert(edge_.faces.end(), here.faces.begin(), here.faces.end());
    worst = std::max(worst, ring_quality(beside_));
    read_halves(beside_);
  }
  return worst;
}

void Candidates::split(Dart e, const Demand& demand, Candidate& best) {
  const auto [low, high] = ends(e);
  if (is_refused_already(Kind::split, low, high, demand)) return;
  work_.read_ring(e, ring_);
  read_edge_state(ring_);
  const Vec3 &a = point(ring_.a), &b = point(ring_.b);
  const Vec3 middle = (a + b) / 2;  // rounded once
  opposite_.clear();
  read_halves(ring_);
  const double before = std::max(ring_quality(ring_), read_copies_of_edge(e));
  if (edge_.locked) return refuse(Kind::split, Why::held);
  if ((b - a).norm() < 2 * demand.shortest) return refuse(Kind::split, Why::length);
  const bool at_best = edge_.is_free() && copies_.size() == 1 && !demand.in_middle;
  const Vec3 place = at_best ? best_place(middle, opposite_) : middle;
  const double limit = std::min(demand.limit(before), best.after);
  const double after = worst_quality(place, opposite_, limit);
  if (!(after < limit)) {
    if (!(after < demand.limit(before))) note(Kind::split, low, high, demand);
    return refuse_worse(Kind::split, after);
  }
  if (!edge_.is_free() && !may_split_held(middle, demand.held_splits)) return refuse(Kind::split, Why::held);
  std::uint8_t strata = 0;
  if (!edge_.faces.empty()) strata |= Strata::on_face;
  if (edge_.curve) strata |= Strata::on_curve;
  best = {Kind::split, ring_.darts.front(), before, after, place, strata, false, strata != 0};
}

// Which vertices become which: those of the edge, and of its copies. False if the first has other copies.
bool Candidates::read_merging(Dart e) {
  const Mesh& mesh = work_.mesh();
  merging_.clear();
  work_.read_copies(e, 1, copies_);
  for (const Dart copy : copies_)
    merging_.emplace_back(mesh.vertex(copy), mesh.vertex(mesh.reorder(copy, exchange_ends)));
  if (!work_.is_copied(mesh.vertex(e))) return true;
  work_.read_copies(e, 0, copies_);
  return copies_.size() == merging_.size();
}

double Candidates::merged_quality(double limit) const {
  double worst = 0;
  for (const Corners& c : star_) {
    Index b = merging_.front().second;
    if (merging_.size() > 1)
      for (const auto& [from, to] : merging_)
        if (from == c[0]) b = to;
    if (c[1] == b || c[2] == b || c[3] == b) continue;
    worst = std::max(worst, work_.quality_of(Corners{b, c[1], c[2], c[3]}, limit));
    if (worst >= limit) break;
  }
  return worst;
}

void Candidates::collapse(Dart e, const Demand& demand, Candidate& best) {
  Index v[4];
  work_.mesh().vertices(e, v);
  const Index a = v[0], b = v[1];
  if (is_refused_already(Kind::collapse, a, b, demand)) return;
  const bool is_free = work_.strata().is_free(a);
  // A vertex of the surface goes along the surface only, one of a curve along the curve.
  if (!is_free && (work_.strata().is_fixed(a) || (demand.remember && refusals_.knows_held(a)) ||
                   (work_.strata().of(a) & ~work_.strata().of(b) & ~Strata::fixed)))
    return refuse(Kind::collapse, Why::held);
  if (!read_merging(e) || (work_.is_copied(a) && work_.allowed(a, point(b)) != point(b))) {
    note(Kind::collapse, a, b, demand);
    return refuse(Kind::collapse, Why::held);
  }
  read_star_at(e);
  const double before = star_quality_;
  const double limit = std::min(demand.limit(before), best.after);
  const double after = merged_quality(limit);
  if (!(after < limit)) {
    if (!(after < demand.limit(before))) note(Kind::collapse, a, b, demand);
    return refuse_worse(Kind::collapse, after);
  }
  for (const Corners& c : star_)
    for (std::size_t i = 1; i < 4; ++i)
      if (demand.is_too_long(work_.seen_from(a, c[0], c[i]), point(b)))
        return refuse(Kind::collapse, Why::length);
  if (!is_free && !(read_place(e, demand) && place_.allows_merging(b))) {
    note(Kind::collapse, a, b, demand);
    return refuse(Kind::collapse, Why::held);
  }
  best = {Kind::collapse, e, before, after, Vec3{}, 0, false, !is_free};
}

// --- faces ---------------------------------------------------------------------------------------------

void Candidates::face_swap(Dart f, const Demand& demand, Candidate& best) {
  const Index t = work_.tet(f);
  Corners c{};
  work_.mesh().vertices(f, c.data());
  if (!is_even(work_.mesh().order(work_.dart(t), f))) std::swap(c[0], c[1]);
  double here = -1;
  face_swap({f, t, c}, here, demand, best);
}

void Candidates::face_swaps(Index t, const Demand& demand, Candidate& best) {
  const Corners of_tet = work_.corners(t);
  const Dart d = work_.dart(t);
  double here = -1;
  for (const Permutation p : faces_around(3, 2, -1)) {
    Corners c{};
    for (std::size_t i = 0; i < 4; ++i) c[i] = of_tet[static_cast<std::size_t>(p[static_cast<int>(i)])];
    if (!is_even(p)) std::swap(c[0], c[1]);
    face_swap({work_.mesh().reorder(d, p), t, c}, here, demand, best);
  }
}

void Candidates::face_swap(const Face& face, double& here, const Demand& demand, Candidate& best) {
  tried(Kind::face_swap);
  const Dart beyond = work_.mesh().switch_dart(face.dart, 3);
  if (beyond == no_dart || work_.strata().is_wall(face.dart) || work_.strata().facet_stays(face.tet))
    return refuse(Kind::face_swap, Why::held);
  Index other[4];
  work_.mesh().vertices(beyond, other);
  const auto [x, y, z, w] = face.corners;
  const Index v = other[3];
  if (here < 0) here = work_.quality_of(face.tet);
  const double before = std::max(here, work_.quality_of(work_.tet(beyond)));
  const double limit = std::min(demand.limit(before), best.after);
  if (demand.is_too_long(point(v), point(w))) return refuse(Kind::face_swap, Why::length);
  double after = 0;
  for (const auto& [p, q] : {std::pair{x, y}, {y, z}, {z, x}}) {
    after = std::max(after, work_.quality_of(Corners{p, q, v, w}, limit));
    if (after >= limit) return refuse_worse(Kind::face_swap, after);
  }
  best = {Kind::face_swap, face.dart, before, after, Vec3{}, 0, false, false};
}

// --- vertices ------------------------------------------------------------------------------------------

void Candidates::read_opposite(Index v) {
  opposite_.clear();
  const auto seen = [&](const Corners& c, std::size_t i) { return work_.seen_from(v, c[0], c[i]); };
  for (const Corners& c : star_) opposite_.push_back({seen(c, 1), seen(c, 2), seen(c, 3)});
}

// Along the axes along which it may move.
Axes Candidates::allowed_axes(Index v) const {
  Axes axes{true, true, true};
  if (!work_.is_copied(v)) return axes;
  const Vec3& p = point(v);
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 x = p;
    x[i] += 1;
    axes[i] = work_.allowed(v, x) == x;
  }
  return axes;
}

// The best place in the tangent plane, and then on what the surface was; or a part of the way.
Vec3 Candidates::place_on_surface(const Vec3& start, Axes axes, double limit) const {
  const Vec3 best = best_place(start, opposite_, axes, 1, place_.normal());
  for (double t = 1; t > 0.1; t /= 2) {
    Vec3 place = place_.envelope()->closest(start + t * (best - start));
    for (std::size_t i = 0; i < 3; ++i)
      if (!axes[i]) place[i] = start[i];
    if (worst_quality(place, opposite_, limit) < limit && place_.allows(place)) return place;
  }
  return start;
}

void Candidates::smoothing(Dart v, const Demand& demand, Candidate& best) {
  const Index a = work_.mesh().vertex(v);
  if (is_refused_already(Kind::smoothing, a, a, demand)) return;
  const bool is_free = work_.strata().is_free(a);
  Axes axes = allowed_axes(a);
  if (!is_free) {
    const Axes held = read_place(v, demand) ? place_.axes() : Axes{};
    for (std::size_t i = 0; i < 3; ++i) axes[i] = axes[i] && held[i];
  }
  if (axes == Axes{}) {
    note(Kind::smoothing, a, a, demand);
    return refuse(Kind::smoothing, Why::held);
  }
  read_star_at(v);
  const double before = star_quality_;
  read_opposite(a);
  const double limit = std::min(demand.limit(before), best.after);
  const bool in_envelope = !is_free && place_.envelope();
  Vec3 place = in_envelope ? place_on_surface(point(a), axes, limit) : best_place(point(a), opposite_, axes);
  double after = worst_quality(place, opposite_, limit);
  if (demand.sharp && !in_envelope && !(after < limit)) {
    constexpr int sharpness = 4;
    place = best_place(place, opposite_, axes, sharpness);
    after = worst_quality(place, opposite_, limit);
  }
  if (!(after < limit)) {
    if (!(after < demand.limit(before))) note(Kind::smoothing, a, a, demand);
    return refuse_worse(Kind::smoothing, after);
  }
  if (!is_free && !place_.allows(place)) return refuse(Kind::smoothing, Why::held);
  for (const Corners& c : star_)
    for (std::size_t i = 1; i < 4; ++i)
      if (demand.is_too_long(work_.seen_from(a, c[0], c[i]), place))
        return refuse(Kind::smoothing, Why::length);
  best = {Kind::smoothing, v, before, after, place, 0, false, !is_free};
}

}  // namespace multimesh::improvement
