// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "multimesh/coordinates.hpp"
#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

/// The positions of the corners of a triangle.
using Corners = std::array<Vec3, 3>;

/// Whether keeps(before, after) holds for all triangles around a vertex, its star, if it moves to `to`.
/// Triangles that contain `without` are left out.
template <class Keeps>
bool keeps_around(const Mesh& mesh, const Coordinates& at, const DartBuffer& star, const Vec3& to,
                  Index without, Keeps keeps) {
  return std::all_of(star.begin(), star.end(), [&](Dart t) {
    std::array<Index, 4> v{};
    mesh.vertices(t, v.data());
    if (v[1] == without || v[2] == without) return true;
    const Vec3 x = at.at(v[1]), y = at.at(v[2]);
    return keeps(Corners{at.at(v[0]), x, y}, Corners{to, x, y});
  });
}

/// The triangles at an inner edge (a, b), and those that replace them in a swap.
struct Swapped {
  Corners left, right, low, high;

  /// `star`: of the edge
  Swapped(const Mesh& mesh, const Coordinates& at, const DartBuffer& star) {
    std::array<Index, 4> v{}, w{};
    mesh.vertices(star[0], v.data());
    mesh.vertices(star[1], w.data());
    const Vec3 a = at.at(v[0]), b = at.at(v[1]), l = at.at(v[2]), r = at.at(w[2]);
    left = {a, b, l}, right = {b, a, r}, low = {a, r, l}, high = {r, b, l};
  }
  /// Whether keeps(before, after) holds for each pair of a triangle before and one after.
  template <class Keeps>
  bool keeps_all(Keeps keeps) const {
    return keeps(left, low) && keeps(left, high) && keeps(right, low) && keeps(right, high);
  }
};

}  // namespace multimesh::remeshing
