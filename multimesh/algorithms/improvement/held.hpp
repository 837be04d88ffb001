// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/improve.hpp"

namespace multimesh::improvement {

/// What must stay, as seen from the tetrahedra: faces of the surface, of the boundary and between regions;
/// edges of the curves; locked vertices and those of locked faces and regions.
class Held {
 public:
  enum Stratum : std::uint8_t {
    on_face = 1,   ///< a held face contains the vertex
    on_curve = 2,  ///< a curve passes through it
    fixed = 4,     ///< nothing may be done to it: a point, locked, the end of a curve or of a copied edge, or
                ///< where curves meet
  };

  Held(const TetDomain& domain, const ImproveOptions& options);

  std::uint8_t strata(Index v) const { return strata_[v]; }
  bool is_free(Index v) const { return strata_[v] == 0; }
  bool is_fixed(Index v) const { return strata_[v] & fixed; }
  /// Of a new vertex.
  void set(Index v, std::uint8_t strata) {
    if (v >= strata_.size()) strata_.resize(v + v / 2 + 1, 0);
    strata_[v] = strata;
  }

  /// Whether the face of (x,y,z,..) is held. Cost: a look-up in a table if all its corners are on held faces.
  bool face(Dart f) const;
  /// Whether the edge of (x,y,..) is on a curve.
  bool curve(Dart e) const;
  /// Of a locked region, or required by the input.
  bool is_locked_tet(Index t) const;
  /// Whether a held face is locked: neither it nor its sides may be split or swapped.
  bool is_locked_face(Dart f) const;
  /// Whether the edge of (x,y,..) is required by the input, or has copies or is a side of a face that has,
  /// see TetDomain: it must stay.
  bool is_locked_edge(Dart e) const;

 private:
  bool is_held_face(Dart f) const;
  void hold_faces();
  void hold_curves();

  const TetDomain& domain_;
  const tet::TetMesh& mesh_;
  std::vector<TetDomain::Tag> locked_regions_, locked_patches_;  // sorted
  bool lock_surface_;
  std::vector<std::uint8_t> strata_;
};

}  // namespace multimesh::improvement
