// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/triangle_mesh.hpp"

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
  return static_cast<Index>(status(k).size());
}

bool TriangleMesh::is_live(int k, Index s) const {
  const Status& all = status(k);
  return s < all.size() && !all[s].deleted();
}

bool TriangleMesh::is_dart(Dart d) const {
  const std::size_t e = code(d) >> 2;
  const Status& edges = status(1);
  return e < edges.size() && !edges[e].deleted() && face(half(d)) >= 0;
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
      return;  // the walks below would not be possible
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
