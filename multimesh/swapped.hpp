// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "multimesh/coordinates.hpp"
#include "multimesh/dart.hpp"
#include "multimesh/geometry/keeps_side.hpp"

namespace multimesh {

/// The triangles at an inner edge (a, b), and those that replace them in a swap.
struct Swapped {
  Corners<3> left, right, low, high;

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

}  // namespace multimesh
