// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tet/codes.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::tet {

// Part i of a tetrahedron (x,y,z,w) has m in place of the i-th vertex of the face; part 0 keeps the slot.
// Corners keep their places: the faces between parts i and j are glued by exchanging two corners, and parts
// on both sides of the face as the tetrahedra were.
Dart TetMesh::split_face(Dart f) {
  const std::uint32_t d = code(f);
  const std::uint32_t beyond = across(d, 3);
  const Index m = new_vertex();
  set_flags(m, beyond == no_glue ? in_boundary : 0);
  const Index corners[3] = {at(d, 0), at(d, 1), at(d, 2)};
  divide_value(corners, m);
  FaceParts here = split_side(d, m);
  if (beyond != no_glue) {
    const FaceParts there = split_side(beyond, m);
    for (std::size_t i = 1; i < 3; ++i) {
      tets_[here[i]].glue[local(d, 3)] = there[i] << 5 | (tets_[here[0]].glue[local(d, 3)] & 31U);
      tets_[there[i]].glue[local(beyond, 3)] = here[i] << 5 | (tets_[there[0]].glue[local(beyond, 3)] & 31U);
    }
  }
  set_vertex_tet(m, d);
  set_vertex_tet(corners[0], here[1] << 5 | (d & 31U));
  return f;
}

TetMesh::FaceParts TetMesh::split_side(std::uint32_t d, Index m) {
  const Index old = d >> 5;
  new_tets({d, d}, halves_);
  const FaceParts parts{old, halves_[0], halves_[1]};
  for (std::size_t i = 1; i < 3; ++i) {  // outer faces
    const std::size_t l = local(d, static_cast<int>(i));
    const std::uint32_t outside = tets_[old].glue[l];
    if (outside != no_glue) {
      const auto face = static_cast<std::size_t>(
          Permutation{static_cast<std::uint8_t>(outside & 31U)}[static_cast<int>(l)]);
      set_glue(outside >> 5, face, parts[i] << 5 | inverse_code[outside & 31U]);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t li = local(d, static_cast<int>(i));
    for (std::size_t j = 0; j < 3; ++j) {
      if (j == i) continue;
      const std::size_t lj = local(d, static_cast<int>(j));
      const std::uint32_t glue = parts[j] << 5 | exchange[li][lj];
      if (i == 0)
        set_glue(old, lj, glue);
      else
        tets_[parts[i]].glue[lj] = glue;  // new: nothing in it has to be journaled
    }
    if (i == 0)
      set_corner(old, li, m);
    else
      tets_[parts[i]].v[li] = m;
  }
  return parts;
}

// Links were removed before the split, and are restored after it.
void TetMesh::divide_value(const Index* face, Index m) {
  for_each_table([&](SimplexTable& table) {
    if (table.k() != 2) return;
    const Index number = table.find(face);
    if (number == no_index) return;
    write(table, simplex_key(face, 2), no_index);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index part[3] = {i == 0 ? m : face[0], i == 1 ? m : face[1], i == 2 ? m : face[2]};
      write(table, simplex_key(part, 2), number);
    }
  });
}

}  // namespace multimesh::tet
