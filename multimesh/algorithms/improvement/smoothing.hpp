// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "multimesh/algorithms/improvement/amips.hpp"

namespace multimesh::improvement {

/// A triangle (p,q,r) seen from a vertex v: (v,p,q,r) is a tetrahedron of positive orientation.
using Opposite = std::array<Vec3, 3>;

/// The coordinate axes along which the vertex may move.
using Axes = std::array<bool, 3>;

/// The best place of a vertex among its tetrahedra: minimizes the sum of the cubes of their AMIPS energies,
/// which the worst of them dominates, by Newton's method with the exact gradient and Hessian and a
/// backtracking line search that stays where all are positive. Starts from `start`, or, if one is inverted or
/// flat there in floating point, from the mean of the corners around. \return the place; `start` if there
/// was no gain. Cost: up to 10 steps of some 100 ns per tetrahedron
/// \param across a unit vector: the vertex moves in the plane across it only
/// \param sharpness power of the cubed energies: the higher, the more the worst one dominates
Vec3 best_place(const Vec3& start, const std::vector<Opposite>& around, Axes axes = {true, true, true},
                int sharpness = 1, const std::optional<Vec3>& across = {});

/// The greatest cubed energy of the tetrahedra (v,p,q,r); +infinity if one does not have positive
/// orientation, exactly. Once it reaches `limit`, stops and returns any number from `limit` on.
double worst_quality(const Vec3& v, const std::vector<Opposite>& around, double limit);

}  // namespace multimesh::improvement
