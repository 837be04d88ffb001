// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/vertex_locks.hpp"

#include "multimesh/algorithms/decimation/strata.hpp"

namespace multimesh::decimation {

VertexLocks::VertexLocks(TexturedSurface& surface, const DecimateOptions& options)
    : surface_(surface), root_(surface.tree().mesh(NodeId::root)) {
  if (!options.lock_boundary && !options.lock_seams) return;
  const CurveKinds seams = options.lock_seams ? seam_kinds(surface) : CurveKinds{no_curve};
  for (Index e = 0; e < root_.capacity(1); ++e) {
    if (!root_.is_live(1, e)) continue;
    const Dart d = root_.dart_of(1, e);
    if (!(options.lock_boundary && root_.is_boundary(d, 1)) && !(surface.curve_kinds(d) & seams)) continue;
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

}  // namespace multimesh::decimation
