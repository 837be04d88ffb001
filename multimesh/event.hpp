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
  double t;      ///< the position of `vertex`: the point (1-t) a + t b
  NodeId node;
  Index above;  ///< the image of `vertex` in the parent's mesh; no_index in the root
};

/// What an operation did to simplices of dimension 1 and more of one mesh, where they have lasting indices
/// (Mesh::stores). Values of dead simplices can still be read.
struct SimplexChange {
  enum class Kind : std::uint8_t {
    halved,   ///< split: `first` is the half at a, `second` the half at b; one of them has the index of
              ///< `whole`
    merged,   ///< collapse: `second` died; it and `first` are one simplex now
    fresh,    ///< split: `first` is new, and not part of a simplex of its dimension
    swapped,  ///< swap: `first` is the new edge in place of the old one (`second`: itself), or the facet that
              ///< lost b of the facets a-b-l, b-a-r, and `second` the one that lost a
  };
  NodeId node;
  int k;
  Kind kind;
  Index first, second = no_index;
  Index whole = no_index;  ///< halved: which of the two has the value
  /// Merged: the values of `second` take precedence over those of `first`, because `second` lies in a mesh of
  /// dimension k below and `first` does not. Found only for Attribute::needs_kept.
  bool second_wins = false;
  double share = 0;  ///< merged: the part of `second` in the simplex, 0 .. 1
};

/// The value of a corner (Mesh::corner) that an operation moved to another place. All `from` of one copy are
/// read before any `to` is written.
struct CornerChange {
  NodeId node;
  std::uint32_t copy;
  Index to, from;
  /// At the new vertex of a split: the corners of the whole facet at a and b. Else no_index.
  Index a = no_index, b = no_index;
};

struct Changes {
  std::vector<SimplexChange> simplices;
  std::vector<CornerChange> corners;
};

/// An operation as attributes and invariants see it: its edge (or vertex) in every mesh.
///
/// Before the operation, the darts are (a, b, ...) of each copy of the edge. After a split they are (a, c,
/// ...), after a collapse and a relocation darts at the vertex, after a swap (l, r, ...).
struct Event {
  const MultiMesh& tree;
  Operation operation;
  const Copies& copies;
  /// Where on the edge the new or merged vertex lies: the point (1-t) a + t b, the same in every mesh, so
  /// that attributes stay consistent. Attributes with a rule of their own may go elsewhere: ask them
  /// (VertexAttribute::result). 0 <= t <= 1.
  double t = 0.5;
  /// Of simplices and corners, after all meshes have changed; kept only if an attribute has values there.
  const Changes* changes = nullptr;

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
