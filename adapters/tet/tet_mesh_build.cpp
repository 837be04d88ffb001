// SPDX-License-Identifier: BSD-3-Clause
// Construction from a list of tetrahedra.
#include <string>

#include "adapters/tet/codes.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::tet {

namespace {

constexpr const char* remedy = "; cut the mesh first (multimesh::cut)";

}  // namespace

TetMesh::TetMesh(const FacetList& tets) : Mesh(3) {
  if (tets.dimension != 3)
    throw UsageError("a tetrahedral mesh was given facets of dimension " + std::to_string(tets.dimension));
  if (tets.size() > most_tets)
    throw InputError(std::to_string(tets.size()) + " tetrahedra; at most 2^27 fit in one mesh");
  require_corners(tets, [](std::size_t t) { return "tetrahedron " + std::to_string(t); });
  resize_vertices(tets.vertices);
  resize_tets(tets.size());
  for (std::size_t c = 0; c < tets.corners.size(); ++c) {
    tets_[c / 4].v[c % 4] = tets.corners[c];
    tets_[c / 4].glue[c % 4] = no_glue;
  }
  for_each_face(tets, [&](std::span<const Index> sides) {
    if (sides.size() > 2) refuse_third_side(tets, sides);
    if (sides.size() == 2) glue_pair(tets, sides[0], sides[1]);
  });
  name_vertices();
  refuse_singular_vertices();
}

void TetMesh::refuse_third_side(const FacetList& tets, std::span<const Index> sides) {
  const auto vertex_of = [&](Index c) { return tets.corners[c]; };
  const auto c = side_corners(sides[0], vertex_of);
  const auto text = [](Index i) { return std::to_string(i); };
  throw InputError("tetrahedra " + text(sides[0] / 4) + ", " + text(sides[1] / 4) + " and " +
                   text(sides[2] / 4) + " share the face " + text(vertex_of(c[0])) + "-" +
                   text(vertex_of(c[1])) + "-" + text(vertex_of(c[2])) + remedy);
}

void TetMesh::glue_pair(const FacetList& tets, Index side, Index other) {
  const Index t = side / 4, n = other / 4;
  for (const std::uint32_t known : tets_[t].glue)
    if (known != no_glue && known >> 5 == n)
      throw InputError("tetrahedra " + std::to_string(t) + " and " + std::to_string(n) + " share two faces" +
                       remedy);
  const auto vertex_of = [&](Index c) { return tets.corners[c]; };
  const Permutation p =
      across_sides(side, side_corners(side, vertex_of), other, side_corners(other, vertex_of));
  if (is_even(p))
    throw InputError("tetrahedra " + std::to_string(t) + " and " + std::to_string(n) +
                     " are oriented against each other" + remedy);
  tets_[t].glue[side % 4] = n << 5 | p.code;
  tets_[n].glue[other % 4] = t << 5 | inverse_code[p.code];
}

void TetMesh::name_vertices() {
  for (Index t = 0; t < tets_.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      const Index v = tets_[t].v[i];
      if (vertex_tet_[v] == code(no_dart)) vertex_tet_[v] = t << 5 | exchange[0][static_cast<std::size_t>(i)];
      for (int f = 0; f < 4; ++f)
        if (f != i && tets_[t].glue[f] == no_glue) flags_[v] |= in_boundary;
    }
}

void TetMesh::refuse_singular_vertices() const {
  std::vector<Index> around(flags_.size(), 0);
  for (const Tet& t : tets_)
    for (const Index v : t.v) ++around[v];
  for (Index v = 0; v < around.size(); ++v)
    if (const char* fault = around[v] > 0 ? star_fault(v, around[v]) : nullptr)
      throw InputError("vertex " + std::to_string(v) + " " + fault + remedy);
}

}  // namespace multimesh::tet
