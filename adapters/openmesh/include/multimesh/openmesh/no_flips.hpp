// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "multimesh/attribute.hpp"
#include "multimesh/geometry/orient2d.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh::openmesh {

/// No triangle of a mesh in the plane (a texture) changes its orientation or loses its area in a collapse or
/// a swap, by exact signs. Triangles without area before a collapse are not checked. A split changes
/// orientations only by rounding. `T`: a vector whose first two components are the coordinates. Cost: that of
/// the star.
template <class T>
class NoFlips final : public Invariant {
 public:
  explicit NoFlips(const VertexAttribute<T>& places)
      : Invariant("no flips", places.node()), places_(places) {}

  bool before(const Event& event) override {
    const std::span<const Copy> copies = event.copies.of(node());
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const std::size_t copy = event.copies.first(node()) + i;
      if (event.operation == Operation::collapse &&
          !keeps_signs(event, copies[i].dart, event.collapse_of(copy)))
        return false;
      if (event.operation == Operation::flip && !swaps_signs(event.tree.mesh(node()), copies[i].dart))
        return false;
    }
    return true;
  }

 private:
  using Triangle = std::array<T, 3>;
  static int side(const Triangle& p) {
    double x[3][2];
    for (std::size_t i = 0; i < 3; ++i) x[i][0] = double(p[i][0]), x[i][1] = double(p[i][1]);
    return orient2d(x[0], x[1], x[2]);
  }
  static bool same_side(int before, int after) { return before == 0 || before == after; }

  // Around both ends, except the triangles that die.
  bool keeps_signs(const Event& event, Dart e, const VertexChange& change) {
    const Mesh& mesh = event.tree.mesh(node());
    const T merged = places_.result(Operation::collapse, change);
    for (const Dart end : {e, mesh.reorder(e, exchange_ends)}) {
      mesh.star(end, 0, star_);
      for (const Dart t : star_) {
        std::array<Index, 4> v{};
        mesh.vertices(t, v.data());
        const Index other = v[0] == change.a ? change.b : change.a;
        if (v[1] == other || v[2] == other) continue;
        const Triangle before{places_[v[0]], places_[v[1]], places_[v[2]]};
        if (!same_side(side(before), side({merged, before[1], before[2]}))) return false;
      }
    }
    return true;
  }

  // (a,b,l) and (b,a,r) become (l,r,b) and (r,l,a), in the orientation of (a,b,l).
  bool swaps_signs(const Mesh& mesh, Dart e) {
    mesh.star(e, 1, star_);
    std::array<Index, 4> left{}, right{};
    mesh.vertices(star_[0], left.data());
    mesh.vertices(star_[1], right.data());
    const T &a = places_[left[0]], &b = places_[left[1]], &l = places_[left[2]], &r = places_[right[2]];
    const int before = side({a, b, l});
    return before != 0 && before == side({b, a, r}) && before == side({l, r, b}) && before == side({r, l, a});
  }

  const VertexAttribute<T>& places_;
  DartBuffer star_;
};

}  // namespace multimesh::openmesh
