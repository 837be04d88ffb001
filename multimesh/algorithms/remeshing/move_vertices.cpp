// SPDX-License-Identifier: BSD-3-Clause
// Tangential smoothing, and the way back to the input.
#include <algorithm>
#include <limits>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh::remeshing {

void Remesher::smooth() {
  placed_.resize(mesh_.capacity(0), false);
  for (Index v = 0; v < mesh_.capacity(0); ++v)
    if (mesh_.is_live(0, v))
      if (const Dart d = mesh_.dart_of(0, v); d != no_dart) smooth(d);
}

/// Of the triangles around a vertex, weighted by area; their normal, weighted too.
Vec3 Remesher::centre(Dart vertex, Vec3& normal) {
  mesh_.star(vertex, 0, star_);
  Vec3 sum(0, 0, 0);
  double area = 0;
  normal = Vec3(0, 0, 0);
  for (const Dart t : star_) {
    std::array<Index, 4> v{};
    mesh_.vertices(t, v.data());
    const Vec3 p = positions_.at(v[0]), q = positions_.at(v[1]), r = positions_.at(v[2]);
    const Vec3 n = cross(q - p, r - p);
    const double a = n.norm();
    sum += (p + q + r) * (a / 3);
    area += a;
    normal += n;
  }
  return area > 0 ? sum / area : at(vertex);
}

void Remesher::smooth(Dart vertex) {
  const std::uint64_t here = question(Question::smooth, mesh_.vertex(vertex));
  if (refused_.knows(here, stars_.of(mesh_.vertex(vertex)))) return;
  if (!move_to_centre(vertex)) refused_.note(here, stars_.of(mesh_.vertex(vertex)));
}

bool Remesher::move_to_centre(Dart vertex) {
  std::array<Dart, 2> line{};
  const Freedom free = freedom(vertex, line);
  if (free == Freedom::none) return false;
  const Vec3 here = at(vertex);
  Vec3 step, normal(0, 0, 0);
  if (free == Freedom::line) {
    step = (at(mesh_.reorder(line[0], exchange_ends)) + at(mesh_.reorder(line[1], exchange_ends))) / 2 - here;
  } else {
    step = centre(vertex, normal) - here;
    if (normal.squared_norm() > 0) step -= normal * (dot(step, normal) / normal.squared_norm());
  }
  const Index v = mesh_.vertex(vertex);
  if (placed_[v] && step.norm() < smallest_move_) return false;
  for (const double share : {1.0, 0.5, 0.25, 0.0})  // the last one: at least onto the input
    if (const auto to = place(vertex, free, line, {here + step * share, share * step.norm()}, normal);
        to && move(vertex, *to)) {
      ++result_.moves;
      placed_[v] = true;
      return true;
    }
  return false;
}

std::optional<Place> Remesher::place(Dart vertex, Freedom freedom, const std::array<Dart, 2>& line,
                                     const Wanted& wanted, const Vec3& normal) const {
  if (freedom == Freedom::none) return std::nullopt;
  const double expected = wanted.from_input + smallest_move_;
  if (freedom == Freedom::line)
    return reference_.on_line(line_[mesh_.simplex(line[0], 1)], wanted.at, expected);
  return reference_.on_patch(patch_[mesh_.facet(vertex)], wanted.at, normal, expected);
}

// Each copy of the vertex in a mesh below gets one of the coordinates there: on a line, those of its own
// side, which are the nearest ones.
bool Remesher::assign(const Place& to) {
  writes_.clear();
  for (std::size_t m = 0; m < below_.size(); ++m) {
    std::vector<Vec3> free;
    for (const auto& b : to.below)
      if (b.mesh == m) free.push_back(b.at);
    const std::span<const Copy> copies = copies_.of(below_[m]->node());
    if (copies.size() != free.size()) return false;
    const auto now = [&](const Copy& c) { return below_[m]->at(tree_.mesh(c.node).vertex(c.dart)); };
    if (copies.size() == 2) {
      const double straight =
          (now(copies[0]) - free[0]).squared_norm() + (now(copies[1]) - free[1]).squared_norm();
      const double crossed =
          (now(copies[0]) - free[1]).squared_norm() + (now(copies[1]) - free[0]).squared_norm();
      if (crossed < straight) std::swap(free[0], free[1]);
    }
    for (std::size_t i = 0; i < copies.size(); ++i) writes_.push_back({m, copies[i].dart, free[i]});
  }
  return true;
}

bool Remesher::move(Dart vertex, const Place& to) {
  copies_.collect(tree_, node_, vertex, 0);
  if (!assign(to)) return false;
  // Where an interface lies in a flat side of a tile, and bends out of it, the input leads out of it.
  const Vec3 position = positions_.allowed(mesh_.vertex(vertex), to.position);
  for (const Copy& c : copies_.of(node_)) {
    const Vec3 there = positions_.place_of_copy(mesh_.vertex(c.dart), mesh_.vertex(vertex), position);
    if (!shape_.allows(c.dart, there)) return false;
  }
  for (const Write& w : writes_)
    if (!sides_below_[w.mesh]->allows(tree_.mesh(below_[w.mesh]->node()), w.dart, w.at)) return false;
  const auto write = [&](const Event&) {
    positions_.set(mesh_.vertex(vertex), position);
    for (const Write& w : writes_) {
      Coordinates& c = *below_[w.mesh];
      c.set(tree_.mesh(c.node()).vertex(w.dart), w.at);
    }
  };
  read_stars(copies_, 0, changing_);
  return static_cast<bool>(guarded([&] { return operations_.relocate(node_, vertex, write); }));
}

}  // namespace multimesh::remeshing
