// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/periodic_domain/glue_tile.hpp"
#include "multimesh/faces.hpp"

namespace multimesh {

/// The contents of a PeriodicDomain.
struct PeriodicDomain::Data {
  Data(PreparedTile prepared, GluedTile glued, PeriodicReport found, const PeriodicTile& input)
      : lattice(std::move(prepared.lattice)),
        diagonal(prepared.diagonal),
        report(std::move(found)),
        input_points(input.points.size()),
        regions(input.regions),
        input_facets(std::move(prepared.tile.input_facet)),
        tree(make_mesh(glued.root)) {
    std::vector<Index> all(glued.root.size());
    std::iota(all.begin(), all.end(), Index{0});
    lock_copies(glued);
    tile =
        add_child_by_facets(tree, NodeId::root, std::move(glued.tile), std::move(glued.root), all, make_mesh);

    Mesh& mesh = tree.mesh(tile);
    auto& points = mesh.add_values<Vec3>(0, "periodic:point");
    auto& lattice_vectors = mesh.add_values<LatticeVector>(0, "periodic:offset");
    auto& vertex_source = mesh.add_values<Index>(0, "periodic:source");
    facet_source = &mesh.add_values<Index>(mesh.dimension(), "periodic:source");
    *facet_source = input_facets;
    part = &mesh.add_values<PeriodicTile::Region>(mesh.dimension(), "periodic:part");
    for (Index f = 0; f < input_facets.size(); ++f) (*part)[f] = region(f);
    input_vertices = std::move(glued.source);
    for (Index v = 0; v < input_vertices.size(); ++v) {
      points[v] = prepared.tile.point[input_vertices[v]];
      lattice_vectors[v] = prepared.tile.offset[input_vertices[v]];
      vertex_source[v] = input_vertices[v] < input_points ? input_vertices[v] : no_index;
    }
    positions.emplace(tile, points);
    offsets.emplace(tile, lattice_vectors,
                    [this](Operation operation, const VertexChange& c) { return next_offset(operation, c); });
    sources.emplace(tile, vertex_source, [this](Operation operation, const VertexChange& c) {
      return operation == Operation::split ? no_index : (*sources)[c.vertex];
    });
  }

  // A new vertex lies as far from its common place as the ends of its edge from theirs; a merged one keeps
  // the survivor's offset.
  LatticeVector next_offset(Operation operation, const VertexChange& c) const {
    return (*offsets)[operation == Operation::split ? c.a : c.vertex];
  }

  // Copies that the cut has made of one vertex would separate if they could move.
  void lock_copies(const GluedTile& glued) {
    std::vector<Index> copies(glued.root_class.size(), 0);
    for (const Index c : glued.root_class) ++copies[c];
    for (Index v = 0; v < glued.root_class.size(); ++v)
      if (copies[glued.root_class[v]] > 1) tree.mesh(NodeId::root).set_locked(v, true);
  }

  /// Locks a vertex with many copies, unless one is locked: nothing else would hold a torus of tetrahedra in
  /// its place.
  void anchor();

  /// Whether a face of the boundary of the tile is glued.
  bool is_glued(Dart face) const {
    const int k = tree.mesh(tile).dimension() - 1;
    return !tree.mesh(NodeId::root).is_boundary(tree.to_parent(tile, face), k);
  }

  /// Whether a face of the tile is in add_walls().
  bool is_wall(Dart face) const {
    if (tree.mesh(tile).is_boundary(face, 2) && !is_glued(face)) return true;
    if (!listed[2].node) return false;
    DartBuffer there;
    tree.to_child(*listed[2].node, tree.to_parent(tile, face), 2, there);
    if (there.empty()) return false;
    DartBuffer copies;
    tree.to_child(tile, tree.to_parent(tile, face), 2, copies);
    return std::ranges::all_of(
        copies, [&](Dart c) { return tree.mesh(tile).simplex(c, 2) >= tree.mesh(tile).simplex(face, 2); });
  }

  /// Makes the meshes of what the tile lists, and of the interfaces if requested.
  void add_listed(const PeriodicTile& input, const PeriodicOptions& options);

  /// Adds the tagged faces of a mesh as its child; nothing if there are none.
  std::optional<NodeId> add_faces(NodeId n, const std::function<bool(Dart face)>& is_tagged) {
    const Mesh& mesh = tree.mesh(n);
    const int k = mesh.dimension() - 1;
    const auto tagged = [&](Index s) { return is_tagged(mesh.dart_of(k, s)); };
    Index s = 0;
    while (s < mesh.capacity(k) && !(mesh.is_live(k, s) && tagged(s))) ++s;
    if (s == mesh.capacity(k)) return std::nullopt;
    return add_child_from_tags(tree, n, k, tagged, make_mesh);
  }
  std::optional<NodeId> add_sides(bool glued) {
    return add_faces(tile, [&](Dart d) {
      const Mesh& mesh = tree.mesh(tile);
      return mesh.is_boundary(d, mesh.dimension() - 1) && glued == is_glued(d);
    });
  }

  PeriodicTile::Region region(Index facet) const {
    return regions.empty() ? 0 : regions[(*facet_source)[facet]];
  }

  /// Per vertex of the tile its number in tile_lists(); no_index for those that are not in the lists.
  std::vector<Index> numbers() const {
    const Mesh& mesh = tree.mesh(tile);
    std::vector<Index> number(mesh.capacity(0), no_index);
    Index next = 0;
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart) number[v] = next++;
    return number;
  }

  /// A mesh of listed simplices.
  struct ListedMesh {
    std::optional<NodeId> node;
    std::vector<Index>* label = nullptr;  // a property of it: into labels
  };

  Lattice lattice;
  double diagonal;
  PeriodicReport report;
  std::size_t input_points;
  std::vector<PeriodicTile::Region> regions;  // by the input's facets
  std::vector<Index> input_facets, input_vertices;
  std::vector<Index>* facet_source = nullptr;  // properties of the tile
  std::vector<PeriodicTile::Region>* part = nullptr;
  MultiMesh tree;
  NodeId tile = NodeId::root;
  std::optional<NodeId> cuts, walls;
  std::array<ListedMesh, 3> listed;  // by dimension
  bool interfaces = false;           // are kept
  double corner_angle = 0, feature_angle = 0;
  std::vector<PeriodicLabel> labels;  // the first one is that of simplices that are not listed
  std::optional<VertexAttribute<Vec3>> positions;
  std::optional<VertexAttribute<LatticeVector>> offsets;
  std::optional<VertexAttribute<Index>> sources;
};

}  // namespace multimesh
