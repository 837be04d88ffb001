// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/domains/periodic_domain/labelled_tile.hpp"
#include "multimesh/domains/periodic_domain/vertex_classes.hpp"

namespace multimesh {

/// The sizes of the box that the vertices fill, without the noise of those in its sides.
Vec3 box_without_noise(std::span<const Vec3> points, std::span<const Index> used, double diagonal);

/// Moves copies to where they belong: to the place of their representative plus the lattice vector. Those
/// that fit but for rounding stay: a tile that was written is read as it was, with its thinnest facets.
/// Coordinates in which the lattice vector is 0 become the same bits. Sides that lie in a plane of two axes
/// but for noise come to lie in it exactly.
/// \return the largest distance of a copy from its place, relative to the diagonal
double fit_copies(LabelledTile& tile, const Lattice& lattice, VertexClasses& classes, double diagonal);

}  // namespace multimesh
