// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimate.hpp"

namespace multimesh::decimation {

/// Locks the vertices that the options say, as long as it lives.
class VertexLocks {
 public:
  VertexLocks(TexturedSurface& surface, const DecimateOptions& options);
  ~VertexLocks();
  VertexLocks(const VertexLocks&) = delete;
  VertexLocks& operator=(const VertexLocks&) = delete;

 private:
  void lock(Index v);

  TexturedSurface& surface_;
  const Mesh& root_;
  std::vector<Index> locked_;
};

}  // namespace multimesh::decimation
