// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>

#include "oracle/complex.hpp"
#include "oracle/random_surface.hpp"

namespace multimesh::oracle {

/// Shape of a random tree. Node 0 is always a random surface; "<-" means "is parent of".
enum class TreeKind {
  kCurve,         ///< 0 <- curve
  kTwoCurves,     ///< 0 <- curve, 0 <- curve
  kUv,            ///< 0 <- surface with all facets, cut along random edges
  kUvPatch,       ///< 0 <- surface with some of the facets, cut
  kUvRootSeam,    ///< as kUv or kUvPatch, and 0 <- curve on the seam graph, cut at its corners: the guard
  kUvSeam,        ///< as kUv or kUvPatch, and 1 <- curve on the edges over the seam graph
  kCurveOfCurve,  ///< 0 <- curve <- some of its edges, further cut
  kUvOfUv,        ///< 0 <- surface <- the same or a part, cut further
  kCurveOfUv,     ///< 0 <- surface <- random curve
  kMixed,         ///< 0 <- surface (<- seam curve), 0 <- curve (<- curve): five meshes
  kPoints,        ///< 0 <- points
  kPointsOfUv,    ///< 0 <- surface <- points, 0 <- points
  kPointsOfCurve  ///< 0 <- curve <- points <- points, 0 <- points
};
inline constexpr int kNumberOfTreeKinds = 13;

std::string to_string(TreeKind kind);
/// Used by GoogleTest, which would otherwise print the bytes of a parameter.
inline void PrintTo(TreeKind kind, std::ostream* out) {
  *out << to_string(kind);
}
std::string to_string(Surface kind);

struct TreeOptions {
  std::size_t min_facets = 8;   ///< of the root
  std::size_t max_facets = 30;  ///< of the root (more only where the surface needs more: the torus 14)
};

/// A deterministic random tree: the same for the same arguments on every platform; tree_error() is empty.
Tree random_tree(std::uint64_t seed, TreeKind kind, Surface root, const TreeOptions& options = {});

/// Kind and surface chosen by the seed as well.
Tree random_tree(std::uint64_t seed, const TreeOptions& options = {});

/// Random edges of a mesh of dim 1 or 2, at least one: single edges, walks, and rings around a vertex.
SimplexSet random_edges(const Complex& mesh, std::mt19937_64& rng);

/// Random vertices of a mesh, ascending, at least one.
std::vector<int> random_points(const Complex& mesh, std::mt19937_64& rng);

/// A random root edge.
///
/// \pre the tree is valid
Simplex random_root_edge(const Tree& tree, std::mt19937_64& rng);

}  // namespace multimesh::oracle
