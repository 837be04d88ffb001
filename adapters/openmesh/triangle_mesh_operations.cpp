// SPDX-License-Identifier: BSD-3-Clause
// Splits, collapses and flips of a triangle mesh, halfedge by halfedge.
#include "multimesh/openmesh/triangle_mesh.hpp"

namespace multimesh::openmesh {

// --- split -----------------------------------------------------------------------------------------------

// With h: a->b, l and r its apexes: e and the old facets keep the side of b.
//   new: n = a-c, s = c-l with facet (a,c,l), t = c-r with facet (a,r,c).
void TriangleMesh::split_edge(Dart e, SplitRecord& record) {
  const int h = forward(e), o = h ^ 1;
  const int a = from(h), b = to(h);
  const int fl = face(h), fr = face(o);
  const int bl = next(h), la = prev(h), ar = next(o), rb = prev(o);

  const int c = new_vertex();
  const int n = new_edge(a, c), m = n ^ 1;
  copy_edge_properties(h, n);
  set_to(o, c);
  record.facets.clear();
  record.words.clear();
  // Triples for after_split: an old halfedge and what it is in the half at a and at b.
  const auto note = [&](int old, int at_a, int at_b) {
    for (const int w : {old, at_a, at_b}) record.words.push_back(static_cast<std::uint32_t>(w));
  };

  if (fl >= 0) {
    const int s = new_edge(c, to(bl)), f = new_face();
    copy_face_properties(fl, f);
    copy_corner_properties(bl, s), copy_corner_properties(la, s ^ 1);
    set_next(n, s), set_next(s, la), set_next(la, n);
    set_next(h, bl), set_next(bl, s ^ 1), set_next(s ^ 1, h);
    for (const int x : {n, s, la}) set_face(x, f);
    set_face(s ^ 1, fl);
    set_halfedge_of(fl, h);
    set_halfedge_of(f, n);
    record.facets.push_back({static_cast<Index>(fl), static_cast<Index>(f), static_cast<Index>(fl)});
    note(h, n, h), note(bl, s, bl), note(la, la, s ^ 1);
  } else {
    set_next(la, n), set_next(n, h);
    set_face(n, -1);
  }
  if (fr >= 0) {
    const int t = new_edge(c, to(ar)), g = new_face();
    copy_face_properties(fr, g);
    copy_corner_properties(ar, t), copy_corner_properties(rb, t ^ 1);
    set_next(m, ar), set_next(ar, t ^ 1), set_next(t ^ 1, m);
    set_next(o, t), set_next(t, rb), set_next(rb, o);
    for (const int x : {m, ar, t ^ 1}) set_face(x, g);
    set_face(t, fr);
    set_halfedge_of(fr, o);
    set_halfedge_of(g, m);
    record.facets.push_back({static_cast<Index>(fr), static_cast<Index>(g), static_cast<Index>(fr)});
    note(o, m, o), note(ar, ar, t), note(rb, t ^ 1, rb);
  } else {
    set_next(o, m), set_next(m, ar);
    set_face(m, -1);
  }
  set_out(c, fr < 0 ? m : h);
  if (out(a) == h) set_out(a, n);

  record.a = static_cast<Index>(a);
  record.b = static_cast<Index>(b);
  record.vertex = static_cast<Index>(c);
  record.at_a = fl >= 0 ? make(n, 0) : make(m, 1);
}

Dart TriangleMesh::after_split(const SplitRecord& record, Dart old, End end) const {
  const auto h = static_cast<std::uint32_t>(half(old));
  for (std::size_t i = 0; i + 2 < record.words.size(); i += 3)
    if (record.words[i] == h)
      return make(static_cast<int>(record.words[i + (end == End::a ? 1 : 2)]), flip(old));
  return old;
}

// --- collapse --------------------------------------------------------------------------------------------

void TriangleMesh::collapse_region(Dart e, CollapseRegion& region) const {
  region.dead.clear();
  region.renamed.clear();
  const int h = forward(e), o = h ^ 1;
  int outer_left = -1;
  if (face(h) >= 0) {
    region.dead.push_back(make(h, 0));
    const int al = prev(h) ^ 1;
    outer_left = face(al);
    if (outer_left >= 0) region.renamed.push_back(make(al, 0));
  }
  if (face(o) >= 0) {
    region.dead.push_back(make(o, 1));
    const int ra = next(o) ^ 1;
    // Around an a of valence three it is one facet.
    if (face(ra) >= 0 && face(ra) != outer_left) region.renamed.push_back(make(ra, 0));
  }
}

// As collapse_edge() will do it: b->l takes the place of a->l, r->b that of r->a.
void TriangleMesh::merge_values(Dart e, const Merging& merging) {
  const int h = forward(e), o = h ^ 1;
  const Carried carried = what_is_carried();
  if (face(h) >= 0) merge_sides(next(h), prev(h), to(next(h)), carried, merging);
  if (face(o) >= 0) merge_sides(prev(o), next(o), from(prev(o)), carried, merging);
}

// Edge b-x is kept, a-x dies. Halfedge `kept` takes the place of the opposite of `dying` in a facet that
// survives, or in the boundary, with its values.
void TriangleMesh::merge_sides(int kept, int dying, int x, Carried carried, const Merging& merging) {
  if (carried.by_halfedges) exchange_halfedge_values(kept, dying ^ 1);
  if (merging.keep_b) return;
  unite_edge_flags(kept >> 1, dying >> 1);
  if (carried.by_edges && merging.wins(static_cast<Index>(x))) exchange_edge_values(kept >> 1, dying >> 1);
}

// With h: a->b: a, e and the edges a-l, a-r die. Halfedge b->l takes the place of a->l, r->b that of r->a;
// all other surviving halfedges keep their facet. The same as OpenMesh's own collapse.
void TriangleMesh::collapse_edge(Dart e, CollapseRecord& record) {
  const int h = forward(e), o = h ^ 1;
  const int a = from(h), b = to(h);
  const int fl = face(h), fr = face(o);
  const int bl = next(h), la = prev(h), ar = next(o), rb = prev(o);

  // Triples for after_collapse: an old halfedge, the new one, whether the flip changes.
  record.words.clear();
  const auto note = [&](int old, int now, unsigned flipped) {
    for (const std::uint32_t w : {static_cast<std::uint32_t>(old), static_cast<std::uint32_t>(now), flipped})
      record.words.push_back(w);
  };
  if (fl >= 0) {
    const bool beyond_a = face(la ^ 1) >= 0, beyond_b = face(bl ^ 1) >= 0;
    note(la ^ 1, bl, 0);
    beyond_a ? note(la, bl, 1) : note(la, bl ^ 1, 0);
    beyond_b ? note(bl, bl ^ 1, 1) : note(bl, bl, 0);
  }
  if (fr >= 0) {
    const bool beyond_a = face(ar ^ 1) >= 0, beyond_b = face(rb ^ 1) >= 0;
    note(ar ^ 1, rb, 0);
    beyond_a ? note(ar, rb, 1) : note(ar, rb ^ 1, 0);
    beyond_b ? note(rb, rb ^ 1, 1) : note(rb, rb, 0);
  }

  const int b_out = outgoing_after_collapse(h);
  for (int x = next(o) ^ 1; x != o;) {  // incoming to a
    const int following = next(x) ^ 1;
    set_to(x, b);
    x = following;
  }
  set_next(la, bl), set_next(rb, ar);
  kill_vertex(a);
  kill_edge(h >> 1);
  set_out(a, -1);
  if (fl >= 0) close_loop(bl, la);
  if (fr >= 0) close_loop(rb, ar);
  set_out(b, b_out);

  record.dead = static_cast<Index>(a);
  record.survivor = static_cast<Index>(b);
  record.at_survivor = dart_at(b);
  record.words.push_back(static_cast<std::uint32_t>(h >> 1));
}

// Two halfedges of a dead facet form a loop; `kept` takes the place of the opposite of `dying`.
void TriangleMesh::close_loop(int kept, int dying) {
  const int outer = dying ^ 1, f = face(kept), g = face(outer);
  const int tip = to(kept), tail = to(dying);
  set_next(kept, next(outer));
  set_next(prev(outer), kept);
  set_face(kept, g);
  if (g >= 0 && halfedge_of(g) == outer) set_halfedge_of(g, kept);
  for (const int v : {tip, tail}) {
    const int known = out(v);
    if (known == dying || known == outer) set_out(v, v == tail ? kept : kept ^ 1);
  }
  set_halfedge_of(f, -1);
  kill_face(f);
  kill_edge(dying >> 1);
}

// The outgoing halfedge of the merged vertex; by OpenMesh's rule a boundary one if there is any.
int TriangleMesh::outgoing_after_collapse(int h) const {
  const int o = h ^ 1, bl = next(h), al = prev(h) ^ 1, ar = next(o), br = prev(o) ^ 1;
  const bool left = face(h) >= 0, right = face(o) >= 0;
  const int of_b = out(to(h)), of_a = out(from(h));
  const auto renamed = [&](int x) {  // names after the collapse
    if (x == o) x = right ? bl : ar;
    if (x == h || (left && x == al)) return bl;
    if (right && x == ar) return br;
    return x;
  };
  // Before the collapse a halfedge a->l or r->a in the boundary has no face; the one that takes its place
  // still has one.
  if (face(of_b) < 0) return renamed(of_b);
  if (face(of_a) < 0) return renamed(of_a);
  return renamed(of_b);
}

// The last word is the collapsed edge, of which only the merged vertex is left.
Dart TriangleMesh::after_collapse(const CollapseRecord& record, Dart old) const {
  const auto h = static_cast<std::uint32_t>(half(old));
  for (std::size_t i = 0; i + 2 < record.words.size(); i += 3)
    if (record.words[i] == h)
      return make(static_cast<int>(record.words[i + 1]), flip(old) ^ record.words[i + 2]);
  return record.words.back() == h >> 1 ? record.at_survivor : old;
}

// --- flip ------------------------------------------------------------------------------------------------

int TriangleMesh::find_halfedge(int v, int w) const {
  const int first = out(v);
  int x = first;
  do {
    if (to(x) == w) return x;
    x = prev(x) ^ 1;
  } while (x != first);
  return -1;
}

bool TriangleMesh::can_flip(Dart e) const {
  const int h = half(e), o = h ^ 1;
  if (face(h) < 0 || face(o) < 0) return false;
  const int l = to(next(h)), r = to(next(o));
  return l != r && find_halfedge(l, r) < 0;
}

void TriangleMesh::flip_edge(Dart e) {
  const int h = half(e), o = h ^ 1;
  const int fl = face(h), fr = face(o);
  const int bl = next(h), la = prev(h), ar = next(o), rb = prev(o);
  const int a = from(h), b = to(h), l = to(bl), r = to(ar);
  set_to(h, l), set_to(o, r);  // h: r->l
  set_next(h, la), set_next(la, ar), set_next(ar, h);
  set_next(o, rb), set_next(rb, bl), set_next(bl, o);
  set_face(ar, fl), set_face(bl, fr);
  set_halfedge_of(fl, h), set_halfedge_of(fr, o);
  if (out(a) == h) set_out(a, ar);
  if (out(b) == o) set_out(b, bl);
  renew_edge(h, bl, ar);  // l's corner and r's
}

}  // namespace multimesh::openmesh
