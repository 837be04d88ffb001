// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/geometry/vector.hpp"
#include "multimesh/multi_mesh.hpp"

namespace multimesh::openmesh {

/// Triangles of a surface, with a texture coordinate at each corner.
struct TexturedCorners {
  std::vector<Index> corners;   ///< vertices of the surface, three per triangle
  std::vector<Index> facets;    ///< per triangle, the facet of the surface
  std::vector<Index> texcoord;  ///< per corner, into a list of values
};

struct TextureChild {
  NodeId node;
  std::vector<Index> texcoord;  ///< per vertex of the child, into the list of values
};

/// Adds the texture of a surface as a child. Its vertices are the classes of corners with the same vertex of
/// the surface and equal texture coordinates, cut to be manifold (charts that touch in a point are
/// separated). \throw InputError if there is no triangle; the tree is unchanged then. Cost: O(n log n)
TextureChild add_texture_child(MultiMesh& tree, NodeId parent, TexturedCorners corners,
                               std::span<const Vec2> values);

}  // namespace multimesh::openmesh
