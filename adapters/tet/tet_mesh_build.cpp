// SPDX-License-Identifier: BSD-3-Clause
// Construction from a list of tetrahedra.
#include <algorithm>
#include <string>

#include "adapters/tet/codes.hpp"
#include "adapters/tet/tet_mesh.hpp"

namespace multimesh::tet {

namespace {

constexpr const char* remedy = "; cut the mesh first (multimesh::cut)";

std::string name(Index t) {
  return "tetrahedron " + std::to_string(t);
}

/// The corners of face f of a tetrahedron in ascending order of their vertices.
std::array<std::uint8_t, 3> sorted_face(const Index* v, unsigned f) {
  std::array<std::uint8_t, 3> c{};
  for (std::uint8_t i = 0, n = 0; i < 4; ++i)
    if (i != f) c[n++] = i;
  if (v[c[0]] > v[c[1]]) std::swap(c[0], c[1]);
  if (v[c[1]] > v[c[2]]) std::swap(c[1], c[2]);
  if (v[c[0]] > v[c[1]]) std::swap(c[0], c[1]);
  return c;
}

}  // namespace

TetMesh::TetMesh(const FacetList& tets) : Mesh(3) {
  if (tets.dimension != 3)
    throw UsageError("a tetrahedral mesh was given facets of dimension " + std::to_string(tets.dimension));
  if (tets.size() > most_tets)
    throw InputError(std::to_string(tets.size()) + " tetrahedra; at most 2^27 fit in one mesh");
  resize_vertices(tets.vertices);
  resize_tets(tets.size());
  for (Index t = 0; t < tets_.size(); ++t) {
    const auto v = tets.facet(t);
    for (std::size_t i = 0; i < 4; ++i) {
      if (v[i] >= tets.vertices)
        throw InputError(name(t) + " names vertex " + std::to_string(v[i]) + " of " +
                         std::to_string(tets.vertices));
      for (std::size_t j = 0; j < i; ++j)
        if (v[i] == v[j])
          throw InputError(name(t) + " has vertex " + std::to_string(v[i]) + " twice; remove it");
      tets_[t].v[i] = v[i];
      tets_[t].glue[i] = no_glue;
    }
  }
  glue_faces();
  name_vertices();
  refuse_singular_vertices();
}

// Faces are sorted into buckets by their least vertex; in a bucket, by the other two.
void TetMesh::glue_faces() {
  struct Side {
    Index second, third;
    std::uint32_t code;  // 4 t + f
  };
  std::vector<Index> begin(flags_.size() + 1, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (Index t = 0; t < tets_.size(); ++t)
      for (unsigned f = 0; f < 4; ++f) visit(t, f, sorted_face(tets_[t].v, f));
  };
  for_each_side([&](Index t, unsigned, const auto& c) { ++begin[tets_[t].v[c[0]] + 1]; });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Side> sides(4 * tets_.size());
  std::vector<Index> end(begin.begin(), begin.end() - 1);
  for_each_side([&](Index t, unsigned f, const auto& c) {
    const Index* v = tets_[t].v;
    sides[end[v[c[0]]]++] = {v[c[1]], v[c[2]], 4 * t + f};
  });
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    const auto first = sides.begin() + begin[v], last = sides.begin() + begin[v + 1];
    std::sort(first, last, [](const Side& x, const Side& y) {
      return std::array{x.second, x.third, x.code} < std::array{y.second, y.third, y.code};
    });
    const auto same = [](const Side& x, const Side& y) { return x.second == y.second && x.third == y.third; };
    for (auto s = first; s != last; ++s) {
      if (s + 1 == last || !same(s[0], s[1])) continue;
      if (s + 2 != last && same(s[1], s[2]))
        throw InputError("tetrahedra " + std::to_string(s[0].code / 4) + ", " +
                         std::to_string(s[1].code / 4) + " and " + std::to_string(s[2].code / 4) +
                         " share the face " + std::to_string(v) + "-" + std::to_string(s->second) + "-" +
                         std::to_string(s->third) + remedy);
      glue_pair(s[0].code, s[1].code);
      ++s;
    }
  }
}

void TetMesh::glue_pair(std::uint32_t side, std::uint32_t other) {
  const Index t = side / 4, n = other / 4;
  const unsigned f = side % 4, g = other % 4;
  for (const std::uint32_t known : tets_[t].glue)
    if (known != no_glue && known >> 5 == n)
      throw InputError("tetrahedra " + std::to_string(t) + " and " + std::to_string(n) + " share two faces" +
                       remedy);
  const auto from = sorted_face(tets_[t].v, f), to = sorted_face(tets_[n].v, g);
  int q[4];
  q[f] = static_cast<int>(g);
  for (std::size_t i = 0; i < 3; ++i) q[from[i]] = to[i];
  const Permutation p = permutation(q[0], q[1], q[2], q[3]);
  if (is_even(p))
    throw InputError("tetrahedra " + std::to_string(t) + " and " + std::to_string(n) +
                     " are oriented against each other" + remedy);
  tets_[t].glue[f] = n << 5 | p.code;
  tets_[n].glue[g] = t << 5 | inverse_code[p.code];
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
