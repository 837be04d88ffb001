// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <vector>

namespace multimesh::openmesh {

/// Saves the connectivity around a vertex, to restore it after OpenMesh has collapsed an edge at it: every
/// word that PolyConnectivity::collapse writes, status bits included. Buffers are reused.
class SavedStar {
 public:
  explicit SavedStar(OpenMesh::PolyConnectivity& mesh) : mesh_(mesh) {}

  /// \pre `vertex` has edges. Cost: that of its star
  void save(OpenMesh::VertexHandle vertex);
  /// Restores everything. \pre save() was called, and since then only an edge from the vertex was
  /// collapsed
  void restore();

 private:
  using Bits = unsigned;
  struct Halfedge {
    OpenMesh::HalfedgeHandle h, next, prev;
    OpenMesh::VertexHandle to;
    OpenMesh::FaceHandle face;
    Bits edge_status = 0, status = 0;
  };
  struct Vertex {
    OpenMesh::VertexHandle v;
    OpenMesh::HalfedgeHandle halfedge;
    Bits status = 0;
  };
  struct Face {
    OpenMesh::FaceHandle f;
    OpenMesh::HalfedgeHandle halfedge;
    Bits status = 0;
  };
  void add(OpenMesh::HalfedgeHandle h);
  void add(OpenMesh::VertexHandle v);
  void add(OpenMesh::FaceHandle f);

  OpenMesh::PolyConnectivity& mesh_;
  std::vector<Halfedge> halfedges_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
};

}  // namespace multimesh::openmesh
