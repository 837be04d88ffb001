// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// A surface as a reader of the written file will find it: copies of one input vertex are one again, and
/// texture coordinates of equal values at one vertex are one.
struct SurfaceTopology {
  std::size_t vertices = 0, edges = 0, faces = 0, components = 0;
  long euler_characteristic = 0;
  std::size_t boundary_loops = 0;
  std::size_t crowded_edges = 0;  ///< with three or more faces
  std::size_t closed_seams =
      0;  ///< seam edges, of all sets, whose two sides have the same texture coordinates
};

/// Cost: linear, except for edges between copies, which are sorted.
SurfaceTopology topology_of(const TexturedSurface& surface);

/// The differences, one sentence each. Numbers of simplices do not count.
std::vector<std::string> differences(const SurfaceTopology& before, const SurfaceTopology& after);

}  // namespace multimesh
