// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/copy.hpp"

namespace multimesh {

enum class Operation : std::uint8_t { split, collapse, flip, relocate };

/// What happened, or would happen, to the vertices of one copy. Values stored at a dead vertex can still be
/// read.
struct VertexChange {
  Index a, b;    ///< the ends of the edge in this mesh, before
  Index vertex;  ///< the new vertex (split), the surviving one (collapse: a or b), the moved one (a == b)
  double t;      ///< it is the point (1-t) a + t b
  NodeId node;
  Index above;  ///< the image of `vertex` in the parent's mesh; no_index in the root
};

/// An operation as attributes and invariants see it: which edge (or vertex) it is, in every mesh.
///
/// Before: the darts are (a, b, ...) of each copy of the edge. After a split they are (a, c, ...), after a
/// collapse and a relocation darts at the vertex, after a flip (l, r, ...).
struct Event {
  const MultiMesh& tree;
  Operation operation;
  const Copies& copies;
  /// Where on the edge the new or merged vertex lies: the point (1-t) a + t b, in every mesh the same, so
  /// that attributes never come apart. Those with a rule of their own may go elsewhere: ask them
  /// (VertexAttribute::result). 0 <= t <= 1.
  double t = 0.5;

  /// Before a collapse: what it will do to copy i, whose end b survives.
  VertexChange collapse_of(std::size_t i) const {
    const Copy& c = copies[i];
    const Index b = end_b(c);
    return {tree.mesh(c.node).vertex(c.dart),
            b,
            b,
            t,
            c.node,
            c.node == NodeId::root ? no_index : end_b(copies[c.above])};
  }

 private:
  Index end_b(const Copy& c) const {
    const Mesh& mesh = tree.mesh(c.node);
    return mesh.vertex(mesh.reorder(c.dart, exchange_ends));
  }
};

}  // namespace multimesh
