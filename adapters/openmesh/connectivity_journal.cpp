// SPDX-License-Identifier: BSD-3-Clause
// The words of the connectivity: written, each into the journal first, and restored.
#include <algorithm>

#include "multimesh/openmesh/connectivity.hpp"

namespace multimesh::openmesh {

namespace {

std::uint32_t word(int i) {
  return static_cast<std::uint32_t>(i);
}
int signed_word(std::uint32_t i) {
  return static_cast<int>(i);
}
std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

void Connectivity::Journal::grow() {
  const std::size_t n = entries_.size();
  entries_.resize(std::max<std::size_t>(64, 2 * n));
  end_ = entries_.data() + n;
  limit_ = entries_.data() + entries_.size();
}

void Connectivity::write_to(int h, int v) {
  if (watch_) watch_->will_point(h, v);
  om_.set_vertex_handle(handle(h), OpenMesh::VertexHandle(v));
}

void Connectivity::write_face(int h, int f) {
  if (watch_) watch_->will_have_face(h, f);
  om_.set_face_handle(handle(h), OpenMesh::FaceHandle(f));
}

void Connectivity::write_edge_status(std::uint32_t e, unsigned bits) {
  OpenMesh::Attributes::StatusInfo& status = (*edge_status_)[e];
  const bool was_dead = status.deleted();
  status.set_bits(bits);
  if (!watch_ || was_dead == status.deleted()) return;
  for (const int h : {2 * signed_word(e), 2 * signed_word(e) + 1})
    was_dead ? watch_->put_in(h) : watch_->leave_out(h);
}

void Connectivity::pop(std::size_t vertices, std::size_t edges, std::size_t faces) {
  if (vertices == om_.n_vertices() && edges == om_.n_edges() && faces == om_.n_faces()) return;
  if (watch_)
    for (std::size_t e = edges; e < om_.n_edges(); ++e)
      if (!(*edge_status_)[e].deleted())
        for (const int h : {2 * static_cast<int>(e), 2 * static_cast<int>(e) + 1}) watch_->leave_out(h);
  om_.resize(vertices, edges, faces);
  if (watch_) watch_->note_counts();
}

void Connectivity::set_to(int h, int v) {
  log(Word::to, word(h), word(to(h)));
  write_to(h, v);
}

void Connectivity::set_next(int h, int n) {
  log(Word::next, word(h), word(next(h)));
  log(Word::prev, word(n), word(prev(n)));
  om_.set_next_halfedge_handle(handle(h), handle(n));
}

void Connectivity::set_face(int h, int f) {
  log(Word::face, word(h), word(face(h)));
  write_face(h, f);
}

void Connectivity::set_out(int v, int h) {
  log(Word::out, word(v), word(out(v)));
  om_.set_halfedge_handle(OpenMesh::VertexHandle(v), handle(h));
}

void Connectivity::set_halfedge_of(int f, int h) {
  log(Word::halfedge_of, word(f), word(halfedge_of(f)));
  om_.set_halfedge_handle(OpenMesh::FaceHandle(f), handle(h));
}

void Connectivity::kill_vertex(int v) {
  log(Word::vertex_status, word(v), (*vertex_status_)[at(v)].bits());
  (*vertex_status_)[at(v)].set_deleted(true);
}

void Connectivity::kill_edge(int e) {
  const unsigned bits = (*edge_status_)[at(e)].bits();
  log(Word::edge_status, word(e), bits);
  write_edge_status(word(e), bits | OpenMesh::Attributes::DELETED);
  if (!om_.has_halfedge_status()) return;
  // Restored with the edge: the halfedges of a live edge are live.
  om_.status(handle(2 * e)).set_deleted(true);
  om_.status(handle(2 * e + 1)).set_deleted(true);
}

void Connectivity::kill_face(int f) {
  log(Word::face_status, word(f), (*face_status_)[at(f)].bits());
  (*face_status_)[at(f)].set_deleted(true);
}

void Connectivity::log_counts() {
  log(Word::faces, 0, static_cast<std::uint32_t>(om_.n_faces()));
  log(Word::edges, 0, static_cast<std::uint32_t>(om_.n_edges()));
  log(Word::vertices, 0, static_cast<std::uint32_t>(om_.n_vertices()));
}

int Connectivity::new_vertex() {
  log_counts();
  return named(0, om_.ArrayKernel::new_vertex().idx());
}

int Connectivity::new_edge(int from, int to) {
  log_counts();
  const int h = om_.ArrayKernel::new_edge(OpenMesh::VertexHandle(from), OpenMesh::VertexHandle(to)).idx();
  named(1, h >> 1);
  if (watch_) watch_->put_in(h), watch_->put_in(h ^ 1);
  return h;
}

int Connectivity::new_face() {
  log_counts();
  return named(2, om_.ArrayKernel::new_face().idx());
}

int Connectivity::named(int k, int element) {
  if (watch_) watch_->name(k, element), watch_->note_counts();
  return element;
}

void Connectivity::copy_edge_properties(int from_halfedge, int to_halfedge) {
  for (auto p = om_.eprops_begin(); p != om_.eprops_end(); ++p)
    if (*p) (*p)->copy(at(from_halfedge >> 1), at(to_halfedge >> 1));
  for (auto p = om_.hprops_begin(); p != om_.hprops_end(); ++p)
    if (*p)
      for (const int side : {0, 1}) (*p)->copy(at(from_halfedge ^ side), at(to_halfedge ^ side));
  named(1, to_halfedge >> 1);
}

void Connectivity::copy_corner_properties(int from_halfedge, int to_halfedge) {
  const OpenMesh::BaseProperty* status =
      om_.has_halfedge_status() ? &om_.property(om_.halfedge_status_pph()) : nullptr;
  for (auto p = om_.hprops_begin(); p != om_.hprops_end(); ++p)
    if (*p && *p != status) (*p)->copy(at(from_halfedge), at(to_halfedge));
}

void Connectivity::copy_face_properties(int from, int to) {
  for (auto p = om_.fprops_begin(); p != om_.fprops_end(); ++p)
    if (*p) (*p)->copy(at(from), at(to));
  named(2, to);
}

// Everything except the status, which has the deleted bit and is journaled separately, and the names of
// elements.
void Connectivity::copy_properties(int k, std::size_t from, std::size_t to) {
  const auto copy = [](auto begin, auto end, const OpenMesh::BaseProperty* status, std::size_t i,
                       std::size_t j) {
    for (auto p = begin; p != end; ++p)
      if (*p && *p != status && !Watch::owns(**p)) (*p)->copy(i, j);
  };
  if (k == 0) {
    copy(om_.vprops_begin(), om_.vprops_end(), &om_.property(om_.vertex_status_pph()), from, to);
  } else if (k == 1) {
    copy(om_.eprops_begin(), om_.eprops_end(), &om_.property(om_.edge_status_pph()), from, to);
    const OpenMesh::BaseProperty* status =
        om_.has_halfedge_status() ? &om_.property(om_.halfedge_status_pph()) : nullptr;
    for (const std::size_t side : {0U, 1U})
      copy(om_.hprops_begin(), om_.hprops_end(), status, 2 * from + side, 2 * to + side);
  } else {
    copy(om_.fprops_begin(), om_.fprops_end(), &om_.property(om_.face_status_pph()), from, to);
  }
}

// A dead element that stores values of a live one.
int Connectivity::make_spare(int k) {
  const int spare = k == 0 ? new_vertex() : k == 1 ? new_edge(-1, -1) >> 1 : new_face();
  (*(k == 0 ? vertex_status_ : k == 1 ? edge_status_ : face_status_))[at(spare)].set_deleted(true);
  spares_[k].push_back(spare);
  return spare;
}

void Connectivity::protect(int k, Index s) {
  const Word status_word = k == 0 ? Word::vertex_status : k == 1 ? Word::edge_status : Word::face_status;
  log(status_word, s, status(k)[s].bits());
  const int spare = make_spare(k);
  copy_properties(k, s, at(spare));
  log(Word::spare, s, word(spare), static_cast<LinkSet>(k));
}

void Connectivity::forget() {
  log_.clear();
  if (spares_[0].empty() && spares_[1].empty() && spares_[2].empty()) return;
  // Spares at the end are removed; others stay, like dead elements, until the mesh is compacted.
  std::size_t n[3] = {om_.n_vertices(), om_.n_edges(), om_.n_faces()};
  for (int k = 0; k < 3; ++k) {
    for (; !spares_[k].empty(); spares_[k].pop_back())
      if (at(spares_[k].back()) + 1 == n[k]) --n[k];
  }
  pop(n[0], n[1], n[2]);
}

void Connectivity::rollback(Mark mark) {
  while (log_.size() > mark) {
    undo(log_.back());
    log_.pop();
  }
}

// Last write first. Undoing `next` also writes prev of the old successor, as OpenMesh does; if that was not
// its value, an older entry of the journal restores it later.
void Connectivity::undo(const Entry& e) {
  const int i = signed_word(e.index), old = signed_word(e.old);
  switch (e.word) {
    case Word::to:
      write_to(i, old);
      break;
    case Word::next:
      if (old >= 0) om_.set_next_halfedge_handle(handle(i), handle(old));  // else i is about to be popped
      break;
    case Word::prev:
      if (old >= 0) om_.set_prev_halfedge_handle(handle(i), handle(old));
      break;
    case Word::face:
      write_face(i, old);
      break;
    case Word::out:
      om_.set_halfedge_handle(OpenMesh::VertexHandle(i), handle(old));
      break;
    case Word::halfedge_of:
      om_.set_halfedge_handle(OpenMesh::FaceHandle(i), handle(old));
      break;
    case Word::vertex_status:
      (*vertex_status_)[e.index].set_bits(e.old);
      break;
    case Word::edge_status:
      write_edge_status(e.index, e.old);
      if (om_.has_halfedge_status())
        for (const int h : {2 * i, 2 * i + 1}) om_.status(handle(h)).set_deleted(false);
      break;
    case Word::face_status:
      (*face_status_)[e.index].set_bits(e.old);
      break;
    case Word::anchor_own:
      (*anchors_)[e.index].own = Dart{e.old};
      break;
    case Word::anchor_parent:
      (*anchors_)[e.index].parent = Dart{e.old};
      break;
    case Word::link:
      (*links_[e.column].facet_plus_one)[e.index] = e.old;
      break;
    case Word::vertices:
      pop(e.old, om_.n_edges(), om_.n_faces());
      break;
    case Word::edges:
      pop(om_.n_vertices(), e.old, om_.n_faces());
      break;
    case Word::faces:
      pop(om_.n_vertices(), om_.n_edges(), e.old);
      break;
    case Word::spare:
      copy_properties(e.column, e.old, e.index);
      spares_[e.column].pop_back();
      break;
    case Word::edge_values:
    case Word::halfedge_values:
      exchange(e);
      break;
    case Word::renewed:
      exchange(e);
      spares_[1].pop_back();
      break;
  }
}

}  // namespace multimesh::openmesh
