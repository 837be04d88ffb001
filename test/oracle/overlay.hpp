// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// A mesh and where it lies in a host.
struct Layer {
  const Complex* mesh = nullptr;
  std::map<int, int> map;  ///< vertex of the mesh -> vertex of the host
};

/// The topological type of a host with embedded images, in three independent parts.
struct OverlayType {
  Signature regions;   ///< what the host falls into when cut along the images
  Signature graph;     ///< the cut graph (host of dimension 1: the whole host)
  Signature closures;  ///< of each 2-dimensional layer: type of its image and of its pinched vertices

  friend bool operator==(const OverlayType&, const OverlayType&) = default;
};

/// The type of the images of `layers` in `host`, jointly.
///
/// Host of dimension 2. Cut edges are: for a curve layer the edges with a preimage; for a surface layer the
/// interior edges with exactly one covered facet, or with two covered facets and a number of preimages other
/// than one (a seam has two). The host is cut along them; each *region* gives (Euler characteristic, boundary
/// loops, orientable, which layers cover it). The *graph* consists of the cut edges. Its vertices carry, per
/// layer, the number of preimages, and whether they lie on the boundary of the host; its edges carry the same
/// and the types of the regions on both sides; see graph_type(). A vertex under a point layer that is on no
/// cut edge is one more vertex, with the type of the region that it lies in.
///
/// `host_boundary` false: every boundary loop of the host is first closed by a cone, which no layer covers,
/// so that an image may come to touch the boundary of the host, or leave it, unseen. The boundary of a
/// surface layer is then part of the cut graph everywhere.
///
/// Host of dimension 0 or 1: no regions; the graph is the host, with preimage counts on vertices and edges;
/// without `host_boundary` it is first lengthened at its ends.
///
/// Host of dimension 3: see solid_overlay.hpp.
OverlayType overlay_type(const Complex& host, const std::vector<Layer>& layers, bool host_boundary = true);

}  // namespace multimesh::oracle
