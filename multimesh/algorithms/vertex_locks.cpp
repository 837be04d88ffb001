// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/vertex_locks.hpp"

namespace multimesh {

VertexLocks::VertexLocks(TexturedSurface& surface, bool boundary, CurveKinds curves)
    : surface_(surface), root_(surface.tree().mesh(NodeId::root)) {
  if (!boundary && curves == no_curve) return;
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    const Dart d = root_.dart_of(1, e);
    if (!(boundary && root_.is_boundary(d, 1)) && !(surface.curve_kinds(d) & curves)) continue;
    for (const Dart end : {d, root_.switch_dart(d, 0)}) lock(root_.vertex(end));
  }
}

VertexLocks::~VertexLocks() {
  for (const Index v : locked_)
    if (root_.is_live(0, v)) surface_.set_locked(v, false);
}

void VertexLocks::lock(Index v) {
  if (root_.is_locked(v)) return;
  surface_.set_locked(v, true);
  locked_.push_back(v);
}

}  // namespace multimesh
