// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/algorithms/improvement/amips.hpp"
#include "multimesh/algorithms/improvement/flatness.hpp"
#include "multimesh/algorithms/improvement/held.hpp"
#include "multimesh/domains/joined_mesh.hpp"
#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/operations.hpp"

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

/// What the operations read and write: the domain, its points, what must stay, and the tree's operations with
/// the rule for new points.
class Workspace {
 public:
  Workspace(TetDomain& domain, const ImproveOptions& options);

  const tet::TetMesh& mesh() const { return mesh_; }
  const Vec3& point(Index v) const { return points_[v]; }
  Held& held() { return held_; }
  const Held& held() const { return held_; }
  Propagation& operations() { return operations_; }

  Flatness flatness() const { return flatness_; }
  bool is_live(Index t) const { return mesh_.is_live(3, t); }
  /// Cost: linear
  std::size_t count_tets() const;
  /// Of positive orientation, `first` being the first.
  Corners corners(Index t, std::size_t first = 0) const;
  double quality_of(const Corners& c) const {
    return quality(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]);
  }
  double quality_of(const Corners& c, double limit) const {
    return quality(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]], limit);
  }
  double quality_of(Index t) const { return quality_of(corners(t)); }

  /// The dart (corner i, corner j, ..) of t.
  static Dart edge(Index t, int i, int j);
  void read_ring(Dart e, Ring& ring) const;
  /// The dart (a,b,rim[i],..); at the end of an open ring, the far side of the last tetrahedron.
  Dart face_at(const Ring& ring, std::size_t i) const {
    return i == ring.size() ? mesh_.reorder(ring.darts.back(), transposition(2)) : ring.darts[i];
  }
  /// Positions i in the rim for which the face (a,b,rim[i]) is held.
  void read_held_faces(const Ring& ring, std::vector<std::size_t>& faces) const;
  /// The tetrahedra around a vertex, which is the first corner of each. `v`: a dart at it.
  void read_star(Dart v, std::vector<Corners>& star) const;
  /// Live tetrahedra around a vertex.
  void read_star(Dart v, std::vector<Index>& tets) const;

  // --- operations; no_dart if refused, with the reason in refusal()
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
  const Refusal& refusal() const noexcept { return refusal_; }

 private:
  Dart keep(const Outcome& outcome);

  TetDomain& domain_;
  tet::TetMesh& mesh_;
  std::vector<Vec3>& points_;
  Held held_;
  Flatness flatness_;
  Vec3 new_point_ = Vec3::Zero();
  VertexAttribute<Vec3> positions_;
  KeepsJoinedMesh joined_;
  Propagation operations_;
  Refusal refusal_;
  mutable DartBuffer darts_;
};

}  // namespace multimesh::improvement
