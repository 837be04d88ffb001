// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "multimesh/tetgen/facets.hpp"

namespace multimesh::tetgen {

/// Checks whether triangles can be tetrahedralized, as far as their points show: the points exist, are
/// finite, distinct and extend over three axes. Cost: sorting. \throw InputError naming the first element
/// that is wrong, numbers counted from 0
void check_points(std::span<const Point> points, const FacetList& triangles);

/// An edge with only one facet, in words, where facets do not close up; empty if there is none.
std::string first_open_edge(const Facets& facets);

}  // namespace multimesh::tetgen
