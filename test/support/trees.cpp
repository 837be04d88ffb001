// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/trees.hpp"

#include <map>
#include <utility>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::test {

namespace {

constexpr const char* point_name = "test:point";

/// A property of the mesh that holds positions.
std::vector<Point3>& add_points(Mesh& mesh) {
  if (auto* tets = dynamic_cast<tet::TetMesh*>(&mesh))
    return tets->add_vertex_property<Point3>(point_name).values;
  auto& om = dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
  OpenMesh::VPropHandleT<Point3> property;
  om.add_property(property, point_name);
  return om.property(property).data_vector();
}

}  // namespace

Tree::Tree(const Shape& root) {
  tree = std::make_unique<MultiMesh>(make_mesh(root.facets));
  operations = std::make_unique<Propagation>(*tree);
  add(NodeId::root);
  for (Index v = 0; v < root.points.size(); ++v)
    (*points_[0])[v] = Point3(root.points[v][0], root.points[v][1], root.points[v][2]);
}

NodeId Tree::add(NodeId id) {
  auto& values = add_points(tree->mesh(id));
  points_.push_back(&values);
  attributes_.push_back(std::make_unique<VertexAttribute<Point3>>(id, values));
  operations->add(*attributes_.back());
  if (id == NodeId::root) return id;
  const Mesh& mesh = tree->mesh(id);
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.dart_of(0, v) != no_dart)
      values[v] =
          points(NodeId::root)[tree->mesh(NodeId::root).vertex(tree->to_root(id, mesh.dart_of(0, v)))];
  return id;
}

NodeId Tree::add_cut(NodeId parent, const std::function<bool(Index)>& seam) {
  // Corners are joined across all interior sides that are no seam.
  const Mesh& mesh = tree->mesh(parent);
  const int d = mesh.dimension();
  const auto corners = static_cast<Index>(d) + 1;
  FacetList over{d, mesh.capacity(0), {}};
  std::vector<Index> parent_facets;
  std::map<std::pair<Index, Index>, Index> corner_at;  // by facet and vertex
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    Index v[4];
    mesh.vertices(mesh.dart_of(d, f), v);
    for (Index i = 0; i < corners; ++i) {
      corner_at[{f, v[i]}] = static_cast<Index>(over.corners.size());
      over.corners.push_back(v[i]);
    }
    parent_facets.push_back(f);
  }
  std::vector<Index> cls(over.corners.size());
  for (Index c = 0; c < cls.size(); ++c) cls[c] = c;
  const std::function<Index(Index)> find = [&](Index c) { return cls[c] == c ? c : cls[c] = find(cls[c]); };
  for (Index s = 0; s < mesh.capacity(d - 1); ++s) {
    if (!mesh.is_live(d - 1, s)) continue;
    const Dart here = mesh.dart_of(d - 1, s), there = mesh.switch_dart(here, d);
    if (there == no_dart || seam(s)) continue;
    Index v[4];
    mesh.vertices(here, v);
    for (int i = 0; i < d; ++i)
      cls[find(corner_at.at({mesh.facet(here), v[i]}))] = find(corner_at.at({mesh.facet(there), v[i]}));
  }
  FacetList child{d, 0, {}};
  std::vector<Index> number(cls.size(), no_index);
  for (Index c = 0; c < cls.size(); ++c) {
    Index& id = number[find(c)];
    if (id == no_index) id = child.vertices++;
    child.corners.push_back(id);
  }
  Cut pieces = cut(child);  // seams may end where a tetrahedral mesh has to be cut further
  for (std::size_t f = 0; f < over.size(); ++f)
    if (pieces.reversed[f]) std::swap(over.corners[f * corners], over.corners[f * corners + 1]);
  return add(add_child_by_facets(*tree, parent, std::move(pieces.facets), std::move(over), parent_facets,
                                 make_mesh));
}

NodeId Tree::add_tagged(NodeId parent, int k, const std::function<bool(Index)>& tagged,
                        const CutOptions& options) {
  return add(add_child_from_tags(*tree, parent, k, tagged, make_mesh, options));
}

NodeId Tree::add_boundary(NodeId parent) {
  return add(add_child_from_boundary(*tree, parent, make_mesh));
}

Outcome Tree::move(NodeId n, Dart v, const Point3& by) {
  return operations->relocate(n, v, [&](const Event& e) {
    for (const Copy& c : e.copies.all()) {
      const Index copy = e.tree.mesh(c.node).vertex(c.dart);
      attribute(c.node).set(copy, points(c.node)[copy] + by);
    }
  });
}

const std::vector<TreeKind>& tree_kinds() {
  static const std::vector<TreeKind> all = [] {
    std::vector<TreeKind> kinds = surface_tree_kinds();
    for (const auto& more : {curve_tree_kinds(), solid_tree_kinds()})
      kinds.insert(kinds.end(), more.begin(), more.end());
    return kinds;
  }();
  return all;
}

}  // namespace multimesh::test
