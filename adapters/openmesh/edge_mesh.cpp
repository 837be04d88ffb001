// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/edge_mesh.hpp"

#include <string>

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

EdgeMesh::EdgeMesh(OpenMesh::PolyConnectivity& om, Watching edits) : Connectivity(1, om) {
  require_consistent();
  require_proper();
  if (edits == Watching::on) watch();
}

EdgeMesh::EdgeMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om) : Connectivity(1, *om) {
  require_consistent();
  own(std::move(om));
}

Index EdgeMesh::capacity(int k) const {
  return static_cast<Index>(k == 0 ? om_.n_vertices() : om_.n_edges());
}

bool EdgeMesh::is_live(int k, Index s) const {
  return s < capacity(k) && !status(k)[s].deleted();
}

bool EdgeMesh::is_dart(Dart d) const {
  return is_live(1, code(d) >> 1);
}

Index EdgeMesh::simplex(Dart d, int k) const {
  return k == 0 ? static_cast<Index>(from(half(d))) : code(d) >> 1;
}

Dart EdgeMesh::dart_of(int k, Index s) const {
  const int i = static_cast<int>(s);
  if (k == 1) return make(2 * i);
  return out(i) < 0 ? no_dart : make(out(i));
}

Dart EdgeMesh::switch_dart(Dart d, int k) const {
  const int h = half(d);
  if (k == 0) return make(h ^ 1);
  const int other = prev(h) ^ 1;
  return other == h ? no_dart : make(other);
}

void EdgeMesh::vertices(Dart d, Index* v) const {
  v[0] = static_cast<Index>(from(half(d)));
  v[1] = static_cast<Index>(to(half(d)));
}

void EdgeMesh::star(Dart d, int k, DartBuffer& out_darts) const {
  out_darts.assign(1, d);
  if (k > 0) return;
  if (const Dart other = switch_dart(d, 1); other != no_dart) out_darts.push_back(other);
}

bool EdgeMesh::is_boundary(Dart d, int k) const {
  return k == 0 && (prev(half(d)) ^ 1) == half(d);
}

// Dey et al. 1999 in dimension 1: a chain keeps an edge, a loop keeps three.
bool EdgeMesh::link_condition(Dart e) const {
  const int h = half(e), before = prev(h), after = next(h);
  const bool a_ends = before == (h ^ 1), b_ends = after == (h ^ 1);
  if (a_ends || b_ends) return !(a_ends && b_ends);
  return from(before) != to(after) && from(before) != to(h);
}

//   a ===h===> b      becomes      a ===h===> c ===n===> b
void EdgeMesh::split_edge(Dart e, SplitRecord& record) {
  const int h = half(e), o = h ^ 1;
  const int a = from(h), b = to(h);
  const int after = next(h), before_back = prev(o);
  const int c = new_vertex();
  const int n = new_edge(c, b), m = n ^ 1;
  copy_edge_properties(h, n);
  set_to(h, c);
  if (after == o) {  // b is the end of a chain
    set_next(n, m);
  } else {
    set_next(n, after);
    set_next(before_back, m);
  }
  set_next(h, n);
  set_next(m, o);
  if (out(b) == o) set_out(b, m);
  set_out(c, n);

  record.a = static_cast<Index>(a);
  record.b = static_cast<Index>(b);
  record.vertex = static_cast<Index>(c);
  record.at_a = make(h);
  record.facets.assign(1,
                       {static_cast<Index>(h >> 1), static_cast<Index>(h >> 1), static_cast<Index>(n >> 1)});
  record.words.assign({static_cast<std::uint32_t>(h), static_cast<std::uint32_t>(n)});
}

Dart EdgeMesh::after_split(const SplitRecord& record, Dart old, End end) const {
  if (end == End::a) return old;
  if (code(old) == record.words[0]) return Dart{record.words[1]};
  if (code(old) == (record.words[0] ^ 1U)) return Dart{record.words[1] ^ 1U};
  return old;
}

void EdgeMesh::collapse_region(Dart e, CollapseRegion& region) const {
  region.dead.assign(1, e);
  region.renamed.clear();  // the edge before a keeps its halfedges, which now end at b
}

void EdgeMesh::collapse_edge(Dart e, CollapseRecord& record) {
  const int h = half(e), o = h ^ 1;
  const int a = from(h), b = to(h);
  const int before = prev(h), after = next(h), back_after = next(o), back_before = prev(o);
  const bool a_ends = before == o, b_ends = after == o;
  if (a_ends) {
    set_next(back_before, after);
  } else {
    set_to(before, b);
    set_next(before, b_ends ? back_after : after);
    if (!b_ends) set_next(back_before, back_after);
  }
  if (out(b) == o) set_out(b, b_ends ? back_after : after);
  set_out(a, -1);
  kill_vertex(a);
  kill_edge(h >> 1);

  record.dead = static_cast<Index>(a);
  record.survivor = static_cast<Index>(b);
  record.at_survivor = make(out(b));
  record.words.assign(1, static_cast<std::uint32_t>(h >> 1));
}

Dart EdgeMesh::after_collapse(const CollapseRecord& record, Dart old) const {
  return code(old) >> 1 == record.words[0] ? record.at_survivor : old;
}

void EdgeMesh::check(std::vector<std::string>& problems) const {
  const auto report = [&](const char* what, int i, const char* fault) {
    problems.push_back(std::string(what) + " " + std::to_string(i) + ": " + fault);
  };
  const int halfedges = static_cast<int>(om_.n_halfedges());
  const auto live_halfedge = [&](int h) {
    return h >= 0 && h < halfedges && is_live(1, static_cast<Index>(h >> 1));
  };
  std::vector<int> degree(om_.n_vertices(), 0);
  for (int h = 0; h < halfedges; ++h) {
    if (!live_halfedge(h)) continue;
    if (to(h) < 0 || !is_live(0, static_cast<Index>(to(h)))) {
      report("halfedge", h, "points to a dead vertex");
      return;
    }
    ++degree[static_cast<std::size_t>(to(h))];
    if (to(h) == from(h)) report("halfedge", h, "is a loop");
    if (!live_halfedge(next(h)) || !live_halfedge(prev(h))) {
      report("halfedge", h, "has a dead neighbour");
      return;
    }
    if (prev(next(h)) != h || next(prev(h)) != h) report("halfedge", h, "next and prev do not agree");
    if (from(next(h)) != to(h)) report("halfedge", h, "does not meet its successor");
    if (face(h) >= 0) report("halfedge", h, "has a face");
  }
  for (int h = 0; h < halfedges; ++h)
    if (live_halfedge(h) && (next(h) == (h ^ 1)) != (degree[static_cast<std::size_t>(to(h))] == 1))
      report("halfedge", h, "turns round inside a chain, or does not at its end");
  for (int v = 0; v < static_cast<int>(om_.n_vertices()); ++v) {
    if (!is_live(0, static_cast<Index>(v))) continue;
    const int d = degree[static_cast<std::size_t>(v)];
    if (d > 2) report("vertex", v, "has more than two edges; cut the curves there");
    if (d > 0 && (!live_halfedge(out(v)) || from(out(v)) != v))
      report("vertex", v, "and its outgoing halfedge do not agree");
    if (d == 0 && out(v) >= 0) report("vertex", v, "has no edge but an outgoing halfedge");
  }
}

}  // namespace multimesh::openmesh
