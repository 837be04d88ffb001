// SPDX-License-Identifier: BSD-3-Clause
#include "test/benchmark/surface_tree.hpp"

#include <numeric>

#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"

namespace multimesh::bench {

SurfaceMesh surface_mesh(const test::Shape& shape) {
  SurfaceMesh mesh;
  const std::size_t v = shape.points.size(), f = shape.facets.size();
  mesh.reserve(v, v + f, f);
  for (const auto& p : shape.points) mesh.add_vertex(OpenMesh::Vec3d(p[0], p[1], p[2]));
  for (std::size_t i = 0; i < f; ++i) {
    const auto corner = [&](std::size_t k) {
      return OpenMesh::VertexHandle(static_cast<int>(shape.facets.facet(i)[k]));
    };
    mesh.add_face(corner(0), corner(1), corner(2));
  }
  return mesh;
}

SurfaceTree::SurfaceTree(const ChartedShape& charted, unsigned children)
    : mesh_(surface_mesh(charted.shape)) {
  tree_.emplace(std::make_unique<openmesh::TriangleMesh>(mesh_));
  positions_.emplace(NodeId::root, mesh_.property(mesh_.points_pph()).data_vector());
  operations_.emplace(*tree_);
  operations_->add(*positions_);
  if (children & texture) add_texture(charted);
  if (children & seams) add_seams(charted);
  if (children & boundary) add_child_from_boundary(*tree_, NodeId::root, openmesh::make_mesh);
}

void SurfaceTree::add_texture(const ChartedShape& charted) {
  const Texture charts = texture_of(charted);
  std::vector<Index> facets(charts.facets.size());
  std::iota(facets.begin(), facets.end(), Index{0});
  const NodeId id =
      add_child_by_facets(*tree_, NodeId::root, charts.facets, charts.over, facets, openmesh::make_mesh);

  auto& connectivity = dynamic_cast<openmesh::Connectivity&>(tree_->mesh(id)).openmesh();
  OpenMesh::VPropHandleT<OpenMesh::Vec2d> property;
  connectivity.add_property(property, "texcoords");
  auto& values = connectivity.property(property).data_vector();
  for (std::size_t i = 0; i < charts.facets.corners.size(); ++i) {
    const OpenMesh::Vec3d& p = positions()[charts.over.corners[i]];
    values[charts.facets.corners[i]] = OpenMesh::Vec2d(p[0], p[1]);
  }
  texcoords_.emplace(id, values);
  operations_->add(*texcoords_);
}

void SurfaceTree::add_seams(const ChartedShape& charted) {
  const auto is_seam = [&](Index e) {
    const Dart d = root().dart_of(1, e), across = root().switch_dart(d, 2);
    return across != no_dart && charted.chart[root().facet(d)] != charted.chart[root().facet(across)];
  };
  add_child_from_tags(*tree_, NodeId::root, 1, is_seam, openmesh::make_mesh);
}

std::size_t SurfaceTree::map_bytes() const {
  std::size_t bytes = 0;
  for (const NodeId n : tree_->nodes()) {
    if (n == NodeId::root) continue;
    const Mesh& child = tree_->mesh(n);
    const Mesh& parent = tree_->mesh(tree_->parent(n));
    bytes += child.capacity(child.dimension()) * sizeof(Anchor);
    bytes += parent.capacity(child.dimension()) * sizeof(Index);
  }
  return bytes;
}

}  // namespace multimesh::bench
