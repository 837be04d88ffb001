// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/watch.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

namespace {

constexpr const char* prefix = "mm:watch";

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Watch::Watch(OpenMesh::PolyConnectivity& om) : om_(om) {
  const std::string name = prefix;
  om_.add_property(sum_property_, name);
  om_.add_property(vertex_names_, name + ":vertex");
  om_.add_property(edge_names_, name + ":edge");
  om_.add_property(face_names_, name + ":face");
  sums_ = &om_.property(sum_property_).data_vector();
  edge_status_ = &om_.property(om_.edge_status_pph()).data_vector();
  names_ = {&om_.property(vertex_names_).data_vector(), &om_.property(edge_names_).data_vector(),
            &om_.property(face_names_).data_vector()};
  accept();
}

Watch::~Watch() {
  om_.remove_property(sum_property_);
  om_.remove_property(vertex_names_);
  om_.remove_property(edge_names_);
  om_.remove_property(face_names_);
}

bool Watch::owns(const OpenMesh::BaseProperty& property) {
  return property.name().rfind(prefix, 0) == 0;
}

Watch::Counts Watch::counts_now() const {
  return {om_.n_vertices(), om_.n_edges(), om_.n_faces()};
}

bool Watch::is_dead(int k, int i) const {
  return k == 0   ? om_.status(OpenMesh::VertexHandle(i)).deleted()
         : k == 1 ? om_.status(OpenMesh::EdgeHandle(i)).deleted()
                  : om_.status(OpenMesh::FaceHandle(i)).deleted();
}

void Watch::note_counts() {
  counts_ = counts_now();
}

void Watch::name(int k, int i) {
  (*names_[at(k)])[at(i)] = static_cast<Index>(i) + 1;
}

bool Watch::same_counts() const noexcept {
  return counts_ == counts_now();
}

// A walk that does not return to its start still gives a sum, over as many halfedges as there are: a wrong
// one.
std::uint64_t Watch::sum_around(int v) const {
  const int first = om_.halfedge_handle(OpenMesh::VertexHandle(v)).idx();
  std::uint64_t sum = 0;
  if (first < 0) return sum;
  const int n = static_cast<int>(om_.n_halfedges());
  int h = first;
  for (int steps = 0; steps < n; ++steps) {
    sum += hash_of(h);
    const int before = om_.prev_halfedge_handle(OpenMesh::HalfedgeHandle(h)).idx();
    if (before < 0 || before >= n) return ~sum;
    h = before ^ 1;
    if (h == first) return sum;
  }
  return ~sum;
}

bool Watch::in_step(int v) const {
  if (v < 0 || at(v) >= sums_->size()) return false;
  // OpenMesh keeps the halfedge of a dead vertex, but no live edge has the vertex.
  if (is_dead(0, v)) return (*sums_)[at(v)] == 0;
  return (*sums_)[at(v)] == sum_around(v);
}

std::optional<int> Watch::first_out_of_step() const {
  for (int v = 0; v < static_cast<int>(om_.n_vertices()); ++v)
    if (!in_step(v)) return v;
  return std::nullopt;
}

Compaction Watch::moved() const {
  Compaction moved;
  const Counts now = counts_now();
  for (int k = 0; k < 3; ++k) {
    auto& to = moved.simplices.emplace_back(counts_[at(k)], no_index);
    for (std::size_t i = 0; i < now[at(k)]; ++i) {
      const Index name = (*names_[at(k)])[i];
      if (name == 0 || is_dead(k, static_cast<int>(i))) continue;
      if (name > to.size() || to[name - 1] != no_index)
        throw OutOfStepError("the names of elements are lost; the OpenMesh mesh was cleared or assigned");
      to[name - 1] = static_cast<Index>(i);
    }
  }
  return moved;
}

void Watch::accept() {
  note_counts();
  for (auto* names : names_) std::iota(names->begin(), names->end(), Index{1});
  std::fill(sums_->begin(), sums_->end(), 0);
  for (int h = 0; h < static_cast<int>(om_.n_halfedges()); ++h)
    if (!is_dead_edge(h)) put_in(h);
}

}  // namespace multimesh::openmesh
