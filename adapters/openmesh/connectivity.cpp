// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/connectivity.hpp"

#include <algorithm>
#include <string>

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

Connectivity::Connectivity(int dimension, OpenMesh::PolyConnectivity& om)
    : Mesh(dimension), om_(om), attachment_(om) {
  if (!attachment_.of_copy()) {
    om_.request_vertex_status();
    om_.request_edge_status();
    om_.request_face_status();
  }
  vertex_status_ = &om_.property(om_.vertex_status_pph()).data_vector();
  edge_status_ = &om_.property(om_.edge_status_pph()).data_vector();
  face_status_ = &om_.property(om_.face_status_pph()).data_vector();
  find_data_of_default_traits();
}

Connectivity::~Connectivity() {
  watch_.reset();
  remove_anchors();
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (links_[i].used) remove_links(static_cast<LinkSet>(i));
  const auto has_dead = [](const Status& list) {
    return std::any_of(list.begin(), list.end(), [](const auto& s) { return s.deleted(); });
  };
  if (has_dead(*vertex_status_) || has_dead(*edge_status_) || has_dead(*face_status_)) return;
  om_.release_vertex_status();
  om_.release_edge_status();
  om_.release_face_status();
}

namespace {

void refuse_if_any(const std::vector<std::string>& problems) {
  if (!problems.empty()) throw InputError(problems.front() + "; cut the mesh first (openmesh::ManifoldCut)");
}

}  // namespace

void Connectivity::require_consistent() const {
  std::vector<std::string> problems;
  check(problems);
  refuse_if_any(problems);
}

void Connectivity::require_proper() const {
  std::vector<std::string> problems;
  for (int k = 1; k <= dimension(); ++k) check_simplices_differ(*this, k, problems);
  refuse_if_any(problems);
}

void Connectivity::watch() {
  watch_ = std::make_unique<Watch>(om_);
  set_watched();
}

/// The one of the facets.
template <class Visit>
void Connectivity::with_anchor_property(const Visit& visit) {
  dimension() == 0 ? visit(vertex_anchors_) : dimension() == 1 ? visit(edge_anchors_) : visit(face_anchors_);
}

void Connectivity::add_anchors() {
  with_anchor_property([&](auto& property) {
    om_.add_property(property, "mm:anchor");
    anchors_ = &om_.property(property).data_vector();
  });
}

void Connectivity::remove_anchors() {
  if (!anchors_) return;
  with_anchor_property([&](auto& property) { om_.remove_property(property); });
  anchors_ = nullptr;
}

void Connectivity::set_anchor(Index f, Anchor a) {
  Anchor& old = (*anchors_)[f];
  log(Word::anchor_own, f, code(old.own));
  log(Word::anchor_parent, f, code(old.parent));
  old = a;
}

Connectivity::LinkSet Connectivity::add_links(int k) {
  std::size_t i = 0;
  while (i < links_.size() && links_[i].used) ++i;
  if (i == links_.size()) links_.emplace_back();
  if (i > 254) throw UsageError("a mesh can have at most 255 children");
  Links& l = links_[i];
  l.k = k;
  l.used = true;
  const std::string name = "mm:link" + std::to_string(i);
  const auto add = [&](auto& property) {
    om_.add_property(property, name);
    l.facet_plus_one = &om_.property(property).data_vector();
  };
  k == 0 ? add(l.vertices) : k == 1 ? add(l.edges) : add(l.faces);
  return static_cast<LinkSet>(i);
}

void Connectivity::remove_links(LinkSet links) {
  Links& l = links_[links];
  const auto remove = [&](auto& property) { om_.remove_property(property); };
  l.k == 0 ? remove(l.vertices) : l.k == 1 ? remove(l.edges) : remove(l.faces);
  l = Links();
}

void Connectivity::set_link(LinkSet links, Dart d, Index f) {
  Links& l = links_[links];
  const Index s = simplex(d, l.k);
  log(Word::link, s, (*l.facet_plus_one)[s], links);
  (*l.facet_plus_one)[s] = f + 1;
}

void Connectivity::remap_links(LinkSet links, const std::vector<Index>& child_facets) {
  for (Index& f : *links_[links].facet_plus_one)
    if (f != 0) f = child_facets[f - 1] + 1;  // no_index + 1 == 0
}

namespace {

/// Numbers the elements in a temporary property, which OpenMesh's garbage collection moves along with them.
template <class PropertyHandle>
class Numbering {
 public:
  Numbering(OpenMesh::PolyConnectivity& om, std::size_t n) : om_(om), old_size_(n) {
    om_.add_property(property_, "mm:number");
    auto& number = om_.property(property_).data_vector();
    for (std::size_t i = 0; i < n; ++i) number[i] = static_cast<Index>(i);
  }
  std::vector<Index> finish() {
    std::vector<Index> moved(old_size_, no_index);
    const auto& number = om_.property(property_).data_vector();
    for (std::size_t i = 0; i < number.size(); ++i) moved[number[i]] = static_cast<Index>(i);
    om_.remove_property(property_);
    return moved;
  }

 private:
  OpenMesh::PolyConnectivity& om_;
  std::size_t old_size_;
  PropertyHandle property_;
};

}  // namespace

Compaction Connectivity::compact() {
  if (!log_.empty()) throw UsageError("compact with an open journal");
  Numbering<OpenMesh::VPropHandleT<Index>> vertices(om_, om_.n_vertices());
  Numbering<OpenMesh::EPropHandleT<Index>> edges(om_, om_.n_edges());
  Numbering<OpenMesh::FPropHandleT<Index>> faces(om_, om_.n_faces());
  om_.garbage_collection();
  Compaction moved;
  moved.simplices = {vertices.finish(), edges.finish(), faces.finish()};
  moved.simplices.resize(static_cast<std::size_t>(dimension()) + 1);
  set_dart_blocks(moved);
  if (watch_) watch_->accept();
  return moved;
}

// Garbage collection keeps the parity of halfedges; a dart is a halfedge and, in 2D, a flip bit, or a vertex.
void Connectivity::set_dart_blocks(Compaction& moved) const {
  moved.blocks = moved.simplices[dimension() == 0 ? 0 : 1];
  moved.block_bits = static_cast<unsigned>(dimension());
}

std::optional<Index> Connectivity::first_out_of_step() const {
  const std::optional<int> v = watch_ ? watch_->first_out_of_step() : std::nullopt;
  return v ? std::optional(static_cast<Index>(*v)) : std::nullopt;
}

std::optional<Compaction> Connectivity::renumbering() const {
  if (!watch_) return std::nullopt;
  Compaction moved = watch_->moved();
  set_dart_blocks(moved);
  return moved;
}

void Connectivity::accept_edits() {
  if (!log_.empty()) throw UsageError("edits cannot be accepted with an open journal");
  if (watch_) watch_->accept();
}

}  // namespace multimesh::openmesh
