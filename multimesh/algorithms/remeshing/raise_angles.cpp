// SPDX-License-Identifier: BSD-3-Clause
// The last pass: makes small angles larger, by swaps, collapses and moves that consider only the shape.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh::remeshing {

namespace {

/// Angles from here on do not count as small.
constexpr double small_angle = 44 * std::numbers::pi / 180;
/// Of an equilateral triangle.
constexpr double best_angle = std::numbers::pi / 3;
/// The pass is repeated until it finds nothing more to do, at most this often.
constexpr int most_repeats = 3;
/// Steps that are tried, relative to the requested length: each half the previous one.
constexpr std::array steps{0.2, 0.1, 0.05, 0.025, 0.0125};
/// The number of better places that are tried.
constexpr std::size_t most_tries = 8;

const std::array<Permutation, 3> sides{Permutation{}, edge_ax, edge_bx};

/// What is wrong with some triangles and edges.
struct Lack {
  double least = best_angle;  ///< of the angles
  double angles = 0;          ///< of all triangles, squared
  int lengths = 0;            ///< edges out of range

  void add(double angle) {
    const double missing = best_angle - angle;
    least = std::min(least, angle);
    angles += missing * missing;
  }
  void add_edge(double share) { lengths += share < shortest_share || share > longest_share; }
  bool is_less_than(const Lack& x) const {
    return angles < 0.99 * x.angles && least >= x.least && lengths <= x.lengths;
  }
};

/// The neighbourhood of a vertex that is moved, before the move.
class Around {
 public:
  Around(const Mesh& mesh, const Coordinates& at, const DartBuffer& star, double length) : length_(length) {
    for (const Dart t : star) {
      std::array<Index, 4> v{};
      mesh.vertices(t, v.data());
      opposite_.emplace_back(at.at(v[1]), at.at(v[2]));
    }
  }
  /// After a move to p. Triangles that have p as a corner vanish.
  Lack lack(const Vec3& p) const {
    Lack sum;
    for (const auto& [x, y] : opposite_) {
      if (x == p || y == p) continue;
      sum.add(least_angle(p, x, y));
      sum.add_edge((x - p).norm() / length_), sum.add_edge((y - p).norm() / length_);
    }
    return sum;
  }

 private:
  double length_;
  std::vector<std::pair<Vec3, Vec3>> opposite_;
};

/// Directions in which a vertex may move.
std::vector<Vec3> directions(Vec3 normal) {
  normal /= normal.norm();
  const Vec3 axis = std::abs(normal[0]) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = cross(normal, axis).normalized(), v = cross(normal, u);
  const Vec3 s = (u + v) * std::sqrt(0.5), t = (u - v) * std::sqrt(0.5);
  return {u, s, v, -t, -u, -s, -v, t};
}

}  // namespace

void Remesher::raise_least_angles() {
  for (int i = 0; i < most_repeats; ++i) {
    std::size_t raised = 0;
    WorkQueue faces;
    queue_small_angles(faces);
    for (WorkQueue::Entry next; faces.pop(next);) {
      if (!mesh_.is_live(2, next.simplex)) continue;
      const Dart d = mesh_.dart_of(2, next.simplex);
      const bool better = raise_angle(d);
      raised += better;
      if (!better) refused_.note(question(Question::raise_face, next.simplex), stamp(d));
    }
    if (raised == 0) return;
  }
}

double Remesher::least_angle_of(Dart triangle) const {
  std::array<Index, 4> v{};
  mesh_.vertices(triangle, v.data());
  return least_angle(positions_.at(v[0]), positions_.at(v[1]), positions_.at(v[2]));
}

StarStamps::Stamp Remesher::stamp(Dart triangle) const {
  std::array<Index, 4> v{};
  mesh_.vertices(triangle, v.data());
  return stars_.latest(std::span(v).first(3));
}

// The smallest ones first.
void Remesher::queue_small_angles(WorkQueue& faces) const {
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    const Dart d = mesh_.dart_of(2, f);
    const double a = least_angle_of(d);
    if (a < small_angle && !refused_.knows(question(Question::raise_face, f), stamp(d))) faces.push(f, a);
  }
}

bool Remesher::raise_angle(Dart triangle) {
  if (least_angle_of(triangle) >= small_angle) return false;
  std::array<Index, 3> edges{};
  std::transform(sides.begin(), sides.end(), edges.begin(),
                 [&](const Permutation& side) { return mesh_.simplex(mesh_.reorder(triangle, side), 1); });
  std::array<Index, 4> corners{};
  mesh_.vertices(triangle, corners.data());
  for (const Index e : edges)
    if (swap_to_raise_angles(mesh_.dart_of(1, e)) || collapse_to_raise_angles(mesh_.dart_of(1, e)))
      return true;
  bool moved = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t move = question(Question::raise_vertex, corners[i]);
    if (refused_.knows(move, stars_.of(corners[i]))) continue;
    const bool helped = move_to_raise_angles(mesh_.dart_of(0, corners[i]));
    if (!helped) refused_.note(move, stars_.of(corners[i]));
    moved = helped || moved;
  }
  return moved;
}

bool Remesher::swap_to_raise_angles(Dart edge) {
  if (!may_be_swapped(edge)) return false;
  const Dart beyond = mesh_.switch_dart(edge, 2);
  const Vec3 a = at(edge), b = at(mesh_.reorder(edge, exchange_ends)),
             l = at(mesh_.reorder(edge, permutation(2, 0, 1))),
             r = at(mesh_.reorder(beyond, permutation(2, 0, 1)));
  Lack now, then;
  now.add(least_angle(a, b, l)), now.add(least_angle(a, b, r));
  now.add_edge((a - b).norm() / options_.length);
  then.add(least_angle(a, r, l)), then.add(least_angle(b, r, l));
  then.add_edge((l - r).norm() / options_.length);
  if (!then.is_less_than(now) || !swap_guarded(edge)) return false;
  ++result_.swaps;
  return true;
}

bool Remesher::collapse_to_raise_angles(Dart edge) {
  if (length(edge) >= shortest_share * options_.length || is_frozen(edge)) return false;
  for (const Dart d : {edge, mesh_.reorder(edge, exchange_ends)}) {
    if (!may_be_removed(d)) continue;
    mesh_.star(d, 0, star_);
    const Around around(mesh_, positions_, star_, options_.length);
    if (!around.lack(at(mesh_.reorder(d, exchange_ends))).is_less_than(around.lack(at(d)))) continue;
    if (collapse_guarded(d)) return true;
  }
  return false;
}

/// Where a vertex may move on its surface or curve, by one step.
std::vector<Vec3> Remesher::near_places(Dart vertex, Freedom freedom, const std::array<Dart, 2>& line,
                                        const Vec3& normal) const {
  std::vector<Vec3> ways, places;
  if (freedom == Freedom::surface) ways = directions(normal);
  if (freedom == Freedom::line)
    for (const Dart e : line) ways.push_back((at(mesh_.reorder(e, exchange_ends)) - at(vertex)).normalized());
  for (const double step : steps)
    for (const Vec3& way : ways) places.push_back(at(vertex) + way * (step * options_.length));
  return places;
}

// Tries the places with the least lack first: projects them onto the input, with everything below.
bool Remesher::move_to_raise_angles(Dart vertex) {
  std::array<Dart, 2> line{};
  const Freedom free = freedom(vertex, line);
  Vec3 normal;
  (void)centre(vertex, normal);
  if (free == Freedom::none || !(normal.squared_norm() > 0)) return false;
  const Around around(mesh_, positions_, star_, options_.length);
  const Vec3 here = at(vertex);
  const Lack now = around.lack(here);
  std::vector<std::pair<double, Vec3>> better;
  for (const Vec3& p : near_places(vertex, free, line, normal))
    if (const Lack then = around.lack(p); then.is_less_than(now)) better.emplace_back(then.angles, p);
  std::sort(better.begin(), better.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  if (better.size() > most_tries) better.resize(most_tries);
  for (const auto& [angles, p] : better) {
    const auto to = place(vertex, free, line, {p, (p - here).norm()}, normal);
    if (!to || !around.lack(to->position).is_less_than(now) || !move(vertex, *to)) continue;
    ++result_.moves;
    return true;
  }
  return false;
}

}  // namespace multimesh::remeshing
