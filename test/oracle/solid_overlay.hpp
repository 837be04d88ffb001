// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "oracle/overlay.hpp"

namespace multimesh::oracle {

/// overlay_type() for a host of dimension 3.
///
/// - `regions`: Betti numbers of all images together, of the host relative to them (by duality those of the
///   complement), and of what every two images have in common; with `host_boundary` all of these also with
///   the boundary of the host as one more image.
/// The *cut* consists of curve layers, surface layers, and for layers of dimension 3 the triangles between
/// covered and uncovered tetrahedra and those with a number of preimages other than one.
/// - `graph`: edges of the cut that are not inside a surface, with the triangles of the cut around them by
///   their labels, and points that are not inside a curve or surface, with the type of the cut around them;
///   see graph_type(). Labels are numbers of preimages per layer, and with `host_boundary` whether it lies on
///   the boundary of the host;
/// - `closures`: Betti numbers of each image.
///
/// Equal types do not mean homeomorphic pairs: knots, for one, are not looked at.
OverlayType solid_overlay_type(const Complex& host, const std::vector<Layer>& layers, bool host_boundary);

/// Where the images of layers are not locally one curve or one surface: the edges of the graph above, and
/// its points. `isolated`: points on none of the edges.
struct SingularSet {
  SimplexSet edges;
  std::vector<int> corners;   ///< points that do not continue the same kind of edge, ascending
  std::vector<int> isolated;  ///< ascending
};
SingularSet singular_set(const Complex& host, const std::vector<Layer>& layers, bool host_boundary);

}  // namespace multimesh::oracle
