// SPDX-License-Identifier: BSD-3-Clause
// Writes with their old values, word by word, and undo.
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::tet {

void TetMesh::set_corner(Index t, std::size_t i, Index v) {
  log(Word::corner, static_cast<std::uint32_t>(4 * t + i), tets_[t].v[i]);
  tets_[t].v[i] = v;
}

void TetMesh::set_glue(Index t, std::size_t f, std::uint32_t g) {
  log(Word::glue, static_cast<std::uint32_t>(4 * t + f), tets_[t].glue[f]);
  tets_[t].glue[f] = g;
}

void TetMesh::set_vertex_tet(Index v, std::uint32_t d) {
  log(Word::vertex_tet, v, vertex_tet_[v]);
  vertex_tet_[v] = d;
}

void TetMesh::set_flags(Index v, std::uint8_t flags) {
  log(Word::flags, v, flags_[v]);
  flags_[v] = flags;
}

void TetMesh::write(SimplexTable& table, const SimplexKey& key, Index number) {
  const Index old = table.set(key, number);
  if (old == number) return;
  old_numbers_.push_back({&table, key, old});
  log(Word::table, 0, 0);
}

void TetMesh::resize_vertices(std::size_t n) {
  vertex_tet_.resize(n, code(no_dart));
  flags_.resize(n, 0);
  vertex_stamp_.resize(n, 0);
  for (const auto& p : vertex_properties_) p->resize(n);
  for (const auto& p : simplex_properties_) p->table().resize(n);
  for (Links& l : links_) {
    if (l.table) l.table->resize(n);
    if (l.used && l.k == 0) l.facet_plus_one.resize(n, 0);
  }
}

void TetMesh::resize_tets(std::size_t n) {
  tets_.resize(n);
  tet_stamp_.resize(n, 0);
  if (has_anchors_) anchors_.resize(n);
  for (const auto& p : tet_properties_) p->resize(n);
  for (Links& l : links_)
    if (l.used && l.k == 3) l.facet_plus_one.resize(n, 0);
}

// Tetrahedra with the properties of others. Slots that were freed since the last forget() are not reused yet:
// their old contents, and what attributes have recorded about them, may be restored.
void TetMesh::new_tets(const std::vector<std::uint32_t>& like, std::vector<Index>& out) {
  out.clear();
  while (out.size() < like.size() && !free_tets_.empty()) {
    out.push_back(free_tets_.back());
    free_tets_.pop_back();
    log(Word::took_tet, out.back(), 0);
  }
  if (const std::size_t more = like.size() - out.size(); more > 0) {
    const auto first = static_cast<Index>(tets_.size());
    if (first + more > most_tets) throw UsageError("a tetrahedral mesh has at most 2^27 tetrahedra");
    log(Word::grew_tets, first, 0);
    resize_tets(first + more);
    for (Index t = first; t < tets_.size(); ++t) out.push_back(t);
  }
  for (std::size_t i = 0; i < like.size(); ++i) tets_[out[i]] = tets_[like[i] >> 5];
  for (const auto& p : tet_properties_)
    for (std::size_t i = 0; i < like.size(); ++i) p->copy(like[i] >> 5, out[i]);
}

Index TetMesh::new_vertex() {
  Index v = static_cast<Index>(flags_.size());
  if (!free_vertices_.empty()) {
    v = free_vertices_.back();
    free_vertices_.pop_back();
    log(Word::took_vertex, v, 0);
    set_flags(v, 0);
    for (const auto& p : vertex_properties_) p->reset(v);
  } else {
    log(Word::grew_vertices, v, 0);
    resize_vertices(flags_.size() + 1);
  }
  return v;
}

void TetMesh::kill_tet(Index t) {
  set_corner(t, 0, no_index);
  freed_tets_.push_back(t);
  log(Word::freed_tet, t, 0);
}

void TetMesh::kill_vertex(Index v) {
  set_flags(v, dead);
  set_vertex_tet(v, code(no_dart));
  freed_vertices_.push_back(v);
  log(Word::freed_vertex, v, 0);
}

void TetMesh::protect(int k, Index s) {
  if (k != 0 && k != 3) return;  // values on edges and faces are journaled whenever they are written
  const Properties& list = k == 0 ? vertex_properties_ : tet_properties_;
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    list[i]->save(s);
    log(k == 0 ? Word::vertex_property : Word::tet_property, s, i);
  }
}

void TetMesh::forget() {
  log_.clear();
  free_tets_.insert(free_tets_.end(), freed_tets_.begin(), freed_tets_.end());
  free_vertices_.insert(free_vertices_.end(), freed_vertices_.begin(), freed_vertices_.end());
  freed_tets_.clear();
  freed_vertices_.clear();
  old_numbers_.clear();
  for (const auto& p : vertex_properties_) p->forget();
  for (const auto& p : tet_properties_) p->forget();
}

void TetMesh::rollback(Mark mark) {
  while (log_.size() > mark) {
    undo(log_.back());
    log_.pop_back();
  }
}

void TetMesh::undo(const Entry& e) {
  switch (e.word) {
    case Word::corner:
      tets_[e.index / 4].v[e.index % 4] = e.old;
      break;
    case Word::glue:
      tets_[e.index / 4].glue[e.index % 4] = e.old;
      break;
    case Word::vertex_tet:
      vertex_tet_[e.index] = e.old;
      break;
    case Word::flags:
      flags_[e.index] = static_cast<std::uint8_t>(e.old);
      break;
    case Word::anchor_own:
      anchors_[e.index].own = Dart{e.old};
      break;
    case Word::anchor_parent:
      anchors_[e.index].parent = Dart{e.old};
      break;
    case Word::dense_link:
      links_[e.column].facet_plus_one[e.index] = e.old;
      break;
    case Word::table: {
      const TableEntry& old = old_numbers_.back();
      old.table->set(old.key, old.old);
      old_numbers_.pop_back();
      break;
    }
    case Word::vertex_property:
      vertex_properties_[e.old]->restore(e.index);
      break;
    case Word::tet_property:
      tet_properties_[e.old]->restore(e.index);
      break;
    case Word::took_tet:
      tets_[e.index].v[0] = no_index;
      free_tets_.push_back(e.index);
      break;
    case Word::grew_tets:
      resize_tets(e.index);
      break;
    case Word::freed_tet:
      freed_tets_.pop_back();
      break;
    case Word::took_vertex:
      free_vertices_.push_back(e.index);
      break;
    case Word::grew_vertices:
      resize_vertices(e.index);
      break;
    case Word::freed_vertex:
      freed_vertices_.pop_back();
      break;
  }
}

}  // namespace multimesh::tet
