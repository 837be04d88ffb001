// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/periodic_domain/domain_data.hpp"
#include "multimesh/faces.hpp"

namespace multimesh {

namespace {

/// Faces follow from facets and the boundary; so do edges, because the Euler characteristic of a manifold of
/// odd dimension is half of that of its boundary, a closed surface.
void count_faces(const Mesh& root, PeriodicReport& report) {
  auto& n = report.simplices;
  const int d = root.dimension();
  std::size_t rim = 0;
  std::vector<bool> on_rim(root.capacity(0), false);
  for (Index f = 0; f < root.capacity(d); ++f)
    for (const Permutation face : faces_around(d, d - 1, -1)) {
      const Dart dart = root.reorder(root.dart_of(d, f), face);
      if (!root.is_boundary(dart, d - 1)) continue;
      Index v[4];
      root.vertices(dart, v);
      ++rim;
      for (int i = 0; i < d; ++i) on_rim[v[i]] = true;
    }
  const auto corners = static_cast<std::size_t>(d + 1);
  const std::size_t sides = (corners * root.capacity(d) + rim) / 2;
  n[corners - 2] = sides;
  if (d == 3) {
    const long rim_euler = std::count(on_rim.begin(), on_rim.end(), true) - static_cast<long>(rim) / 2;
    n[1] = static_cast<std::size_t>(static_cast<long>(n[0] + sides - n[3]) - rim_euler / 2);
  }
  for (std::size_t k = 0; k < 4; ++k) report.euler += (k % 2 == 0 ? 1 : -1) * static_cast<long>(n[k]);
}

void count(const GluedTile& glued, PeriodicReport& report) {
  report.simplices[0] = glued.root.vertices;
  report.simplices[static_cast<std::size_t>(glued.root.dimension)] = glued.root.size();
  std::vector<Index> image(glued.source.size(), no_index);
  for (std::size_t c = 0; c < glued.root.corners.size(); ++c)
    image[glued.tile.corners[c]] = glued.root.corners[c];
  std::vector<std::size_t> copies(glued.root.vertices, 0);
  for (const Index v : image)
    if (v != no_index) ++copies[v];
  report.with_copies.assign(std::ranges::max(copies) + 1, 0);
  for (const std::size_t n : copies) ++report.with_copies[n];
}

}  // namespace

PeriodicDomain::PeriodicDomain(const PeriodicTile& tile, const PeriodicOptions& options) {
  PeriodicReport report;
  PreparedTile prepared = prepare_tile(tile, options, report);
  GluedTile glued = glue_tile(prepared.tile, report);
  count(glued, report);
  data_ = std::make_unique<Data>(std::move(prepared), std::move(glued), std::move(report), tile);
  count_faces(data_->tree.mesh(NodeId::root), data_->report);
  data_->add_listed(tile, options);
  const Vec3 normal = mean_normal(*this);
  const Mesh& mesh = data_->tree.mesh(data_->tile);
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    data_->report.inverted_facets += orientation(*this, f, normal) <= 0;
}

PeriodicDomain::~PeriodicDomain() = default;
PeriodicDomain::PeriodicDomain(PeriodicDomain&&) noexcept = default;
PeriodicDomain& PeriodicDomain::operator=(PeriodicDomain&&) noexcept = default;

MultiMesh& PeriodicDomain::tree() {
  return data_->tree;
}
const MultiMesh& PeriodicDomain::tree() const {
  return data_->tree;
}
NodeId PeriodicDomain::tile() const {
  return data_->tile;
}
const PeriodicReport& PeriodicDomain::report() const {
  return data_->report;
}
const Lattice& PeriodicDomain::lattice() const {
  return data_->lattice;
}
double PeriodicDomain::diagonal() const {
  return data_->diagonal;
}
VertexAttribute<Vec3>& PeriodicDomain::positions() {
  return *data_->positions;
}
const VertexAttribute<Vec3>& PeriodicDomain::positions() const {
  return *data_->positions;
}
VertexAttribute<LatticeVector>& PeriodicDomain::offsets() {
  return *data_->offsets;
}
const VertexAttribute<LatticeVector>& PeriodicDomain::offsets() const {
  return *data_->offsets;
}
const std::vector<Index>& PeriodicDomain::input_facets() const {
  return data_->input_facets;
}
const std::vector<Index>& PeriodicDomain::input_vertices() const {
  return data_->input_vertices;
}

void PeriodicDomain::attach(Propagation& propagation) {
  propagation.add(positions()).add(offsets()).add(sources_of_vertices());
}
Attribute& PeriodicDomain::sources_of_vertices() {
  return *data_->sources;
}

Vec3 PeriodicDomain::common_place(Index v) const {
  return positions()[v] - lattice().shift(offsets()[v]);
}

Vec3 PeriodicDomain::place(NodeId n, Dart vertex) const {
  const MultiMesh& tree = data_->tree;
  if (n == NodeId::root) {
    DartBuffer copies;
    tree.to_child(tile(), vertex, 0, copies);
    vertex = copies.front();
  } else {
    vertex = tree.to_ancestor(n, vertex, tile());
  }
  return positions()[tree.mesh(tile()).vertex(vertex)];
}

double PeriodicDomain::mismatch() const {
  const MultiMesh& tree = data_->tree;
  const Mesh& mesh = tree.mesh(tile());
  std::vector<Index> first(tree.mesh(NodeId::root).capacity(0), no_index);
  double largest = 0;
  for (Index v = 0; v < mesh.capacity(0); ++v) {
    if (!mesh.is_live(0, v) || mesh.dart_of(0, v) == no_dart) continue;
    Index& one = first[tree.mesh(NodeId::root).vertex(tree.to_parent(tile(), mesh.dart_of(0, v)))];
    if (one == no_index) one = v;
    largest = std::max(largest, (common_place(v) - common_place(one)).norm());
  }
  return largest / diagonal();
}

Outcome PeriodicDomain::move(Propagation& propagation, NodeId n, Dart vertex, const Vec3& by) {
  MultiMesh& tree = data_->tree;
  tree.require_dart(n, vertex);
  const Mesh& root = tree.mesh(NodeId::root);
  if (root.is_locked(root.vertex(tree.to_root(n, vertex)))) return {{Check::locked, NodeId::root, {}}};
  return propagation.relocate(n, vertex, [&](const Event& e) {
    for (const Copy& c : e.copies.of(tile())) {
      const Index v = tree.mesh(tile()).vertex(c.dart);
      positions().set(v, positions()[v] + by);
    }
  });
}

std::optional<NodeId> PeriodicDomain::add_surface() {
  return data_->add_sides(false);
}
std::optional<NodeId> PeriodicDomain::add_cuts() {
  if (!data_->cuts) data_->cuts = data_->add_sides(true);
  return data_->cuts;
}

std::optional<NodeId> PeriodicDomain::add_walls() {
  if (!data_->walls) data_->walls = data_->add_faces(tile(), [&](Dart d) { return data_->is_wall(d); });
  return data_->walls;
}

std::optional<NodeId> PeriodicDomain::listed(int k) const {
  return data_->listed[static_cast<std::size_t>(k)].node;
}
const PeriodicLabel& PeriodicDomain::label(int k, Index facet) const {
  return data_->labels[(*data_->listed[static_cast<std::size_t>(k)].label)[facet]];
}

PeriodicTile::Region PeriodicDomain::region(Index tile_facet) const {
  return data_->region(tile_facet);
}

}  // namespace multimesh
