// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/algorithms/improvement/workspace.hpp"

namespace multimesh::improvement {

/// Where a vertex of the surface or of a curve may move so that surface and curves stay the same sets of
/// points, exactly: within the plane of its faces, if all of them lie in one; along its curve, if that is
/// straight there and each sheet of the surface at it is plane. Flatness defines plane and straight. The
/// faces and curves at all copies of the vertex count, as seen from one of them. Where the one sheet at a
/// vertex is in an envelope: within that.
class ExactPlace {
 public:
  explicit ExactPlace(const Workspace& work) : work_(work), flatness_(work.flatness()) {}

  /// Reads the held faces and curves at the vertex of a dart. \return false if they are not flat, or the
  /// vertex is fixed: it must stay then
  bool read(Dart at_v);

  /// Whether v may move to `p`. \pre read() returned true
  bool allows(const Vec3& p) const { return allows(p, no_index); }
  /// Whether v may be merged into b, along a held face or along its curve.
  bool allows_merging(Index b) const;
  /// Coordinate axes along which v may move (allows() says how far).
  std::array<bool, 3> axes() const;
  /// What v moves in, and the mean normal of its faces there; nothing if it is held exactly.
  const spatial::Envelope* envelope() const { return envelope_; }
  Vec3 normal() const;

 private:
  /// A vertex beside v, or beside a copy of v and then seen from v.
  struct Beside {
    Index vertex = no_index, copy = no_index;
    Index name = no_index;  ///< the same for all its copies
    friend bool operator==(const Beside& x, const Beside& y) { return x.name == y.name; }
    friend bool operator<(const Beside& x, const Beside& y) { return x.name < y.name; }
  };
  /// A face (v,p,q).
  struct Face {
    Beside p, q;
    std::size_t sheet;
  };
  void read_faces(Dart copy);
  void drop_repeated_faces();
  bool stays_inside(const Vec3& p, Index merged) const;
  void read_curves(Dart copy);
  Beside beside(Index copy, Index vertex) const { return {vertex, copy, work_.name(vertex)}; }
  bool join_sheets();
  bool is_curve_end(const Beside& p) const { return p == curve_[0] || p == curve_[1]; }
  bool curve_is_straight() const;
  bool sheets_are_plane() const;
  bool allows(const Vec3& p, Index merged) const;
  Vec3 point(const Beside& b) const { return work_.seen_from(v_, b.copy, b.vertex); }

  const Workspace& work_;
  Flatness flatness_;
  Index v_ = no_index;
  std::vector<Face> faces_;
  std::array<Beside, 2> curve_{};  ///< the neighbours along the curve
  std::size_t n_curve_edges_ = 0;
  const spatial::Envelope* envelope_ = nullptr;
  bool is_exact_ = false;  ///< a wall is, or walls are in different envelopes
  DartBuffer copies_, star_;
  std::vector<Beside> seen_;
};

/// Whether the edge a-b of faces (a,b,x) and (a,b,y) may be replaced by x-y without changing the set of
/// points: the four points are coplanar, and the quadrangle a x b y is strictly convex.
bool may_exchange_diagonals(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y,
                            Flatness flatness = {});

/// Whether the faces (a,b,x) and (a,b,y) lie in one plane, on different sides of a-b.
bool lies_flat(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y, Flatness flatness = {});

/// Whether they do, and replacing the middle of a-b by a vertex at m leaves their set of points unchanged,
/// exactly.
bool lies_flat_split_at(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y, const Vec3& m);

}  // namespace multimesh::improvement
