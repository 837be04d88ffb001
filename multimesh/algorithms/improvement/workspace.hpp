// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/improvement/amips.hpp"
#include "multimesh/algorithms/improvement/flatness.hpp"
#include "multimesh/copy.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/keeps_volumes.hpp"
#include "multimesh/stays_in_envelope.hpp"
#include "multimesh/strata.hpp"

namespace multimesh::improvement {

using Corners = std::array<Index, 4>;

/// The cubed AMIPS energy of a tetrahedron with orient3d = 1, exactly; +infinity for all others. `flat` if it
/// is too flat for the energy. All comparisons of quality use these numbers; lower is better.
double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
inline constexpr double flat = 1e300;
/// The same where it is below the limit; else any number from the limit on. Cheaper if the tetrahedron is
/// nearly flat and the limit is not so large that its side matters.
double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double limit);

/// The tetrahedra around an edge (a,b), in order: (a,b,rim[i],rim[i+1]), each of positive orientation.
/// Closed: as many as rim, and the last one ends at rim[0]; open: one fewer, from boundary to boundary.
struct Ring {
  Index a = no_index, b = no_index;
  DartBuffer darts;
  std::vector<Index> rim;
  bool closed = false;

  std::size_t size() const noexcept { return darts.size(); }
  Index next(std::size_t i) const noexcept { return rim[i + 1 == rim.size() ? 0 : i + 1]; }
};

/// What the operations read and write: the tetrahedra, their points, what must stay, and the operations of
/// the tree.
class Workspace {
 public:
  /// \throw UsageError unless the mesh has dimension 3
  Workspace(const Embedding& embedding, NodeId node, const ImproveOptions& options);

  const Mesh& mesh() const { return mesh_; }
  const Vec3& point(Index v) const { return points_[v]; }
  const Strata& strata() const { return strata_; }
  Propagation& operations() { return operations_; }

  Flatness flatness() const { return flatness_; }
  bool is_live(Index t) const { return mesh_.is_live(3, t); }
  /// Cost: linear
  std::size_t count_tets() const;
  /// Of positive orientation.
  Corners corners(Index t) const {
    Corners v{};
    mesh_.facet_vertices(t, v.data());
    return v;
  }
  double quality_of(const Corners& c) const {
    return quality(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]);
  }
  double quality_of(const Corners& c, double limit) const {
    return quality(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]], limit);
  }
  double quality_of(Index t) const { return quality_of(corners(t)); }

  Index tet(Dart d) const { return mesh_.facet(d); }
  Dart dart(Index t, Permutation p = {}) const { return mesh_.reorder(mesh_.dart_of(3, t), p); }
  /// The dart (corner i, corner j, ..) of t.
  Dart edge(Index t, int i, int j) const;
  void read_ring(Dart e, Ring& ring) const;
  /// The dart (a,b,rim[i],..); at the end of an open ring, the far side of the last tetrahedron.
  Dart face_at(const Ring& ring, std::size_t i) const {
    return i == ring.size() ? mesh_.reorder(ring.darts.back(), transposition(2)) : ring.darts[i];
  }
  /// Positions i in the rim for which the face (a,b,rim[i]) is a wall.
  void read_walls(const Ring& ring, std::vector<std::size_t>& faces) const;
  /// The tetrahedra around a vertex, which is the first corner of each; those around its other copies, too.
  /// `v`: a dart at it.
  void read_star(Dart v, std::vector<Corners>& star) const;
  /// Live tetrahedra around a vertex and its copies.
  void read_star(Dart v, std::vector<Index>& tets) const;

  /// What holds a wall, if it is only held in an envelope.
  const StaysInEnvelope* envelope_of(Dart wall) const;
  std::vector<EnvelopeUse> measure_envelopes() const;

  // --- copies: in a periodic tile, the vertices and edges that are one in the torus
  bool is_copied(Index v) const { return has_copies_ && strata_.is_copied(v); }
  /// All copies of the k-simplex of a dart, which is the first of them. Their corners are in its order.
  void read_copies(Dart d, int k, DartBuffer& copies) const {
    copies.assign(1, d);
    if (has_copies_) add_other_copies(d, k, copies);
  }
  /// Whether the edge has others.
  bool is_edge_copied(Dart e) const {
    if (!has_copies_) return false;
    read_copies(e, 1, edge_copies_);
    return edge_copies_.size() > 1;
  }
  /// All copies of a vertex.
  void add_copies(Index v, std::vector<Index>& copies) const;
  /// Of the corners of a tetrahedron.
  void add_copies(const Corners& corners, std::vector<Index>& copies) const {
    if (!has_copies_) return (void)copies.insert(copies.end(), corners.begin(), corners.end());
    for (const Index v : corners) add_copies(v, copies);
  }
  /// The same number for all copies of a vertex: the least of theirs.
  Index name(Index v) const { return is_copied(v) ? name_of_copies(v) : v; }
  /// The place of a vertex as it is seen from a copy of `from` when that copy is seen at `from`.
  Vec3 seen_from(Index from, Index copy, Index v) const {
    return from == copy ? points_[v] : points_[v] + (points_[from] - points_[copy]);
  }
  /// Where the vertex may be instead of at x, see Coordinates::allowed.
  Vec3 allowed(Index v, const Vec3& x) const { return tets_.positions().allowed(v, x); }

  // --- operations; no_dart if refused
  /// \return (a,c,..)
  Dart split(Dart e, const Vec3& at, std::uint8_t strata);
  /// Moves a to b. \return a dart at b
  Dart collapse(Dart e);
  /// \pre e = (a,b,x,..). \return a dart at x
  Dart swap(Dart e);
  /// \pre in the boundary, between two faces of it; x in one of them. \return a dart at x
  Dart swap_in_boundary(Dart e);
  Dart swap_face(Dart f);
  bool move(Dart v, const Vec3& to);

 private:
  void add_other_copies(Dart d, int k, DartBuffer& copies) const;
  Index name_of_copies(Index v) const;
  void confine(const Confinement& c);
  void keep_volumes(const Embedding& embedding, double share);
  bool is_positive_around(Dart v);

  EmbeddedMesh tets_;
  NodeId node_;
  const Mesh& mesh_;
  Propagation& operations_;
  CoordinateList<Vec3> points_;
  Strata strata_;
  std::vector<std::unique_ptr<StaysInEnvelope>> envelopes_;
  std::optional<KeepsVolumes> volumes_;
  Flatness flatness_;
  DartBuffer found_;
  std::vector<Corners> star_;
  bool has_copies_;
  mutable DartBuffer darts_, centres_, edge_copies_;
  mutable Copies copies_;
  mutable std::vector<NodeId> meshes_;
};

}  // namespace multimesh::improvement
