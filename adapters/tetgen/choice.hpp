// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adapters/tetgen/filling.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// Which regions are filled, and their names.
struct Choice {
  std::vector<bool> kept;          ///< per region
  std::vector<int> winding;        ///< per region
  std::vector<std::string> names;  ///< per region, by its seed; empty: none
  std::vector<std::string> warnings;
};

/// Decides by seeds, or else by winding numbers. \throw InputError if nothing is enclosed or left, or if a
/// seed is outside, on a facet, or contradicts another one
Choice choose(const Filling& filling, const Facets& facets, const TetrahedralizeOptions& options);

/// Per facet, whether no kept region is at it.
std::vector<bool> without_region(const std::vector<Sides>& sides, const std::vector<bool>& kept);

/// A point in each region that is not kept.
std::vector<Point> hole_points(const Filling& filling, const std::vector<bool>& kept);

}  // namespace multimesh::tetgen
