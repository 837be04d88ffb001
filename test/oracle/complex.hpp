// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "oracle/simplex.hpp"

/// Brute-force topology on plain data, independent of the library that it judges. For complexes of at most
/// some 60 facets. Everything is a pure function and may be called from several threads.
namespace multimesh::oracle {

/// The vertices of a facet in some order; edges and triangles leave the last entries unused.
using Facet = std::array<int, 4>;

/// A pure simplicial complex of dimension 0 to 3, given by its facets. Vertices are arbitrary ints other than
/// kOmega; the first dim + 1 entries of a facet count, the others are ignored.
struct Complex {
  int dim = 2;
  std::vector<Facet> facets;
};

/// A mesh of a tree with its containment map.
struct TreeNode {
  Complex mesh;
  int parent = -1;           ///< index of the parent; -1 for the root
  std::map<int, int> image;  ///< vertex of this mesh -> vertex of the parent; empty for the root
};

/// A multimesh: nodes[0] is the root, parents come before their children.
struct Tree {
  std::vector<TreeNode> nodes;
};

/// The dummy vertex to which boundaries are coned. Smaller than any vertex.
inline constexpr int kOmega = std::numeric_limits<int>::min();

/// A comparable value; equal values mean the same topological type (see the functions that return it).
using Signature = std::vector<std::int64_t>;

/// The facet as a vertex set; of fewer vertices than dim + 1 when it is degenerate.
Simplex facet_simplex(const Complex& c, std::size_t facet);

/// All facets as a set: duplicates appear once.
SimplexSet facet_set(const Complex& c);

std::vector<int> vertices(const Complex& c);

/// All simplices, of every dimension or of dimension k only.
SimplexSet simplices(const Complex& c);
SimplexSet simplices(const Complex& c, int k);

/// The simplices of K that contain s (s itself included).
SimplexSet star(const SimplexSet& K, const Simplex& s);

/// The simplices t of K, disjoint from s, with s ∪ t in K.
SimplexSet link(const SimplexSet& K, const Simplex& s);

/// The closure of the (dim-1)-simplices that lie in exactly one facet; empty for dim 0.
SimplexSet boundary(const Complex& c);

/// K ∪ {omega} ∪ omega*B: the complex with the subcomplex B coned to `omega`; K itself when B is empty.
SimplexSet with_cone(const SimplexSet& K, const SimplexSet& B, int omega = kOmega);

/// Lk a ∩ Lk b == Lk ab with the boundary coned to omega (Dey, Edelsbrunner, Guha, Nekhayev 1999), by sets.
/// On a manifold: the contraction of ab gives a homeomorphic manifold.
///
/// \pre ab is an edge
bool link_condition(const Complex& c, int a, int b);

/// Number of simplices, alternating by dimension.
int euler_characteristic(const Complex& c);

int number_of_components(const Complex& c);

/// Lengths of the boundary loops, ascending. At a pinched vertex loops are those of the surface in which the
/// vertex has been cut apart.
///
/// \pre dim 2, every edge in at most two facets
std::vector<int> boundary_loops(const Complex& c);

/// Vertices in exactly one edge.
///
/// \pre dim 1
std::vector<int> boundary_points(const Complex& c);

/// Why the complex is no manifold: facet degenerate, facet twice, three facets at a side, link of a vertex
/// not one circle or one path (dim 1: more than two edges at a vertex; dim 3: not a sphere or a disk), or
/// empty. Empty text for a manifold.
std::string manifold_error(const Complex& c);
bool is_manifold(const Complex& c);

/// Whether all facets can be oriented consistently; true for dim 0 and 1.
bool is_orientable(const Complex& c);

/// The homeomorphism type of a manifold: for every component (Euler characteristic, number of boundary loops
/// or points, orientable), sorted; of points, how many. Complete by the classification of surfaces and of
/// curves. In dimension 3, see solid.hpp, it is not.
Signature signature(const Complex& c);

}  // namespace multimesh::oracle
