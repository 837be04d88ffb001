// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/openmesh/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

TriangleMesh::TriangleMesh(OpenMesh::PolyConnectivity& om, Watching edits) : Connectivity(2, om) {
  require_triangles();
  require_consistent();
  require_proper();
  if (edits == Watching::on) watch();
}

TriangleMesh::TriangleMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om) : Connectivity(2, *om) {
  require_consistent();
  own(std::move(om));
}

TriangleMesh::TriangleMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om, Checked) : Connectivity(2, *om) {
#ifndef NDEBUG
  require_consistent();
#endif
  own(std::move(om));
}

void TriangleMesh::require_triangles() const {
  for (const auto f : om_.all_faces())
    if (!om_.status(f).deleted() && om_.valence(f) != 3)
      throw InputError("face " + std::to_string(f.idx()) + " has " + std::to_string(om_.valence(f)) +
                       " corners; triangulate the mesh first (OpenMesh: mesh.triangulate())");
  for (const auto v : om_.all_vertices())
    if (!om_.status(v).deleted() && !om_.is_isolated(v) && !om_.is_manifold(v))
      throw InputError("vertex " + std::to_string(v.idx()) +
                       " joins several fans of faces; cut the mesh there (openmesh::ManifoldCut)");
}

Dart TriangleMesh::edge_dart(OpenMesh::HalfedgeHandle a_to_b) const {
  const int h = a_to_b.idx();
  if (face(h) >= 0) return make(h, 0);
  if (face(h ^ 1) >= 0) return make(h ^ 1, 1);
  return no_dart;
}

// --- simplices and darts -------------------------------------------------------------------------------

Index TriangleMesh::capacity(int k) const {
  return static_cast<Index>(k == 0 ? om_.n_vertices() : k == 1 ? om_.n_edges() : om_.n_faces());
}

bool TriangleMesh::is_live(int k, Index s) const {
  return s < capacity(k) && !status(k)[s].deleted();
}

bool TriangleMesh::is_dart(Dart d) const {
  if (code(d) >= 4 * om_.n_edges()) return false;
  const int h = half(d);
  return !status(1)[static_cast<std::size_t>(h >> 1)].deleted() && face(h) >= 0;
}

Index TriangleMesh::simplex(Dart d, int k) const {
  const int h = half(d);
  return static_cast<Index>(k == 0 ? (flip(d) ? to(h) : from(h)) : k == 1 ? h >> 1 : face(h));
}

// Some dart at a vertex that has faces.
Dart TriangleMesh::dart_at(int v) const {
  const int h = out(v);
  if (h < 0) return no_dart;
  return face(h) >= 0 ? make(h, 0) : make(h ^ 1, 1);
}

Dart TriangleMesh::dart_of(int k, Index s) const {
  const int i = static_cast<int>(s);
  if (k == 0) return dart_at(i);
  if (k == 1) return edge_dart(handle(2 * i));
  return make(halfedge_of(i), 0);
}

Dart TriangleMesh::switch_dart(Dart d, int k) const {
  const int h = half(d);
  if (k == 0) return make(h, flip(d) ^ 1U);
  if (k == 1) return flip(d) ? make(next(h), 0) : make(prev(h), 1);
  return face(h ^ 1) < 0 ? no_dart : make(h ^ 1, flip(d) ^ 1U);
}

namespace {

// S3 in terms of halfedges: how many times `next` (for flip 0; `prev` for flip 1), and whether flip changes.
struct Turn {
  int steps;
  unsigned flip;
};

constexpr std::array<Turn, 6> make_turns() {
  std::array<Turn, 6> turns{};
  turns[permutation(0, 1, 2).code] = {0, 0};
  turns[permutation(1, 0, 2).code] = {0, 1};
  turns[permutation(1, 2, 0).code] = {1, 0};
  turns[permutation(2, 1, 0).code] = {1, 1};
  turns[permutation(2, 0, 1).code] = {2, 0};
  turns[permutation(0, 2, 1).code] = {2, 1};
  return turns;
}
constexpr auto turns = make_turns();

constexpr std::array<std::array<Permutation, 2>, 3> make_orders() {
  std::array<std::array<Permutation, 2>, 3> orders{};
  for (std::uint8_t c = 0; c < 6; ++c) orders[static_cast<std::size_t>(turns[c].steps)][turns[c].flip] = {c};
  return orders;
}
constexpr auto orders = make_orders();

}  // namespace

Dart TriangleMesh::reorder(Dart d, Permutation p) const {
  const Turn turn = turns[p.code];
  const int h = half(d);
  const int steps = turn.steps == 0 ? 0 : flip(d) ? 3 - turn.steps : turn.steps;
  return make(steps == 0 ? h : steps == 1 ? next(h) : prev(h), flip(d) ^ turn.flip);
}

Permutation TriangleMesh::order(Dart from, Dart to) const {
  const int h = half(from), g = half(to);
  const unsigned flipped = flip(from) ^ flip(to);
  if (h == g) return orders[0][flipped];
  const bool is_next = next(h) == g;
  return orders[is_next != (flip(from) == 1) ? 1 : 2][flipped];
}

void TriangleMesh::vertices(Dart d, Index* v) const {
  const int h = half(d);
  v[0] = static_cast<Index>(from(h));
  v[1] = static_cast<Index>(to(h));
  v[2] = static_cast<Index>(to(next(h)));
  if (flip(d)) std::swap(v[0], v[1]);
}

// --- neighbourhoods ------------------------------------------------------------------------------------

void TriangleMesh::star(Dart d, int k, DartBuffer& out_darts) const {
  out_darts.clear();
  const int h = half(d);
  if (k == 2) {
    out_darts.push_back(d);
  } else if (k == 1) {
    if (face(h) >= 0) out_darts.push_back(d);
    if (face(h ^ 1) >= 0) out_darts.push_back(make(h ^ 1, flip(d) ^ 1U));
  } else {
    const int first = flip(d) ? h ^ 1 : h;  // outgoing
    int o = first;
    do {
      if (face(o) >= 0) out_darts.push_back(make(o, 0));
      o = prev(o) ^ 1;
    } while (o != first);
  }
}

// Around a vertex, halfedge by halfedge; the boundary has an edge more than facets.
bool TriangleMesh::has_link_around(LinkSet links, int j, Dart d, int k) const {
  if (k != 0) return Mesh::has_link_around(links, j, d, k);
  const std::vector<Index>& facet_plus_one = link_column(links);
  const int first = flip(d) ? half(d) ^ 1 : half(d);  // outgoing
  int o = first;
  do {
    const int s = j == 1 ? o >> 1 : face(o);
    if (s >= 0 && facet_plus_one[static_cast<std::size_t>(s)] != 0) return true;
    o = prev(o) ^ 1;
  } while (o != first);
  return false;
}

bool TriangleMesh::is_boundary(Dart d, int k) const {
  if (k == 0) return boundary_vertex(static_cast<int>(simplex(d, 0)));
  return face(half(d)) < 0 || face(half(d) ^ 1) < 0;
}

// Dey et al. 1999 in dimension 2, the boundary coned to w. With x over the common neighbours of a and b:
// each must be the apex of a facet over e; w may be common only if e is in the boundary; edges x-w are
// common if a-x and b-x both are in the boundary; the edge l-r is common in a closed tetrahedron only.
bool TriangleMesh::link_condition(Dart e) const {
  const int h = forward(e), o = h ^ 1;
  const int a = from(h), b = to(h);
  const bool left = face(h) >= 0, right = face(o) >= 0;
  if (left && right && boundary_vertex(a) && boundary_vertex(b)) return false;
  const auto both_sides_open = [&](int ahead, int back) { return face(ahead ^ 1) < 0 && face(back ^ 1) < 0; };
  if (left && both_sides_open(next(h), prev(h))) return false;
  if (right && both_sides_open(next(o), prev(o))) return false;
  return common_neighbours_span_facets(h);
}

bool TriangleMesh::common_neighbours_span_facets(int h) const {
  // Vertices of higher valence than this are rare; their neighbours are searched without the buffer.
  constexpr std::size_t most = 64;
  std::array<int, most> near_b;
  std::size_t valence_b = 0;
  const int a = from(h);
  for (int x = h ^ 1;;) {  // outgoing from b, from b->a on
    if (valence_b < most) near_b[valence_b] = to(x);
    ++valence_b;
    x = prev(x) ^ 1;
    if (x == (h ^ 1)) break;
  }
  std::size_t valence_a = 0, common = 0;
  int x = h;
  do {
    const int v = to(x);
    ++valence_a;
    if (valence_b <= most) {
      common += static_cast<std::size_t>(
          std::count(near_b.begin(), near_b.begin() + static_cast<std::ptrdiff_t>(valence_b), v));
    } else if (v != to(h)) {
      common += find_halfedge(v, to(h)) >= 0;
    }
    x = prev(x) ^ 1;
  } while (x != h);
  const bool left = face(h) >= 0, right = face(h ^ 1) >= 0;
  if (common != static_cast<std::size_t>(left) + static_cast<std::size_t>(right)) return false;
  return !(left && right && valence_a == 3 && valence_b == 3 && !boundary_vertex(a) &&
           !boundary_vertex(to(h)));
}

int TriangleMesh::find_halfedge(int v, int w) const {
  const int first = out(v);
  int x = first;
  do {
    if (to(x) == w) return x;
    x = prev(x) ^ 1;
  } while (x != first);
  return -1;
}

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

// As collapse_edge() will have it: b->l takes the place of a->l, r->b that of r->a.
void TriangleMesh::merge_values(Dart e, const Merging& merging) {
  const int h = forward(e), o = h ^ 1;
  if (face(h) >= 0) merge_sides(next(h), prev(h), to(next(h)), merging);
  if (face(o) >= 0) merge_sides(prev(o), next(o), from(prev(o)), merging);
}

// Edge b-x is kept, a-x dies. Halfedge `kept` takes the place of the opposite of `dying` in a facet that
// survives, or in the boundary, with its values.
void TriangleMesh::merge_sides(int kept, int dying, int x, const Merging& merging) {
  exchange_halfedge_values(kept, dying ^ 1);
  if (merging.keep_b) return;
  unite_edge_flags(kept >> 1, dying >> 1);
  if (merging.wins(static_cast<Index>(x))) exchange_edge_values(kept >> 1, dying >> 1);
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
  // still has.
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

// --- validation --------------------------------------------------------------------------------------------

void TriangleMesh::check(std::vector<std::string>& problems) const {
  const auto report = [&](const char* what, int i, const char* fault) {
    problems.push_back(std::string(what) + " " + std::to_string(i) + ": " + fault);
  };
  const auto live = [&](int k, int i) { return i >= 0 && is_live(k, static_cast<Index>(i)); };
  const int halfedges = static_cast<int>(om_.n_halfedges());
  for (int h = 0; h < halfedges; ++h) {
    if (!live(1, h >> 1)) continue;
    if (!live(0, to(h))) report("halfedge", h, "points to a dead vertex");
    const int n = next(h), p = prev(h);
    if (n < 0 || n >= halfedges || p < 0 || p >= halfedges || !live(1, n >> 1) || !live(1, p >> 1)) {
      report("halfedge", h, "has a dead neighbour");
      return;  // nothing below could be walked
    }
    if (prev(n) != h || next(p) != h) report("halfedge", h, "next and prev do not agree");
    if (from(n) != to(h)) report("halfedge", h, "does not meet its successor");
    if (to(h) == from(h)) report("halfedge", h, "is a loop");
    if (face(h) != face(n)) report("halfedge", h, "and its successor have different faces");
    if (face(h) >= 0 && (!live(2, face(h)) || next(next(n)) != h))
      report("halfedge", h, "has no live triangle");
    if (face(h) < 0 && face(h ^ 1) < 0) report("halfedge", h, "has no face on either side");
  }
  for (int f = 0; f < static_cast<int>(om_.n_faces()); ++f)
    if (live(2, f) && (halfedge_of(f) < 0 || !live(1, halfedge_of(f) >> 1) || face(halfedge_of(f)) != f))
      report("face", f, "and its halfedge do not agree");
  std::vector<int> fan(om_.n_vertices(), 0), boundary(om_.n_vertices(), 0);
  for (int h = 0; h < halfedges; ++h)
    if (live(1, h >> 1) && live(0, from(h))) {
      ++fan[static_cast<std::size_t>(from(h))];
      if (face(h) < 0) ++boundary[static_cast<std::size_t>(from(h))];
    }
  for (int v = 0; v < static_cast<int>(om_.n_vertices()); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (!live(0, v)) continue;
    if (out(v) < 0) {
      if (fan[i] > 0) report("vertex", v, "has edges but no outgoing halfedge");
      continue;
    }
    if (out(v) >= halfedges || !live(1, out(v) >> 1) || from(out(v)) != v) {
      report("vertex", v, "and its outgoing halfedge do not agree");
      continue;
    }
    int around = 0;
    for (int x = out(v);;) {
      ++around;
      x = prev(x) ^ 1;
      if (x == out(v) || around > fan[i]) break;
    }
    if (around != fan[i]) report("vertex", v, "has more than one fan");
    if (boundary[i] > 1) report("vertex", v, "is in the boundary more than once");
    if (boundary[i] == 1 && face(out(v)) >= 0)
      report("vertex", v, "is in the boundary but its halfedge is not");
  }
}

}  // namespace multimesh::openmesh
