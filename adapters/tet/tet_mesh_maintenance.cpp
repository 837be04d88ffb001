// SPDX-License-Identifier: BSD-3-Clause
// Compaction, and validation of the connectivity.
#include <algorithm>
#include <string>
#include <utility>

#include "adapters/tet/codes.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::tet {

namespace {

/// New numbers for the remaining elements, in the same order.
template <class IsLive>
std::vector<Index> numbering(std::size_t n, const IsLive& is_live) {
  std::vector<Index> place(n, no_index);
  Index next = 0;
  for (Index i = 0; i < n; ++i)
    if (is_live(i)) place[i] = next++;
  return place;
}

Index count(const std::vector<Index>& place) {
  return static_cast<Index>(place.size() -
                            static_cast<std::size_t>(std::count(place.begin(), place.end(), no_index)));
}

template <class List>
void move_down(List& list, const std::vector<Index>& place, std::size_t n) {
  for (Index i = 0; i < place.size(); ++i)
    if (place[i] != no_index) list[place[i]] = list[i];
  list.resize(n);
}

}  // namespace

Compaction TetMesh::compact() {
  if (!log_.empty()) throw UsageError("compact with an open journal");
  const auto vertex = numbering(flags_.size(), [&](Index v) { return !(flags_[v] & dead); });
  const auto tet = numbering(tets_.size(), [&](Index t) { return tets_[t].v[0] != no_index; });
  Compaction moved;
  moved.simplices.resize(4);
  for (const int k : {1, 2}) {
    auto& names = moved.simplices[static_cast<std::size_t>(k)];
    names.assign(capacity(k), no_index);
    const Index each = k == 1 ? 6 : 4;
    for (Index s = 0; s < names.size(); ++s)  // the order is kept, and with it the lowest tetrahedron of each
      if (is_live(k, s)) names[s] = each * tet[s / each] + s % each;
  }

  const Index vertices = count(vertex), tets = count(tet);
  move_down(tets_, tet, tets);
  for (Tet& t : tets_) {
    for (Index& v : t.v) v = vertex[v];
    for (std::uint32_t& g : t.glue)
      if (g != no_glue) g = tet[g >> 5] << 5 | (g & 31U);
  }
  move_down(flags_, vertex, vertices);
  move_down(vertex_tet_, vertex, vertices);
  for (std::uint32_t& d : vertex_tet_)
    if (d != code(no_dart)) d = tet[d >> 5] << 5 | (d & 31U);
  tet_stamp_.assign(tets, 0);
  vertex_stamp_.assign(vertices, 0);
  tet_search_ = vertex_search_ = 0;
  if (has_anchors_) move_down(anchors_, tet, tets);
  for (const auto& p : vertex_properties_) p->compact(vertex, vertices);
  for (const auto& p : tet_properties_) p->compact(tet, tets);
  for (const auto& p : simplex_properties_) {
    const std::vector<Index> numbers = p->compact();
    p->table().renumber(vertex, vertices, &numbers);
  }
  for (Links& l : links_) {
    if (!l.used) continue;
    if (l.table) {
      l.table->renumber(vertex, vertices, nullptr);
    } else {
      l.k == 0 ? move_down(l.facet_plus_one, vertex, vertices) : move_down(l.facet_plus_one, tet, tets);
    }
  }
  free_tets_.clear();
  free_vertices_.clear();
  moved.simplices[0] = vertex;
  moved.blocks = tet;
  moved.simplices[3] = tet;
  moved.block_bits = 5;
  return moved;
}

// The link of a vertex, a surface without pinches if the edges have single rings, must be a sphere or a disk:
// of connected surfaces only these have the Euler characteristic 2 without boundary, and 1 with one.
const char* TetMesh::star_fault(Index v, Index tets_around) const {
  vertex_star(vertex_tet_[v], star_);
  if (star_.size() != tets_around) return "joins parts that share no face there";
  const std::uint32_t search = next_search(vertex_stamp_, vertex_search_, 1);
  long vertices = 0, rim = 0;
  for (const std::uint32_t t : star_)
    for (int i = 1; i < 4; ++i) {
      std::uint32_t& stamp = vertex_stamp_[at(t, i)];
      vertices += std::exchange(stamp, search) != search;
      rim += across(t, i) == no_glue;
    }
  const auto triangles = static_cast<long>(star_.size());
  const long euler = vertices - (3 * triangles + rim) / 2 + triangles;
  return euler == (rim > 0 ? 1 : 2) ? nullptr : "has a link that is neither a sphere nor a disk";
}

void TetMesh::check(std::vector<std::string>& problems) const {
  const auto report = [&](const char* what, Index i, const std::string& fault) {
    problems.push_back(std::string(what) + " " + std::to_string(i) + ": " + fault);
  };
  const auto live_tet = [&](Index t) { return t < tets_.size() && tets_[t].v[0] != no_index; };
  std::vector<Index> around(flags_.size(), 0);
  std::vector<bool> rim(flags_.size(), false);
  const std::size_t before = problems.size();
  for (Index t = 0; t < tets_.size(); ++t) {
    if (!live_tet(t)) continue;
    const Tet& here = tets_[t];
    for (std::size_t i = 0; i < 4; ++i) {
      const Index v = here.v[i];
      if (v >= flags_.size() || (flags_[v] & dead)) {
        report("tetrahedron", t, "has a dead vertex");
        return;
      }
      for (std::size_t j = 0; j < i; ++j)
        if (here.v[j] == v) report("tetrahedron", t, "has a vertex twice");
      ++around[v];
    }
    for (std::size_t f = 0; f < 4; ++f) {
      const std::uint32_t g = here.glue[f];
      if (g == no_glue) {
        for (std::size_t i = 0; i < 4; ++i)
          if (i != f) rim[here.v[i]] = true;
        continue;
      }
      if ((g & 31U) >= 24 || !live_tet(g >> 5) || g >> 5 == t) {
        report("tetrahedron", t, "has a dead neighbour");
        return;
      }
      const Permutation q{static_cast<std::uint8_t>(g & 31U)};
      const Tet& there = tets_[g >> 5];
      const std::uint32_t back = there.glue[q[static_cast<int>(f)]];
      if (back == no_glue || back >> 5 != t || (back & 31U) != inverse_code[g & 31U])
        report("tetrahedron", t, "is not the neighbour of its neighbour");
      if (is_even(q)) report("tetrahedron", t, "is oriented against its neighbour");
      for (std::size_t i = 0; i < 4; ++i)
        if ((here.v[i] == there.v[q[static_cast<int>(i)]]) != (i != f))
          report("tetrahedron", t, "and its neighbour do not share the face between them");
    }
  }
  if (problems.size() > before) return;  // stars could not be traversed
  for (Index v = 0; v < flags_.size(); ++v) {
    const std::uint32_t d = vertex_tet_[v];
    if (flags_[v] & dead) continue;
    if (d == code(no_dart)) {
      if (around[v] > 0) report("vertex", v, "does not know its tetrahedra");
      continue;
    }
    if (!is_dart(Dart{d}) || at(d, 0) != v) {
      report("vertex", v, "is not in the tetrahedron that it names");
      continue;
    }
    if (const char* fault = star_fault(v, around[v])) report("vertex", v, fault);
    if (rim[v] != bool(flags_[v] & in_boundary)) report("vertex", v, "is wrong about being in the boundary");
  }
  const auto free_is_right = [&](const std::vector<Index>& list, std::size_t slots, const auto& is_dead) {
    std::vector<bool> seen(slots, false);
    for (const Index i : list) {
      if (i >= slots || seen[i] || !is_dead(i)) return false;
      seen[i] = true;
    }
    for (Index i = 0; i < slots; ++i)
      if (!seen[i] && is_dead(i)) return false;
    return true;
  };
  const auto both = [](std::vector<Index> list, const std::vector<Index>& more) {
    list.insert(list.end(), more.begin(), more.end());
    return list;
  };
  if (!free_is_right(both(free_tets_, freed_tets_), tets_.size(), [&](Index t) { return !live_tet(t); }))
    problems.push_back("the list of free tetrahedra is not that of the dead ones");
  if (!free_is_right(both(free_vertices_, freed_vertices_), flags_.size(),
                     [&](Index v) { return bool(flags_[v] & dead); }))
    problems.push_back("the list of free vertices is not that of the dead ones");
}

}  // namespace multimesh::tet
