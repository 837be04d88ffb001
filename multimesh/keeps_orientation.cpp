// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/keeps_orientation.hpp"

#include <algorithm>
#include <array>

#include "multimesh/geometry/orient3d.hpp"

namespace multimesh {

KeepsOrientation::KeepsOrientation(const Coordinates& positions, const Vec3& normal)
    : Invariant("facets keep their orientation", positions.node()), positions_(positions), normal_(normal) {}

// Of the facet of a dart, with `by` for the place of the vertex `replaced`.
bool KeepsOrientation::is_positive(const Mesh& mesh, Dart facet, Index replaced, const Vec3& by) const {
  const int d = mesh.dimension();
  std::array<Index, 4> v{};
  mesh.vertices(mesh.dart_of(d, mesh.facet(facet)), v.data());
  std::array<Vec3, 4> p{};
  for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i)
    p[i] = v[i] == replaced ? by : positions_.at(v[i]);
  if (d == 2) return orient_against(normal_.data(), p[0].data(), p[1].data(), p[2].data()) > 0;
  return orient3d(p[0].data(), p[1].data(), p[2].data(), p[3].data()) > 0;
}

// The facets around either end, but for those that die, with both ends where the merged vertex goes.
bool KeepsOrientation::before(const Event& event) {
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
      for (const Dart facet : star_) {
        std::array<Index, 4> v{};
        mesh.vertices(facet, v.data());
        if (std::find(v.begin(), v.end(), other) == v.end() && !is_positive(mesh, facet, end, place))
          return false;
      }
    }
  }
  return true;
}

bool KeepsOrientation::after(const Event& event) {
  if (event.operation == Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(node());
  for (const Copy& c : event.copies.of(node())) {
    const bool split = event.operation == Operation::split;
    mesh.star(split ? mesh.reorder(c.dart, exchange_ends) : c.dart, event.operation == Operation::flip,
              star_);
    for (const Dart facet : star_)
      if (!is_positive(mesh, facet, no_index, Vec3(0, 0, 0))) return false;
  }
  return true;
}

}  // namespace multimesh
