// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::files {

/// The polylines of a file as a graph.
struct PolylineReport {
  CurveReport curves;
  std::size_t vertices = 0;
  std::size_t collapsed = 0;  ///< edges from a vertex to itself, left out
};

PolylineReport report_polylines(const io::PolygonSoup& soup);

}  // namespace multimesh::files
