// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "multimesh/mesh.hpp"

namespace multimesh::openmesh {

/// Whether edits of an attached mesh by other code are detected. With `off`, there must be none, because
/// nothing detects them.
enum class Watching : bool { off, on };

/// Detects whether a connectivity that other code can reach is still as our last write left it.
///
/// OpenMesh has no hooks, so the words themselves must be checked. Per vertex we keep the sum, over its
/// outgoing halfedges, of a hash of (halfedge, its end, its face). Each of our writes updates the sums, and
/// undoing it restores them. If a walk around a vertex gives another sum, other code has changed it. Elements
/// also have names of their own, so that a renumbering (garbage collection) can be followed. Properties
/// "mm:watch*": 8 bytes per vertex and 4 per element.
class Watch {
 public:
  /// Records the current connectivity. Cost: linear
  explicit Watch(OpenMesh::PolyConnectivity& om);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Our own changes, reported before a write (to, face) or amid it (edges that come and go: halfedges are
  // entered while the edge is live). Halfedges of dead edges, and without a vertex, do not count.
  void will_point(int halfedge, int vertex) {
    if (is_dead_edge(halfedge)) return;
    const int twin = halfedge ^ 1, from = to(twin), old = to(halfedge), face = face_of(halfedge);
    add(from, hash(halfedge, vertex, face) - hash(halfedge, old, face));
    const std::uint64_t back = hash(twin, from, face_of(twin));
    add(old, 0 - back);
    add(vertex, back);
  }
  void will_have_face(int halfedge, int face) {
    if (is_dead_edge(halfedge)) return;
    const int end = to(halfedge);
    add(to(halfedge ^ 1), hash(halfedge, end, face) - hash(halfedge, end, face_of(halfedge)));
  }
  void leave_out(int halfedge) { add(to(halfedge ^ 1), 0 - hash_of(halfedge)); }
  void put_in(int halfedge) { add(to(halfedge ^ 1), hash_of(halfedge)); }
  /// Elements were appended, or the last ones removed, by us.
  void note_counts();
  void name(int k, int element);

  bool same_counts() const noexcept;
  /// Whether the halfedges out of a vertex are as we left them. Cost: that of a walk around it
  bool in_step(int vertex) const;
  /// Checks all; the first vertex that is out of step, dead ones included, or nothing. Cost: linear
  std::optional<int> first_out_of_step() const;

  /// Where named elements are now, by their old indices. \throw OutOfStepError if names are missing or found
  /// twice: the mesh was cleared or assigned
  Compaction moved() const;
  /// Records the current connectivity.
  void accept();

  /// Whether a property belongs to a watch.
  static bool owns(const OpenMesh::BaseProperty& property);

 private:
  using Counts = std::array<std::size_t, 3>;
  Counts counts_now() const;
  bool is_dead(int k, int element) const;
  bool is_dead_edge(int halfedge) const {
    return (*edge_status_)[static_cast<std::size_t>(halfedge >> 1)].deleted();
  }
  int to(int h) const { return om_.to_vertex_handle(OpenMesh::HalfedgeHandle(h)).idx(); }
  int face_of(int h) const { return om_.face_handle(OpenMesh::HalfedgeHandle(h)).idx(); }
  void add(int vertex, std::uint64_t x) {
    if (vertex >= 0 && static_cast<std::size_t>(vertex) < sums_->size())
      (*sums_)[static_cast<std::size_t>(vertex)] += x;
  }
  /// Hash of three words, mixed as in splitmix64 (Steele, Lea, Flood 2014).
  static std::uint64_t hash(int halfedge, int to, int face) {
    const auto word = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
    std::uint64_t x = (word(halfedge) << 32 | word(to)) * 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 32)) + word(face);
    x *= 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 29)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 32);
  }
  std::uint64_t hash_of(int h) const { return hash(h, to(h), face_of(h)); }
  std::uint64_t sum_around(int vertex) const;

  OpenMesh::PolyConnectivity& om_;
  Counts counts_{};
  OpenMesh::VPropHandleT<std::uint64_t> sum_property_;
  OpenMesh::VPropHandleT<Index> vertex_names_;
  OpenMesh::EPropHandleT<Index> edge_names_;
  OpenMesh::FPropHandleT<Index> face_names_;
  std::vector<std::uint64_t>* sums_;
  const std::vector<OpenMesh::Attributes::StatusInfo>* edge_status_;
  std::array<std::vector<Index>*, 3> names_;  // index known to us, plus one; 0: not ours
};

}  // namespace multimesh::openmesh
