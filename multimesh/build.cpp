// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/build.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "multimesh/faces.hpp"

namespace multimesh {

namespace {

/// The dart of a parent facet that begins with the given vertices.
Dart dart_beginning_with(const Mesh& mesh, Index facet, std::span<const Index> vertices) {
  if (vertices.size() == static_cast<std::size_t>(mesh.dimension()) + 1)
    return dart_with(mesh, facet, vertices.data());
  const Dart any = mesh.dart_of(mesh.dimension(), facet);
  std::array<Index, 4> have{};
  for (std::uint8_t p = 0; p < number_of_orders(mesh.dimension()); ++p) {
    const Dart d = mesh.reorder(any, {p});
    mesh.vertices(d, have.data());
    if (std::equal(vertices.begin(), vertices.end(), have.begin())) return d;
  }
  return no_dart;
}

}  // namespace

NodeId add_child_by_facets(MultiMesh& tree, NodeId parent, FacetList child, FacetList over,
                           std::span<const Index> parent_facets, const MeshFactory& make) {
  const Mesh& above = tree.mesh(parent);
  if (over.size() != child.size() || parent_facets.size() != child.size() ||
      over.dimension != child.dimension)
    throw InputError("facet bijection: " + std::to_string(child.size()) + " child facets, but " +
                     std::to_string(over.size()) + " parent simplices and " +
                     std::to_string(parent_facets.size()) + " parent facets");
  std::unique_ptr<Mesh> mesh = make(child);
  std::vector<Anchor> anchors(child.size());
  for (Index f = 0; f < child.size(); ++f) {
    if (!above.is_live(above.dimension(), parent_facets[f]))
      throw InputError("child facet " + std::to_string(f) + ": parent facet " +
                       std::to_string(parent_facets[f]) + " is not alive");
    anchors[f] = {dart_with(*mesh, f, child.facet(f).data()),
                  dart_beginning_with(above, parent_facets[f], over.facet(f))};
    if (anchors[f].parent == no_dart)
      throw InputError("child facet " + std::to_string(f) + ": its vertices are not those of parent facet " +
                       std::to_string(parent_facets[f]));
  }
  child = FacetList();
  over = FacetList();
  return tree.add_child(parent, std::move(mesh), anchors);
}

NodeId add_child_from_tags(MultiMesh& tree, NodeId parent, int k, const std::function<bool(Index)>& tagged,
                           const MeshFactory& make, const CutOptions& options) {
  const Mesh& above = tree.mesh(parent);
  if (k < 0 || k > above.dimension())
    throw InputError("tags on " + std::to_string(k) + "-simplices of a mesh of dimension " +
                     std::to_string(above.dimension()) +
                     ": children have dimension 0 or more, and at most that of their parent");
  FacetList facets{k, above.capacity(0), {}};
  std::vector<Dart> darts;
  for (Index s = 0; s < above.capacity(k); ++s) {
    if (!above.is_live(k, s) || !tagged(s)) continue;
    const Dart d = above.dart_of(k, s);
    if (d == no_dart)
      throw InputError("vertex " + std::to_string(s) + " is tagged, but in no facet: it has no dart");
    std::array<Index, 4> v{};
    above.vertices(d, v.data());
    facets.corners.insert(facets.corners.end(), v.begin(), v.begin() + k + 1);
    darts.push_back(d);
  }
  if (darts.empty())
    throw InputError("no " + std::to_string(k) + "-simplex is tagged: the child would be empty");

  const Cut pieces = cut(facets, options);
  std::unique_ptr<Mesh> mesh = make(pieces.facets);
  std::vector<Anchor> anchors(darts.size());
  for (Index f = 0; f < darts.size(); ++f) {
    std::array<Index, 4> own{};
    std::copy_n(pieces.facets.facet(f).begin(), k + 1, own.begin());
    if (pieces.reversed[f]) std::swap(own[0], own[1]);
    anchors[f] = {dart_with(*mesh, f, own.data()), darts[f]};
  }
  return tree.add_child(parent, std::move(mesh), anchors);
}

NodeId add_child_from_boundary(MultiMesh& tree, NodeId parent, const MeshFactory& make,
                               const CutOptions& options) {
  const Mesh& above = tree.mesh(parent);
  const int k = above.dimension() - 1;
  const auto in_boundary = [&](Index s) {
    const Dart d = above.dart_of(k, s);
    return d != no_dart && above.is_boundary(d, k);
  };
  return add_child_from_tags(tree, parent, k, in_boundary, make, options);
}

}  // namespace multimesh
