// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <vector>

namespace multimesh::openmesh {

/// The connectivity around a vertex, to be put back after OpenMesh has collapsed an edge at it: every word
/// that PolyConnectivity::collapse writes, status bits included. Buffers are re-used.
class SavedStar {
 public:
  explicit SavedStar(OpenMesh::PolyConnectivity& mesh) : mesh_(mesh) {}

  /// \pre `vertex` has edges. Cost: that of its star
  void save(OpenMesh::VertexHandle vertex);
  /// Everything as it was. \pre save() was called, and nothing but a collapse of an edge from the vertex done
  /// since
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
