// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "multimesh/algorithms/improvement/bounds.hpp"
#include "multimesh/algorithms/improvement/exact_place.hpp"
#include "multimesh/faces.hpp"
#include "multimesh/geometry/tet_shape.hpp"

namespace multimesh::improvement {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Where the corners of a face lie on one line up to rounding, its plane and its angles are an accident of
/// the rounding: they prove nothing about other meshes of the surface.
bool is_thin(const Vec3& a, const Vec3& b, const Vec3& c) {
  return Flatness{.rounded = true}.collinear(a, b, c);
}

}  // namespace

Obstacles::Obstacles(const Workspace& work, SurfaceSplits splits)
    : work_(work), splits_(splits), forced_(work.mesh().capacity(0)) {
  const Mesh& mesh = work.mesh();
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    for (const Permutation p : faces_around(3, 2, -1)) {
      const Dart f = work_.dart(t, p);
      if (!work.strata().is_wall(f) || work.envelope_of(f)) continue;  // what may move forces nothing
      read_face(f);
      for (const Permutation q : {Permutation{}, permutation(1, 2, 0, 3), permutation(2, 0, 1, 3)})
        read_edge(mesh.reorder(f, q));
    }
  }
}

void Obstacles::force(Dart at, const Forced& f) {
  const Index v = work_.mesh().vertex(at);
  if (f.bound > forced_[v].bound) forced_[v] = f;
  if (f.bound > bound_) bound_ = f.bound, place_ = work_.point(v);
}

// The angle from this face to the next one around the edge, through the tetrahedron of the dart.
void Obstacles::read_edge(Dart e) {
  if (work_.is_edge_copied(e) || work_.strata().edge_stays(e)) return;
  work_.read_ring(e, ring_);
  work_.read_walls(ring_, held_faces_);
  const std::vector<std::size_t>& held = held_faces_;
  const auto angle = [&](std::size_t i) {
    return dihedral_angle(work_.point(ring_.a), work_.point(ring_.b), work_.point(ring_.rim[i]),
                          work_.point(ring_.next(i)));
  };
  for (const std::size_t first : held) {
    if (first >= ring_.size() || is_thin_at(first)) continue;
    double sum = angle(first);
    std::size_t last = (first + 1) % ring_.rim.size();
    for (; last < ring_.size() && last != first && std::find(held.begin(), held.end(), last) == held.end();
         last = (last + 1) % ring_.rim.size())
      sum += angle(last);
    if (is_thin_at(last) || std::find(held.begin(), held.end(), last) == held.end()) continue;
    if (work_.envelope_of(work_.face_at(ring_, first)) || work_.envelope_of(work_.face_at(ring_, last)))
      continue;
    const Forced forced{least_amips_at_dihedral(sum), sum * degrees, Force::edge};
    force(e, forced);
    force(work_.mesh().reorder(e, exchange_ends), forced);
  }
}

bool Obstacles::is_thin_at(std::size_t rim) const {
  return is_thin(work_.point(ring_.a), work_.point(ring_.b), work_.point(ring_.rim[rim]));
}

bool Obstacles::is_crease(Dart e) {
  if (work_.strata().is_curve(e)) return true;
  if (work_.is_edge_copied(e) || work_.strata().edge_stays(e)) return false;  // nothing is known of copies
  work_.read_ring(e, ring_);
  work_.read_walls(ring_, held_faces_);
  const std::vector<std::size_t>& held = held_faces_;
  if (held.size() != 2) return true;
  if (is_thin_at(held[0]) || is_thin_at(held[1])) return false;
  return !lies_flat(work_.point(ring_.a), work_.point(ring_.b), work_.point(ring_.rim[held[0]]),
                    work_.point(ring_.rim[held[1]]), work_.flatness());
}

void Obstacles::read_face(Dart f) {
  const Mesh& mesh = work_.mesh();
  constexpr Permutation turns[3] = {Permutation{}, permutation(1, 2, 0, 3), permutation(2, 0, 1, 3)};
  bool crease[3];
  for (int i = 0; i < 3; ++i) crease[i] = is_crease(mesh.reorder(f, turns[i]));  // edge i: from corner i
  Index v[4];
  mesh.vertices(f, v);
  const Vec3 p[3] = {work_.point(v[0]), work_.point(v[1]), work_.point(v[2])};
  if (is_thin(p[0], p[1], p[2])) return;
  for (int i = 0; i < 3; ++i) {
    if (!crease[i] || !crease[(i + 2) % 3]) continue;
    const double angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    force(mesh.reorder(f, turns[i]), {least_amips_at_corner(angle), angle * degrees, Force::corner});
  }
  if (splits_ != SurfaceSplits::none || !crease[0] || !crease[1] || !crease[2]) return;
  for (const Permutation turn : turns)
    force(mesh.reorder(f, turn), {least_amips_over(p[0], p[1], p[2]), 0, Force::triangle});
}

std::string Obstacles::reason_of(Index t, double& bound) const {
  const Corners c = work_.corners(t);
  const Forced* worst = &forced_[c[0]];
  int on_surface = 0;
  for (const Index v : c) {
    if (forced_[v].bound > worst->bound) worst = &forced_[v];
    on_surface += !work_.strata().is_free(v);
  }
  bound = 3;
  // Below this, what the surface forces is no explanation.
  if (worst->bound > 6) {
    bound = worst->bound;
    if (worst->by == Force::edge) return "at an edge where faces of the surface make a small angle";
    if (worst->by == Force::corner) return "at a small angle of a face of the surface";
    return "at a thin face of the surface, which may not be split";
  }
  if (on_surface == 4) return "all four corners are held by the surface";
  if (on_surface == 3) return "three corners are held by the surface";
  if (on_surface > 0) return "some corners are held by the surface";
  return "inside";
}

std::vector<ImproveObstacle> Obstacles::explain(double limit) const {
  std::map<std::string, ImproveObstacle> groups;
  for (Index t = 0; t < work_.mesh().capacity(3); ++t) {
    if (!work_.is_live(t)) continue;
    const double q = work_.quality_of(t);
    if (!(q > limit)) continue;
    double bound;
    const std::string reason =
        work_.strata().facet_stays(t) ? (bound = 3, "in a locked region") : reason_of(t, bound);
    ImproveObstacle& group = groups[reason];
    group.reason = reason;
    ++group.tets;
    group.least_max_amips = std::max(group.least_max_amips, bound);
    if (std::cbrt(q) <= group.max_amips) continue;
    group.max_amips = std::cbrt(q);
    const Corners c = work_.corners(t);
    const Vec3 centre = (work_.point(c[0]) + work_.point(c[1]) + work_.point(c[2]) + work_.point(c[3])) / 4;
    group.example = {centre[0], centre[1], centre[2]};
  }
  std::vector<ImproveObstacle> list;
  for (auto& [reason, group] : groups) list.push_back(std::move(group));
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.tets > y.tets; });
  return list;
}

}  // namespace multimesh::improvement
