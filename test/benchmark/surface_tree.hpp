// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <optional>

#include "multimesh/operations.hpp"
#include "test/benchmark/charted_shape.hpp"

namespace multimesh::bench {

/// The mesh of an OpenMesh user.
struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

SurfaceMesh surface_mesh(const test::Shape& shape);

/// Which children a surface has.
enum Children : unsigned { alone = 0, texture = 1, seams = 2, boundary = 4 };

/// A user's mesh as the root of a tree, with positions; a texture child carries texture coordinates.
class SurfaceTree {
 public:
  SurfaceTree(const ChartedShape& charted, unsigned children);

  const Mesh& root() const { return tree_->mesh(NodeId::root); }
  const MultiMesh& tree() const { return *tree_; }
  const std::vector<OpenMesh::Vec3d>& positions() const { return positions_->values(); }
  VertexAttribute<OpenMesh::Vec3d>& position_attribute() { return *positions_; }
  Propagation& operations() { return *operations_; }

  /// Memory of the containment maps: anchors of all children and links of their parents.
  std::size_t map_bytes() const;

 private:
  void add_texture(const ChartedShape& charted);
  void add_seams(const ChartedShape& charted);

  SurfaceMesh mesh_;
  std::optional<MultiMesh> tree_;
  std::optional<VertexAttribute<OpenMesh::Vec3d>> positions_;
  std::optional<VertexAttribute<OpenMesh::Vec2d>> texcoords_;
  std::optional<Propagation> operations_;
};

}  // namespace multimesh::bench
