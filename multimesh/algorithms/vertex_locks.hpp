// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// Locks the ends of edges of a surface during its lifetime: of boundary edges, if requested, and of edges
/// with any of the given kinds of curve.
class VertexLocks {
 public:
  VertexLocks(TexturedSurface& surface, bool boundary, CurveKinds curves);
  ~VertexLocks();
  VertexLocks(const VertexLocks&) = delete;
  VertexLocks& operator=(const VertexLocks&) = delete;

 private:
  void lock(Index v);

  TexturedSurface& surface_;
  const Mesh& root_;
  std::vector<Index> locked_;
};

}  // namespace multimesh
