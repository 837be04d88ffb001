// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/tets_stay_positive.hpp"

#include <algorithm>
#include <array>

#include "multimesh/geometry/orient3d.hpp"

namespace multimesh {

TetsStayPositive::TetsStayPositive(const Coordinates& positions)
    : Invariant("tetrahedra stay positive", positions.node()), positions_(positions) {}

// Of the tetrahedron of a dart, with `by` for the place of the vertex `replaced`.
bool TetsStayPositive::is_positive(const Mesh& mesh, Dart tet, Index replaced, const Vec3& by) const {
  std::array<Index, 4> v{};
  mesh.vertices(mesh.dart_of(3, mesh.facet(tet)), v.data());
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = v[i] == replaced ? by : positions_.at(v[i]);
  return orient3d(p[0].data(), p[1].data(), p[2].data(), p[3].data()) > 0;
}

// The tetrahedra around either end, but for those that die, with both ends where the merged vertex goes.
bool TetsStayPositive::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  for (std::size_t i = event.copies.first(node());
       i < event.copies.first(node()) + event.copies.count(node()); ++i) {
    const Mesh& mesh = event.tree.mesh(node());
    const Dart at_a = event.copies[i].dart, at_b = mesh.reorder(at_a, exchange_ends);
    const Index a = mesh.vertex(at_a), b = mesh.vertex(at_b);
    const Vec3 place = positions_.merged(event.collapse_of(i));
    for (const auto& [d, end, other] : {std::tuple(at_a, a, b), std::tuple(at_b, b, a)}) {
      if (event.t == (end == a ? 0 : 1)) continue;  // it stays where it is
      mesh.star(d, 0, star_);
      for (const Dart tet : star_) {
        std::array<Index, 4> v{};
        mesh.vertices(tet, v.data());
        if (std::find(v.begin(), v.end(), other) == v.end() && !is_positive(mesh, tet, end, place))
          return false;
      }
    }
  }
  return true;
}

bool TetsStayPositive::after(const Event& event) {
  if (event.operation == Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(node());
  for (const Copy& c : event.copies.of(node())) {
    const bool split = event.operation == Operation::split;
    mesh.star(split ? mesh.reorder(c.dart, exchange_ends) : c.dart, 0, star_);
    for (const Dart tet : star_)
      if (!is_positive(mesh, tet, no_index, Vec3(0, 0, 0))) return false;
  }
  return true;
}

}  // namespace multimesh
