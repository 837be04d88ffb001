// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

struct WeldReport {
  std::size_t points = 0;     ///< joined with another one, and removed
  std::size_t collapsed = 0;  ///< simplices of which two corners were joined, left out
  std::size_t doubled = 0;    ///< simplices that now equal another one, left out
};

/// Joins points at one place (coincident_points). Simplices that get the same points become one, in the
/// groups of both. Points that no simplex names are removed.
WeldReport weld_points(SimplexSoup& soup, double tolerance = 0);

}  // namespace multimesh::io
