// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/periodic.hpp"

// GCC 12 takes an Eigen vector that OpenMesh's property makes by T() for one that is read uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "multimesh/algorithms/make_mesh.hpp"
#include "multimesh/algorithms/periodic/glue_tile.hpp"
#include "multimesh/algorithms/periodic/vertex_values.hpp"
#include "multimesh/faces.hpp"

namespace multimesh {

namespace {

// A new vertex lies as far from its common place as the ends of its edge from theirs; a merged one keeps
// what the survivor has.
LatticeVector next_offset(const VertexAttribute<LatticeVector>& offsets, Operation operation,
                          const VertexChange& c) {
  return offsets[operation == Operation::split ? c.a : c.vertex];
}

std::size_t count_simplices(const Mesh& mesh, int k) {
  std::size_t n = 0;
  for (Index s = 0; s < mesh.capacity(k); ++s) n += mesh.is_live(k, s);
  return n;
}

}  // namespace

struct PeriodicDomain::Data {
  Data(PreparedTile prepared, GluedTile glued, PeriodicReport found)
      : lattice(std::move(prepared.lattice)),
        diagonal(prepared.diagonal),
        report(std::move(found)),
        input_facets(std::move(prepared.tile.input_facet)),
        tree(make_mesh(glued.root)) {
    std::vector<Index> all(glued.root.size());
    std::iota(all.begin(), all.end(), Index{0});
    lock_copies(glued);
    tile =
        add_child_by_facets(tree, NodeId::root, std::move(glued.tile), std::move(glued.root), all, make_mesh);

    Mesh& mesh = tree.mesh(tile);
    auto& points = add_vertex_values<Point>(mesh, "periodic:point");
    auto& lattice_vectors = add_vertex_values<LatticeVector>(mesh, "periodic:offset");
    input_vertices = std::move(glued.source);
    for (Index v = 0; v < input_vertices.size(); ++v) {
      points[v] = prepared.tile.point[input_vertices[v]];
      lattice_vectors[v] = prepared.tile.offset[input_vertices[v]];
    }
    positions.emplace(tile, points);
    offsets.emplace(tile, lattice_vectors, [this](Operation operation, const VertexChange& c) {
      return next_offset(*offsets, operation, c);
    });
  }

  // Copies that the cut has made of one vertex would come apart if they could move.
  void lock_copies(const GluedTile& glued) {
    std::vector<Index> copies(glued.root_class.size(), 0);
    for (const Index c : glued.root_class) ++copies[c];
    for (Index v = 0; v < glued.root_class.size(); ++v)
      if (copies[glued.root_class[v]] > 1) lock_vertex(tree.mesh(NodeId::root), v);
  }

  void count() {
    const Mesh& root = tree.mesh(NodeId::root);
    for (int k = 0; k <= root.dimension(); ++k) {
      const std::size_t n = count_simplices(root, k);
      report.simplices[static_cast<std::size_t>(k)] = n;
      report.euler += (k % 2 == 0 ? 1 : -1) * static_cast<long>(n);
    }
    DartBuffer copies;
    for (Index v = 0; v < root.capacity(0); ++v) {
      copies.clear();
      tree.to_child(tile, root.dart_of(0, v), 0, copies);
      if (report.with_copies.size() <= copies.size()) report.with_copies.resize(copies.size() + 1);
      ++report.with_copies[copies.size()];
    }
  }

  std::optional<NodeId> add_sides(bool glued) {
    const Mesh& mesh = tree.mesh(tile);
    const int k = mesh.dimension() - 1;
    const auto tagged = [&](Index s) {
      const Dart d = mesh.dart_of(k, s);
      if (!mesh.is_boundary(d, k)) return false;
      return glued != tree.mesh(NodeId::root).is_boundary(tree.to_parent(tile, d), k);
    };
    Index s = 0;
    while (s < mesh.capacity(k) && !(mesh.is_live(k, s) && tagged(s))) ++s;
    if (s == mesh.capacity(k)) return std::nullopt;
    return add_child_from_tags(tree, tile, k, tagged, make_mesh);
  }

  Lattice lattice;
  double diagonal;
  PeriodicReport report;
  std::vector<Index> input_facets, input_vertices;
  MultiMesh tree;
  NodeId tile = NodeId::root;
  std::optional<VertexAttribute<Point>> positions;
  std::optional<VertexAttribute<LatticeVector>> offsets;
};

PeriodicDomain::PeriodicDomain(const PeriodicTile& tile, const PeriodicOptions& options) {
  PeriodicReport report;
  PreparedTile prepared = prepare_tile(tile, options, report);
  GluedTile glued = glue_tile(prepared.tile, report);
  data_ = std::make_unique<Data>(std::move(prepared), std::move(glued), std::move(report));
  data_->count();
  const Eigen::Vector3d normal = mean_normal(*this);
  const Mesh& mesh = data_->tree.mesh(data_->tile);
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    data_->report.inverted_facets += !(signed_measure(*this, f, normal) > 0);
}

PeriodicDomain::~PeriodicDomain() = default;
PeriodicDomain::PeriodicDomain(PeriodicDomain&&) noexcept = default;

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
VertexAttribute<PeriodicDomain::Point>& PeriodicDomain::positions() {
  return *data_->positions;
}
const VertexAttribute<PeriodicDomain::Point>& PeriodicDomain::positions() const {
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
  propagation.add(positions()).add(offsets());
}

PeriodicDomain::Point PeriodicDomain::common_place(Index v) const {
  return positions()[v] - lattice().shift(offsets()[v]);
}

PeriodicDomain::Point PeriodicDomain::place(NodeId n, Dart vertex) const {
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

Outcome PeriodicDomain::move(Propagation& propagation, NodeId n, Dart vertex, const Point& by) {
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
  return data_->add_sides(true);
}

PeriodicTile PeriodicDomain::tile_lists() const {
  const Mesh& mesh = data_->tree.mesh(tile());
  const int d = mesh.dimension();
  PeriodicTile out{{}, {d, 0, {}}};
  std::vector<Index> number(mesh.capacity(0), no_index);
  for (Index v = 0; v < mesh.capacity(0); ++v) {
    if (!mesh.is_live(0, v) || mesh.dart_of(0, v) == no_dart) continue;
    number[v] = static_cast<Index>(out.points.size());
    const Point& p = positions()[v];
    out.points.push_back({p[0], p[1], p[2]});
  }
  out.facets.vertices = static_cast<Index>(out.points.size());
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    std::array<Index, 4> v{};
    oriented_corners(mesh, f, v.data());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i) out.facets.corners.push_back(number[v[i]]);
  }
  return out;
}

}  // namespace multimesh
