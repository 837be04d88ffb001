// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// A surface with tagged edges and tagged vertices: its embedded substructures.
struct TaggedSurface {
  Complex mesh;
  SimplexSet edges;     ///< the tagged edges S, edges of the mesh
  SimplexSet vertices;  ///< tagged vertices: points that must stay distinct points of their own
};

/// How the boundary of the surface and the tags are seen.
enum class Strata {
  kJoint,     ///< boundary and tags are one stratified set: they must not get into a new contact either
  kSeparate,  ///< the surface and S each keep their type, and S its place in the surface; contacts of S with
              ///< the boundary may change
};

/// The link condition for embedded substructures, on tags: Vivodtzev, Bonneau, Hahmann, Hagen, "Substructure
/// topology preserving simplification of tetrahedral meshes" (2010), for a triangle mesh K with tagged edges
/// S and tagged vertices P. The idea there: make the substructures visible to the conditions of Dey,
/// Edelsbrunner, Guha and Nekhayev, "Topology preserving edge contraction" (1999), for a non-manifold
/// 2-complex, by attaching dummy simplices to them, so that the simplices of a substructure get a higher
/// order. Formulation used here:
///
/// kJoint. B1 = closure(∂K ∪ S ∪ P), the simplices of order >= 1. B2 = the vertices of B1 of order 2: those
/// in P, and those at which the edges of B1 are not exactly two of one kind (kinds: boundary untagged,
/// boundary tagged, interior tagged). With dummy vertices ω0, ω1 and ω0*X the cone on X,
///     Lk0 = link in K ∪ ω0*B1,   Lk1 = link in B1 ∪ ω1*B2,
///     (0)  Lk0 a ∩ Lk0 b = Lk0 ab,     (1)  Lk1 a ∩ Lk1 b = ∅.
/// (0) keeps the surface and refuses an edge that joins two points of B1 without being in B1, and a triangle
/// with all three edges in B1; (1) keeps B1 a graph of the same type.
///
/// kSeparate. The boundary and S have dummy vertices of their own; B = closure(S ∪ P), B2 = P and the
/// vertices of B in other than two edges of S:
///     (0)  links in K ∪ ω∂*∂K ∪ ω0*B, as above,     (1)  links in B ∪ ω1*B2, as above.
///
/// Judged is the contraction of the edge (a,b) of the mesh. \return whether it is allowed
bool substructure_link_condition(const TaggedSurface& surface, int a, int b, Strata strata);

}  // namespace multimesh::oracle
