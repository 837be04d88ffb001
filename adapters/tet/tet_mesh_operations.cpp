// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "adapters/tet/codes.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::tet {

// --- link condition --------------------------------------------------------------------------------------

// Dey et al. 1999 in dimension 3, the boundary coned to w. Stamps of vertices: `search` for those of Lk a,
// then `search + 1` for those of Lk ab, x0, x1, ...
bool TetMesh::link_condition(Dart e) const {
  const std::uint32_t d = code(e);
  const Index a = at(d, 0), b = at(d, 1);
  Ring& ring = ring_;
  edge_ring(d, ring);
  const bool both_in_boundary = flags_[a] & flags_[b] & in_boundary;
  if (both_in_boundary && ring.closed) return false;  // w

  vertex_star(d, star_);
  const std::uint32_t search = next_search(vertex_stamp_, vertex_search_, 2);
  for (const std::uint32_t t : star_)
    for (int i = 1; i < 4; ++i) vertex_stamp_[at(t, i)] = search - 1;
  for (const Index x : ring.rim) vertex_stamp_[x] = search;
  vertex_stamp_[b] = search - 2;  // in Lk a, but not in Lk b

  const std::uint32_t at_b = (d & ~31U) | product[d & 31U][exchange_ends.code];
  vertex_star(at_b, star_b_);
  for (const std::uint32_t t : star_b_)
    for (int i = 1; i < 4; ++i)
      if (vertex_stamp_[at(t, i)] == search - 1) return false;  // a vertex of both links
  return !link_of_edge_is_common(ring, a, b) && !(both_in_boundary && boundary_link_is_common(ring, a, b));
}

namespace {

bool listed(const std::vector<std::array<Index, 2>>& pairs, Index x, Index y) {
  if (x > y) std::swap(x, y);
  return std::find(pairs.begin(), pairs.end(), std::array<Index, 2>{x, y}) != pairs.end();
}

/// Whether x and y are neighbours on the rim.
bool adjacent(const std::vector<Index>& rim, bool closed, Index x, Index y) {
  const auto i = std::find(rim.begin(), rim.end(), x) - rim.begin();
  const auto j = std::find(rim.begin(), rim.end(), y) - rim.begin();
  const auto steps = i < j ? j - i : i - j;
  return steps == 1 || (closed && steps + 1 == static_cast<std::ptrdiff_t>(rim.size()));
}

}  // namespace

// Whether an edge or a triangle with all its vertices on the rim is in Lk a and in Lk b, but not in Lk ab.
// The rim itself is Lk ab; a triangle can only be one of three rim vertices if they are all.
bool TetMesh::link_of_edge_is_common(const Ring& ring, Index a, Index b) const {
  const std::uint32_t on_rim = vertex_search_;
  pairs_.clear();
  const bool triangle = ring.closed && ring.rim.size() == 3;
  // Calls visit(x, y) for the chords of the rim in the link of the star's vertex; says whether the triangle
  // of a rim of three is in it.
  const auto chords = [&](const std::vector<std::uint32_t>& star, Index other_end, const auto& visit) {
    bool whole = false;
    for (const std::uint32_t t : star) {
      Index x[3];
      int n = 0;
      bool dying = false;
      for (int i = 1; i < 4; ++i) {
        const Index v = at(t, i);
        dying |= v == other_end;
        if (vertex_stamp_[v] == on_rim) x[n++] = v;
      }
      if (dying || n < 2) continue;
      whole |= triangle && n == 3;
      for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j)
          if (!adjacent(ring.rim, ring.closed, x[i], x[j])) visit(std::min(x[i], x[j]), std::max(x[i], x[j]));
    }
    return whole;
  };
  const bool whole_rim_at_a = chords(star_, b, [&](Index x, Index y) { pairs_.push_back({x, y}); });
  bool common = false;
  const bool whole_rim_at_b =
      chords(star_b_, a, [&](Index x, Index y) { common = common || listed(pairs_, x, y); });
  return common || (whole_rim_at_a && whole_rim_at_b);
}

// With a-b in the boundary, w is in all three links. Common edges w-x: only the two ends of the rim may have
// both a-x and b-x in the boundary. Common triangles w-x-y, of which Lk ab has none: a-x-y and b-x-y.
bool TetMesh::boundary_link_is_common(const Ring& ring, Index a, Index b) const {
  const std::uint32_t on_rim = vertex_search_;
  // Edges of the link of the star's vertex in the boundary, with both ends on the rim or one (then twice the
  // same); b is not in Lk b, and its edges in the link of a go to the ends of the rim.
  const auto boundary_link = [&](const std::vector<std::uint32_t>& star, Index other_end, const auto& visit) {
    for (const std::uint32_t t : star)
      for (int i = 1; i < 4; ++i) {
        if (tets_[t >> 5].glue[local(t, i)] != no_glue) continue;
        Index x[2];
        int n = 0;
        bool has_other_end = false;
        for (int j = 1; j < 4; ++j) {
          if (j == i) continue;
          const Index v = at(t, j);
          has_other_end |= v == other_end;
          if (vertex_stamp_[v] == on_rim) x[n++] = v;
        }
        if (has_other_end) continue;
        if (n == 2) visit(std::min(x[0], x[1]), std::max(x[0], x[1]));
        for (int j = 0; j < n; ++j) visit(x[j], x[j]);
      }
  };
  pairs_.clear();
  boundary_link(star_, b, [&](Index x, Index y) { pairs_.push_back({x, y}); });
  bool common = false;
  boundary_link(star_b_, a, [&](Index x, Index y) {
    const bool end = x == y && (x == ring.rim.front() || x == ring.rim.back());
    common = common || (!end && listed(pairs_, x, y));
  });
  return common;
}

// --- split -------------------------------------------------------------------------------------------------

// Each tetrahedron (a,b,x,y) keeps its slot for (a,c,x,y); (c,b,x,y) is new. Corners keep their places, so
// the new half has c where a was and the glue of its old faces around the edge, from new half to new half.
void TetMesh::split_edge(Dart e, SplitRecord& record) {
  const std::uint32_t d = code(e);
  edge_ring(d, ring_);
  const Index a = at(d, 0), b = at(d, 1), c = new_vertex();
  set_flags(c, ring_.closed ? 0 : in_boundary);
  record.facets.clear();
  record.words.clear();
  const std::size_t n = ring_.darts.size();
  // In a large mesh, the neighbours are in no cache: prefetches all of them at once.
  for (const std::uint32_t r : ring_.darts)
    if (const std::uint32_t beyond = tets_[r >> 5].glue[local(r, 0)]; beyond != no_glue)
      __builtin_prefetch(&tets_[beyond >> 5]);
  new_tets(ring_.darts, halves_);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t r = ring_.darts[i];
    const std::size_t la = local(r, 0), lb = local(r, 1);
    const Index old = r >> 5, half = halves_[i];
    Tet& at_b = tets_[half];  // new: nothing in it has to be journaled
    if (const std::uint32_t beyond = at_b.glue[la]; beyond != no_glue) {
      const std::uint8_t q = beyond & 31U;
      const auto face = static_cast<std::size_t>(Permutation{q}[static_cast<int>(la)]);
      set_glue(beyond >> 5, face, half << 5 | inverse_code[q]);
    }
    set_corner(old, lb, c);
    set_glue(old, la, half << 5 | exchange[la][lb]);
    at_b.v[la] = c;
    at_b.glue[lb] = old << 5 | exchange[la][lb];
    // Around the edge: position 3 leads back to the previous one, position 2 to the next.
    for (const int position : {2, 3}) {
      std::uint32_t& g = at_b.glue[local(r, position)];
      if (g == no_glue) continue;
      const std::size_t neighbour = position == 2 ? (i + 1) % n : (i + n - 1) % n;
      g = halves_[neighbour] << 5 | (g & 31U);
    }
    record.facets.push_back({old, old, half});
    record.words.push_back(old);
    record.words.push_back(half);
  }
  const auto backward = [](std::uint32_t r) { return (r & ~31U) | product[r & 31U][exchange_ends.code]; };
  const std::uint32_t first = ring_.darts[0];
  set_vertex_tet(c, backward(first));                            // (c,a,x,y)
  set_vertex_tet(b, backward(halves_[0] << 5 | (first & 31U)));  // (b,c,x,y)
  halve_values(ring_, a, b, c);
  record.a = a;
  record.b = b;
  record.vertex = c;
  record.at_a = e;
}

Dart TetMesh::after_split(const SplitRecord& record, Dart old, End end) const {
  if (end == End::a) return old;
  for (std::size_t i = 0; i + 1 < record.words.size(); i += 2)
    if (record.words[i] == tet(old)) return Dart{record.words[i + 1] << 5 | (code(old) & 31U)};
  return old;
}

// For simplices that contain a and b. Links were removed before the split, and are restored after it.
void TetMesh::halve_values(const Ring& ring, Index a, Index b, Index c) {
  for_each_table([&](SimplexTable& table) {
    if (table.around(a) == 0 || table.around(b) == 0) return;
    const auto halve = [&](Index x) {
      const Index old[3] = {a, b, x}, at_a[3] = {a, c, x}, at_b[3] = {c, b, x};
      const Index number = table.find(old);
      if (number == no_index) return;
      write(table, simplex_key(old, table.k()), no_index);
      write(table, simplex_key(at_a, table.k()), number);
      write(table, simplex_key(at_b, table.k()), number);
    };
    if (table.k() == 1) return halve(no_index);
    for (const Index x : ring.rim) halve(x);
  });
}

// --- collapse --------------------------------------------------------------------------------------------

bool TetMesh::has_values(int k) const {
  return std::any_of(simplex_properties_.begin(), simplex_properties_.end(),
                     [&](const auto& p) { return p->dimension() == k; });
}

// For simplices that both have a value. A value at a only is renamed when a is.
void TetMesh::merge_values(Dart e, const Merging& merging) {
  if (simplex_properties_.empty()) return;
  const Index a = at(code(e), 0), b = at(code(e), 1);
  edge_ring(code(e), ring_);
  for (const auto& p : simplex_properties_) {
    SimplexTable& table = p->table();
    if (table.around(a) == 0) continue;
    const auto merge = [&](Index x, Index y) {
      const Index with_a[3] = {a, x, y}, with_b[3] = {b, x, y};
      const Index of_a = table.find(with_a), of_b = table.find(with_b);
      if (of_a == no_index) return;
      if (merging.keep_b) return write(table, simplex_key(with_a, table.k()), no_index);
      if (of_b == no_index) return;
      const Index now =
          merging.wins(x, y) ? p->merged(of_a, of_b, merging.t) : p->merged(of_b, of_a, 1 - merging.t);
      write(table, simplex_key(with_b, table.k()), now);
    };
    for (std::size_t i = 0; i < ring_.rim.size(); ++i) {
      if (table.k() == 1) merge(ring_.rim[i], no_index);
      if (table.k() == 2 && i < ring_.darts.size())
        merge(ring_.rim[i], ring_.rim[(i + 1) % ring_.rim.size()]);
    }
  }
}

void TetMesh::collapse_region(Dart e, CollapseRegion& region) const {
  star(e, 1, region.dead);
  region.renamed.clear();  // darts of tetrahedra that survive keep their codes
}

void TetMesh::collapse_edge(Dart e, CollapseRecord& record) {
  const std::uint32_t d = code(e);
  const Index a = at(d, 0), b = at(d, 1);
  edge_ring(d, ring_);
  vertex_star(d, star_);
  rename_values(star_, ring_, a, b);
  record.words.clear();
  for (const std::uint32_t r : ring_.darts) join_neighbours(r, record);
  for (const std::uint32_t r : ring_.darts) kill_tet(r >> 5);
  for (const std::uint32_t t : star_)
    if (tets_[t >> 5].v[0] != no_index) set_corner(t >> 5, local(t, 0), b);

  // Vertices whose stored tetrahedron is dying now refer to the one that took its place.
  const auto in_dead = [&](Index v) { return tets_[vertex_tet_[v] >> 5].v[0] == no_index; };
  for (std::size_t i = 0; i < ring_.darts.size(); ++i) {
    const std::uint32_t r = ring_.darts[i];
    const std::uint32_t heir = code(after_collapse(record, Dart{r}));  // (b,.,x,y)
    const auto name = [&](Index v, int position) {
      if (in_dead(v))
        set_vertex_tet(v,
                       (heir & ~31U) | product[heir & 31U][exchange[0][static_cast<std::size_t>(position)]]);
    };
    name(b, 0);
    name(ring_.rim[i], 2);
    name(ring_.rim[(i + 1) % ring_.rim.size()], 3);
  }
  set_flags(b, static_cast<std::uint8_t>(flags_[b] | (flags_[a] & in_boundary)));
  kill_vertex(a);
  record.dead = a;
  record.survivor = b;
  record.at_survivor = Dart{vertex_tet_[b]};
}

// Glues the neighbours beyond the faces without a and without b to each other. Notes for after_collapse: the
// dying tetrahedron, its corners a and b, and its heir: a neighbour with the permutation that takes b's
// corner to the merged vertex and a's corner to the one that the heir does not share.
void TetMesh::join_neighbours(std::uint32_t r, CollapseRecord& record) {
  const Index t = r >> 5;
  const std::size_t la = local(r, 0), lb = local(r, 1);
  const std::uint32_t with_b = tets_[t].glue[la], with_a = tets_[t].glue[lb];
  const auto composed = [](std::uint32_t g, std::uint8_t p) { return product[g & 31U][p]; };
  const auto face = [](std::uint32_t g, std::size_t corner) {
    return static_cast<std::size_t>(
        Permutation{static_cast<std::uint8_t>(g & 31U)}[static_cast<int>(corner)]);
  };
  const auto glue = [&](std::uint32_t one, std::size_t one_face, std::uint32_t other) {
    if (one == no_glue) return;
    set_glue(one >> 5, face(one, one_face),
             other == no_glue
                 ? no_glue
                 : (other & ~31U) | product[composed(other, exchange[la][lb])][inverse_code[one & 31U]]);
  };
  glue(with_b, la, with_a);
  glue(with_a, lb, with_b);
  const std::uint32_t heir =
      with_b != no_glue ? with_b : (with_a & ~31U) | composed(with_a, exchange[la][lb]);
  record.words.insert(record.words.end(), {t, static_cast<std::uint32_t>(la << 2 | lb), heir});
}

Dart TetMesh::after_collapse(const CollapseRecord& record, Dart old) const {
  for (std::size_t i = 0; i + 2 < record.words.size(); i += 3) {
    if (record.words[i] != tet(old)) continue;
    const std::size_t la = record.words[i + 1] >> 2, lb = record.words[i + 1] & 3U;
    const std::uint32_t heir = record.words[i + 2];
    // Whichever of a and b comes first is the merged vertex.
    std::uint8_t p = code(old) & 31U;
    const auto place = [&](std::size_t corner) {
      return Permutation{inverse_code[p]}[static_cast<int>(corner)];
    };
    if (place(la) < place(lb)) p = product[exchange[la][lb]][p];
    return Dart{(heir & ~31U) | product[heir & 31U][p]};
  }
  return old;
}

// Replaces a by b in the simplices with a; those with both lose their numbers. \pre nothing has been written
// yet
void TetMesh::rename_values(const std::vector<std::uint32_t>& star, const Ring& ring, Index a, Index b) {
  for_each_table([&](SimplexTable& table) {
    if (table.around(a) == 0) return;
    const int k = table.k();
    const auto rename = [&](Index x, Index y) {
      const Index old[3] = {a, x, y}, now[3] = {b, x, y};
      const Index number = table.find(old);
      if (number == no_index) return;
      write(table, simplex_key(old, k), no_index);
      if (x != b && y != b && table.find(now) == no_index) write(table, simplex_key(now, k), number);
    };
    if (k == 1) rename(b, no_index);
    for (const Index x : ring.rim)
      if (k == 2) rename(b, x);
    for (const std::uint32_t t : star) {
      const Index x = at(t, 1), y = at(t, 2), z = at(t, 3);
      if (k == 1) {
        rename(x, no_index), rename(y, no_index), rename(z, no_index);
      } else {
        rename(x, y), rename(y, z), rename(z, x);
      }
    }
  });
}

}  // namespace multimesh::tet
