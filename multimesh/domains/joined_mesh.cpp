// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/joined_mesh.hpp"

#include <algorithm>
#include <array>

#include "multimesh/faces.hpp"

namespace multimesh {

namespace {

/// An edge or a face at a vertex: its other corners, by vertices and by points.
struct Spoke {
  std::array<Index, 2> points{no_index, no_index};
  std::array<Index, 3> vertices{no_index, no_index, no_index};
  bool has_copies = false;

  auto by_vertices() const { return std::pair(points, vertices); }
};

/// Whether all different spokes that have the same points are known to be copies.
bool are_known(std::vector<Spoke>& spokes) {
  std::sort(spokes.begin(), spokes.end(),
            [](const Spoke& s, const Spoke& t) { return s.by_vertices() < t.by_vertices(); });
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    const Spoke &s = spokes[i - 1], &t = spokes[i];
    if (s.points == t.points && s.vertices != t.vertices && !(s.has_copies && t.has_copies)) return false;
  }
  return true;
}

}  // namespace

KeepsJoinedMesh::KeepsJoinedMesh(const TetDomain& domain)
    : Invariant("joined mesh stays conforming"), domain_(domain) {
  for (Index v = 0; v < domain.mesh().capacity(0); ++v)
    if (domain.mesh().is_live(0, v) && domain.is_copy(v)) copies_[domain.joined_point(v)].push_back(v);
}

bool KeepsJoinedMesh::before(const Event& event) {
  return copies_.empty() || event.operation == Operation::relocate ||
         !domain_.is_copied_edge(event.copies[0].dart);
}

bool KeepsJoinedMesh::after(const Event& event) {
  if (copies_.empty() || event.operation == Operation::relocate) return true;
  const tet::TetMesh& mesh = domain_.mesh();
  Dart at = event.copies[0].dart;
  if (event.operation == Operation::split) at = mesh.reorder(at, exchange_ends);
  mesh.star(at, 0, star_);
  if (!has_copies_near(star_)) return true;
  const Index v = mesh.vertex(at);
  return is_kept_around(domain_.is_copy(v) ? copies_.at(domain_.joined_point(v)) : std::vector{v});
}

bool KeepsJoinedMesh::has_copies_near(const DartBuffer& star) const {
  return std::any_of(star.begin(), star.end(), [&](Dart d) {
    const Index* v = domain_.mesh().corners(tet::TetMesh::tet(d));
    return std::any_of(v, v + 4, [&](Index w) { return domain_.is_copy(w); });
  });
}

bool KeepsJoinedMesh::is_kept_around(const std::vector<Index>& copies) {
  const tet::TetMesh& mesh = domain_.mesh();
  std::vector<Spoke> edges, faces;
  for (const Index copy : copies) {
    mesh.star(mesh.dart_of(0, copy), 0, star_);
    for (const Dart d : star_)
      for (const int k : {1, 2})
        for (const Permutation p : faces_around(3, k, 0)) {
          const Dart simplex = mesh.reorder(d, p);
          Index v[4];
          mesh.vertices(simplex, v);
          if (k == 2 && v[1] > v[2]) std::swap(v[1], v[2]);
          Spoke s;
          s.vertices[0] = copy;
          for (int i = 1; i <= k; ++i) {
            s.points[static_cast<std::size_t>(i - 1)] = domain_.joined_point(v[i]);
            s.vertices[static_cast<std::size_t>(i)] = v[i];
          }
          if (k == 2 && s.points[0] > s.points[1]) std::swap(s.points[0], s.points[1]);
          s.has_copies = k == 1 ? domain_.is_copied_edge(simplex) : domain_.is_parted_face(simplex);
          (k == 1 ? edges : faces).push_back(s);
        }
  }
  // An edge or face with two copies of one point would have no place in the joined mesh.
  const auto is_folded = [&](const Spoke& s) {
    const Index own = domain_.joined_point(s.vertices[0]);
    return s.points[0] == own || s.points[1] == own || s.points[0] == s.points[1];
  };
  return std::none_of(edges.begin(), edges.end(), is_folded) &&
         std::none_of(faces.begin(), faces.end(), is_folded) && are_known(edges) && are_known(faces);
}

}  // namespace multimesh
