// SPDX-License-Identifier: BSD-3-Clause
// Darts, neighbourhoods, maps and properties. Construction, operations, the journal and the checks are in
// files of their own.
#include "multimesh/tet/tet_mesh.hpp"

#include <algorithm>

#include "adapters/tet/codes.hpp"
#include "multimesh/tet_sides.hpp"

namespace multimesh::tet {

// --- simplices and darts -------------------------------------------------------------------------------

Index TetMesh::capacity(int k) const {
  const auto t = static_cast<Index>(tets_.size());
  return k == 0 ? static_cast<Index>(flags_.size()) : k == 1 ? 6 * t : k == 2 ? 4 * t : t;
}

bool TetMesh::is_live(int k, Index s) const {
  if (s >= capacity(k)) return false;
  if (k == 0) return !(flags_[s] & dead);
  const Index t = k == 1 ? s / 6 : k == 2 ? s / 4 : s;
  if (tets_[t].v[0] == no_index) return false;
  return k == 3 || simplex(dart_of(k, s), k) == s;
}

bool TetMesh::is_dart(Dart d) const {
  return (code(d) & 31U) < 24 && tet(d) < tets_.size() && tets_[tet(d)].v[0] != no_index;
}

std::uint32_t TetMesh::across(std::uint32_t d, int position) const {
  const std::uint32_t g = tets_[d >> 5].glue[local(d, position)];
  return g == no_glue ? no_glue : (g & ~31U) | product[g & 31U][d & 31U];
}

Index TetMesh::simplex(Dart dart, int k) const {
  const std::uint32_t d = code(dart);
  if (k == 0) return at(d, 0);
  if (k == 3) return d >> 5;
  if (k == 2) {
    const auto slot = static_cast<Index>(4 * (d >> 5) + local(d, 3));
    const std::uint32_t n = across(d, 3);
    return n == no_glue ? slot : std::min(slot, static_cast<Index>(4 * (n >> 5) + local(n, 3)));
  }
  Index least = edge_slot(d);
  std::uint32_t r = turned(d, 2);
  for (; r != no_glue && r != d; r = turned(r, 2)) least = std::min(least, edge_slot(r));
  if (r == no_glue)
    for (r = turned(d, 3); r != no_glue; r = turned(r, 3)) least = std::min(least, edge_slot(r));
  return least;
}

Dart TetMesh::dart_of(int k, Index s) const {
  if (k == 0) return Dart{vertex_tet_[s]};
  if (k == 3) return tets_[s].v[0] == no_index ? no_dart : dart(s);
  if (k == 2) return dart(s / 4, {exchange[s % 4][3]});
  const auto [i, j] = edge_corners[s % 6];
  // Any ordering that begins with the edge.
  const auto rest = [i = i, j = j](int skip) {
    for (int c = 0;; ++c)
      if (c != i && c != j && skip-- == 0) return c;
  };
  return dart(s / 6, permutation(i, j, rest(0), rest(1)));
}

Dart TetMesh::switch_dart(Dart d, int k) const {
  if (k < 3) return reorder(d, transposition(k));
  return Dart{across(code(d), 3)};  // no_glue is no_dart
}

Dart TetMesh::reorder(Dart d, Permutation p) const {
  return Dart{(code(d) & ~31U) | product[code(d) & 31U][p.code]};
}

Permutation TetMesh::order(Dart from, Dart to) const {
  return {product[inverse_code[code(from) & 31U]][code(to) & 31U]};
}

void TetMesh::vertices(Dart d, Index* v) const {
  const Tet& t = tets_[tet(d)];
  for (int i = 0; i < 4; ++i) v[i] = t.v[local(code(d), i)];
}

// By vertices: quicker than by index, and the same in a proper complex.
bool TetMesh::same_simplex(Dart d, Dart e, int k) const {
  if (k == 0 || k == 3) return simplex(d, k) == simplex(e, k);
  return key(d, k) == key(e, k);
}

SimplexKey TetMesh::key(Dart d, int k) const {
  Index v[4];
  vertices(d, v);
  return simplex_key(v, k);
}

// --- neighbourhoods ------------------------------------------------------------------------------------

// A stamp that no element has; all are wiped when the numbers run out.
std::uint32_t TetMesh::next_search(LargeArray<std::uint32_t>& stamps, std::uint32_t& last, unsigned step) {
  if (last > ~0U - 2 * step) {
    std::fill(stamps.begin(), stamps.end(), 0);
    last = 0;
  }
  return last += step;
}

void TetMesh::vertex_star(std::uint32_t d, std::vector<std::uint32_t>& out) const {
  out.assign(1, d);
  const std::uint32_t search = next_search(tet_stamp_, tet_search_, 1);
  tet_stamp_[d >> 5] = search;
  for (std::size_t i = 0; i < out.size(); ++i)
    for (int position = 1; position < 4; ++position) {
      const std::uint32_t n = across(out[i], position);
      if (n == no_glue || tet_stamp_[n >> 5] == search) continue;
      tet_stamp_[n >> 5] = search;
      out.push_back(n);
    }
}

Index TetMesh::edge_slot(std::uint32_t d) {
  return 6 * (d >> 5) + edge_number[local(d, 0)][local(d, 1)];
}

// From (a,b,x,y) around a-b: position 2 leads on, to (a,b,y,z), position 3 back.
std::uint32_t TetMesh::turned(std::uint32_t d, int position) const {
  const std::uint32_t n = across(d, position);
  return n == no_glue ? no_glue : (n & ~31U) | product[n & 31U][transposition(2).code];
}

// From the face (a,b,y) on; if that ends at the boundary, from (a,b,x) in the other direction, too.
void TetMesh::edge_ring(std::uint32_t d, Ring& ring) const {
  ring.darts.assign(1, d);
  ring.closed = false;
  for (std::uint32_t r = turned(d, 2); r != no_glue; r = turned(r, 2)) {
    if (r == d) {
      ring.closed = true;
      break;
    }
    ring.darts.push_back(r);
  }
  if (!ring.closed) {
    const std::size_t ahead = ring.darts.size();
    for (std::uint32_t r = turned(d, 3); r != no_glue; r = turned(r, 3)) ring.darts.push_back(r);
    const auto behind = ring.darts.begin() + static_cast<std::ptrdiff_t>(ahead);
    std::reverse(behind, ring.darts.end());
    std::rotate(ring.darts.begin(), behind, ring.darts.end());
  }
  ring.rim.clear();
  for (const std::uint32_t r : ring.darts) ring.rim.push_back(at(r, 2));
  if (!ring.closed) ring.rim.push_back(at(ring.darts.back(), 3));
}

void TetMesh::star(Dart d, int k, DartBuffer& out) const {
  out.clear();
  if (k == 3) {
    out.push_back(d);
  } else if (k == 2) {
    out.push_back(d);
    if (const Dart n = switch_dart(d, 3); n != no_dart) out.push_back(n);
  } else if (k == 1) {
    edge_ring(code(d), ring_);
    for (const std::uint32_t r : ring_.darts) out.push_back(Dart{r});
  } else {
    vertex_star(code(d), star_);
    for (const std::uint32_t t : star_) out.push_back(Dart{t});
  }
}

bool TetMesh::is_boundary(Dart d, int k) const {
  if (k == 0) return flags_[at(code(d), 0)] & in_boundary;
  if (k == 2) return across(code(d), 3) == no_glue;
  if (!(flags_[at(code(d), 0)] & flags_[at(code(d), 1)] & in_boundary)) return false;
  edge_ring(code(d), ring_);
  return !ring_.closed;
}

void TetMesh::set_locked(Index v, bool on) {
  flags_[v] = static_cast<std::uint8_t>(on ? flags_[v] | locked : flags_[v] & ~locked);
}

bool TetMesh::has_link_around(LinkSet links, int j, Dart d, int k) const {
  if (!may_have_link_around(links, d, k)) return false;
  return (j < 3 && k == 0) || Mesh::has_link_around(links, j, d, k);
}

// By the numbers of linked simplices around the vertices.
bool TetMesh::may_have_link_around(LinkSet links, Dart d, int k) const {
  const auto& table = links_[links].table;
  for (int i = 0; table && i <= k; ++i)
    if (table->around(at(code(d), i)) == 0) return false;
  return true;
}

bool TetMesh::may_have_link_in_facet(LinkSet links, Dart d) const {
  const Links& l = links_[links];
  if (l.k == 3) return true;
  int n = 0;
  for (const Index v : tets_[tet(d)].v) n += (l.table ? l.table->around(v) : l.facet_plus_one[v]) > 0;
  return n > l.k;
}

// --- containment maps ----------------------------------------------------------------------------------

void TetMesh::add_anchors() {
  anchors_.assign(tets_.size(), {});
  has_anchors_ = true;
}

void TetMesh::remove_anchors() {
  anchors_ = {};
  has_anchors_ = false;
}

void TetMesh::set_anchor(Index t, Anchor a) {
  log(Word::anchor_own, t, code(anchors_[t].own));
  log(Word::anchor_parent, t, code(anchors_[t].parent));
  anchors_[t] = a;
}

Mesh::LinkSet TetMesh::add_links(int k) {
  std::size_t i = 0;
  while (i < links_.size() && links_[i].used) ++i;
  if (i == 255) throw UsageError("a mesh has at most 255 children");
  if (i == links_.size()) links_.emplace_back();
  Links& l = links_[i];
  l.k = k;
  l.used = true;
  if (k == 0 || k == 3) {
    l.facet_plus_one.assign(capacity(k), 0);
  } else {
    l.table = std::make_unique<SimplexTable>(k, flags_.size());
  }
  return static_cast<LinkSet>(i);
}

void TetMesh::remove_links(LinkSet links) {
  links_[links] = {};
}

Index TetMesh::link(LinkSet links, Dart d) const {
  const Links& l = links_[links];
  if (!l.table) return l.facet_plus_one[simplex(d, l.k)] - 1;
  Index v[4];
  vertices(d, v);
  return l.table->find(v);
}

void TetMesh::set_link(LinkSet links, Dart d, Index f) {
  Links& l = links_[links];
  if (l.table) return write(*l.table, key(d, l.k), f);
  const Index s = simplex(d, l.k);
  Index& word = l.facet_plus_one[s];
  log(Word::dense_link, s, word, links);
  word = f + 1;
}

void TetMesh::remap_links(LinkSet links, const std::vector<Index>& child_facets) {
  Links& l = links_[links];
  for (Index& f : l.facet_plus_one)
    if (f != 0) f = child_facets[f - 1] + 1;
  if (!l.table) return;
  std::vector<Index> same(flags_.size());
  for (Index v = 0; v < same.size(); ++v) same[v] = v;
  l.table->renumber(same, same.size(), &child_facets);
}

// --- properties ----------------------------------------------------------------------------------------

void TetMesh::adopt(Properties& list, std::unique_ptr<ValueList> values, std::size_t n) {
  if (find(list, values->name()))
    throw UsageError("the mesh has a property \"" + values->name() + "\" already");
  values->resize(n);
  list.push_back(std::move(values));
}

void TetMesh::keep(int k, std::unique_ptr<ValueList> values) {
  if (k != 0 && k != 3)
    throw UsageError(
        "the edges and faces of a tetrahedral mesh have no indices that last: their values are "
        "a simplex property");
  adopt(k == 0 ? vertex_properties_ : tet_properties_, std::move(values), capacity(k));
}

void TetMesh::drop(int k, const void* values) {
  const Properties& list = k == 0 ? vertex_properties_ : tet_properties_;
  const auto found = std::ranges::find_if(list, [&](const auto& p) { return p->are_in(values); });
  if ((k != 0 && k != 3) || found == list.end()) throw UsageError("these values do not belong to the mesh");
  remove_property(**found);
}

void TetMesh::adopt(std::unique_ptr<SimplexPropertyBase> property) {
  for (const auto& p : simplex_properties_)
    if (p->name() == property->name())
      throw UsageError("the mesh has a property \"" + property->name() + "\" already");
  simplex_properties_.push_back(std::move(property));
}

namespace {

template <class List, class Base>
bool erase_from(List& list, const Base& property) {
  return std::erase_if(list, [&](const auto& p) { return p.get() == &property; }) > 0;
}

}  // namespace

void TetMesh::remove_property(const ValueList& property) {
  if (!log_.empty()) throw UsageError("a property cannot be removed inside a transaction");
  if (!erase_from(vertex_properties_, property) && !erase_from(tet_properties_, property))
    throw UsageError("this property does not belong to the mesh");
}

void TetMesh::remove_property(const SimplexPropertyBase& property) {
  if (!log_.empty()) throw UsageError("a property cannot be removed inside a transaction");
  if (!erase_from(simplex_properties_, property))
    throw UsageError("this property does not belong to the mesh");
}

}  // namespace multimesh::tet
