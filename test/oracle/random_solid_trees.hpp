// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "oracle/random_solid.hpp"
#include "oracle/random_trees.hpp"

namespace multimesh::oracle {

/// Shape of a random tree below a tetrahedral mesh. "<-" means "is parent of".
enum class SolidTreeKind {
  kCurve,            ///< 0 <- curve
  kSurface,          ///< 0 <- surface, cut where it is no surface
  kSurfaceGuarded,   ///< as kSurface, and 0 <- curve on its singular edges, cut at their corners, and 0 <-
                     ///< points where it is singular and no curve is
  kSurfacesGuarded,  ///< 0 <- surface, 0 <- surface, and 0 <- curve and 0 <- points as above of both together
  kCurveOfSurface,   ///< 0 <- surface <- curve
  kBoundary,         ///< 0 <- all its boundary <- curve, 0 <- curve
  kPart,             ///< 0 <- some tetrahedra, cut <- their boundary
  kSolids,           ///< 0 <- all tetrahedra, cut <- a part, cut further
  kMixed,            ///< 0 <- part <- boundary; 0 <- surface <- curve <- curve; 0 <- curve
  kPoints,           ///< 0 <- points
  kPointsOfCurve     ///< 0 <- surface <- curve <- points; 0 <- part <- points; 0 <- points
};
inline constexpr int kNumberOfSolidTreeKinds = 11;

std::string to_string(SolidTreeKind kind);
std::string to_string(Solid kind);

/// A deterministic random tree, valid, with orientable meshes. Sizes that are smaller than the base solid are
/// not reached.
Tree random_solid_tree(std::uint64_t seed, SolidTreeKind kind, Solid root, const TreeOptions& options = {});

}  // namespace multimesh::oracle
