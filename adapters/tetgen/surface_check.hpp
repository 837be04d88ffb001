// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "adapters/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

/// Whether the triangles bound a volume, as far as it can be told without looking for intersections: points
/// that are used are finite and distinct, triangles have area and differ, every edge has just two of them,
/// which agree in their orientation. Cost: sorting. \throw InputError naming the first element that is wrong,
/// numbers counted from 0
void check_closed_surface(std::span<const Point> points, const FacetList& triangles);

}  // namespace multimesh::tetgen
