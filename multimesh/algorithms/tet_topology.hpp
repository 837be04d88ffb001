// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "multimesh/domains/tet_domain.hpp"

namespace multimesh {

/// Tetrahedra as a file lists them: joined at the points that they share, manifold or not. (A TetDomain cuts
/// them where they are not manifold.) Each simplex is counted once; unused points are not counted.
struct TetTopology {
  std::size_t vertices = 0, edges = 0, faces = 0, tets = 0;
  std::size_t components = 0;       ///< connected, possibly at only one point
  std::size_t face_components = 0;  ///< connected through faces
  long euler_characteristic = 0;
  long handles = 0;   ///< the first Betti number
  long cavities = 0;  ///< the second one; right for tetrahedra that do not overlap

  std::size_t boundary_faces = 0;  ///< faces of one tetrahedron
  std::size_t crowded_faces = 0;   ///< faces of three or more
  std::size_t pinched_edges = 0;   ///< with at least one boundary face, but not exactly two
  std::size_t boundary_components = 0;
  long boundary_euler_characteristic = 0;
  double boundary_area = 0;

  std::map<TetDomain::Tag, double> volumes;  ///< by region; inverted tetrahedra count as negative
};

/// Cost: sorting
TetTopology topology_of(const TaggedTetrahedra& tets);

/// Differences that no change of the mesh of one domain may cause, one sentence each: numbers of components,
/// handles, cavities, pinched edges and so on; the area of the boundary; the volumes.
/// \param rounding how far points may have been displaced, for instance by rounding; area and volumes may
/// differ by as much as that can change them
std::vector<std::string> differences(const TetTopology& before, const TetTopology& after, double rounding);

/// Points that lie in the middle of an edge or a face of the boundary without being a corner of it, up to
/// 1e-12 of the diagonal of the bounding box: two sides of the mesh do not conform there. Ascending. Cost: n
/// log n for well-spread points
std::vector<Index> hanging_points(const TaggedTetrahedra& tets);

}  // namespace multimesh
