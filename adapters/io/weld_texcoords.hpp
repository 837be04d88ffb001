// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/io/weld_surface.hpp"

namespace multimesh::io {

/// The part of weld_surface that joins nearly equal texture coordinates; what it finds goes to the report.
void weld_texcoords(PolygonSoup& soup, double tolerance, SurfaceWeldReport& report);

}  // namespace multimesh::io
