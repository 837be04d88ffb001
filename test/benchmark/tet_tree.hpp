// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>

#include "multimesh/operations.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::bench {

/// Which children a tree has, besides positions on the root.
enum TetChildren : unsigned {
  tets_alone = 0,
  outer_surface = 1,  ///< the boundary of the cube
  inner_surface = 2,  ///< a closed surface inside, of about n*n*12 triangles
  inner_curve = 4,    ///< a closed curve on it
};

/// A cube of n^3 cubes of six tetrahedra each (Kuhn), with positions.
class TetTree {
 public:
  TetTree(Index n, unsigned children);

  const tet::TetMesh& root() const { return *root_; }
  MultiMesh& tree() { return *tree_; }
  Propagation& operations() { return *operations_; }
  VertexAttribute<Eigen::Vector3d>& positions() { return *positions_; }

 private:
  const tet::TetMesh* root_;
  std::unique_ptr<MultiMesh> tree_;
  std::unique_ptr<Propagation> operations_;
  std::unique_ptr<VertexAttribute<Eigen::Vector3d>> positions_;
};

}  // namespace multimesh::bench
