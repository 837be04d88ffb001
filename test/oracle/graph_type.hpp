// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// Mixes a value into a hash (splitmix64).
std::uint64_t mix(std::uint64_t hash, std::uint64_t value);

/// An edge of a graph drawn on a host.
struct LabelledEdge {
  int from = 0;
  int to = 0;
  std::uint64_t label = 0;     ///< kind of the edge
  std::uint64_t ordinary = 0;  ///< the label of a vertex inside an arc of such edges
};

/// A graph: vertex -> label, and edges. Vertices without edges are allowed.
struct LabelledGraph {
  std::map<int, std::uint64_t> vertices;
  std::vector<LabelledEdge> edges;
};

/// The topological type of a labelled graph. A vertex is smoothed away when it has exactly two edges, both of
/// one label, and its own label is their `ordinary` one; the others are essential. What remains is a
/// multigraph of arcs between essential vertices, and closed curves without any. The result is, per
/// component, the number of essential vertices and arc ends and a hash of it, sorted; then the sorted labels
/// of the closed curves.
///
/// The hash is Weisfeiler-Lehman refinement of labels of vertices, arcs and neighbours until it is stable,
/// with each vertex that still looks like another one individualized once more. Equal types give equal
/// results. Different ones give different results but for 64-bit collisions and graphs that this refinement
/// cannot separate (it separates theta from dumbbell; ones it does not, strongly regular graphs say, have
/// more vertices than a complex of 60 facets makes likely). The cyclic order of arcs at a vertex is not part
/// of it.
Signature graph_type(const LabelledGraph& graph);

}  // namespace multimesh::oracle
