// SPDX-License-Identifier: BSD-3-Clause
// A tile as lists, with what it takes to glue it again.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "multimesh/domains/periodic_domain/domain_data.hpp"

namespace multimesh {

namespace {

/// The copies in the tile of the simplices that a mesh of listed simplices is made of, with their tags.
void put_listed(const PeriodicDomain& domain, int k, const std::vector<Index>& number,
                PeriodicTile::Listed& out) {
  const std::optional<NodeId> node = domain.listed(k);
  if (!node) return;
  const MultiMesh& tree = domain.tree();
  const Mesh &mesh = tree.mesh(*node), &tile = tree.mesh(domain.tile());
  DartBuffer copies;
  for (Index s = 0; s < mesh.capacity(k); ++s) {
    if (!mesh.is_live(k, s) || domain.label(k, s).copies.empty()) continue;
    copies.clear();
    tree.to_child(domain.tile(), tree.to_parent(*node, mesh.dart_of(k, s)), k, copies);
    const auto offset = [&](Dart d) { return domain.offsets()[tile.vertex(d)]; };
    LatticeVector least = offset(copies[0]);
    for (const Dart c : copies) least = std::min(least, offset(c));
    for (const auto& [at, tag] : domain.label(k, s).copies) {
      const auto copy = std::ranges::find_if(copies, [&](Dart c) { return offset(c) - least == at; });
      if (copy == copies.end()) continue;
      Index v[4];
      tile.vertices(*copy, v);
      for (int i = 0; i <= k; ++i) out.simplices.corners.push_back(number[v[i]]);
      out.tags.push_back(tag);
    }
  }
}

}  // namespace

PeriodicTile PeriodicDomain::tile_lists() const {
  const Mesh& mesh = data_->tree.mesh(tile());
  const int d = mesh.dimension();
  PeriodicTile out;
  out.facets.dimension = d;
  const std::vector<Index> number = data_->numbers();
  out.points.reserve(number.size());
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    out.points.push_back(positions()[v]);
  }
  out.facets.vertices = static_cast<Index>(out.points.size());
  out.facets.corners.reserve(mesh.capacity(d) * out.facets.corners_per_facet());
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    std::array<Index, 4> v{};
    mesh.vertices(mesh.dart_of(d, f), v.data());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i) out.facets.corners.push_back(number[v[i]]);
    if (!data_->regions.empty()) out.regions.push_back(region(f));
  }
  for (int k = 0; k < d; ++k) {
    auto& listed = out.listed[static_cast<std::size_t>(k)];
    put_listed(*this, k, number, listed);
    listed.simplices.vertices = out.facets.vertices;
  }
  return out;
}

PeriodicSources PeriodicDomain::sources() const {
  const Mesh& mesh = data_->tree.mesh(tile());
  PeriodicSources out;
  const std::vector<Index> number = data_->numbers();
  for (Index v = 0; v < number.size(); ++v)
    if (number[v] != no_index) out.vertices.push_back((*data_->sources)[v]);
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    if (mesh.is_live(mesh.dimension(), f)) out.facets.push_back((*data_->facet_source)[f]);
  return out;
}

PeriodicOptions PeriodicDomain::gluing() const {
  PeriodicOptions options;
  options.interfaces = data_->interfaces;
  options.corner_angle = data_->corner_angle;
  options.feature_angle = data_->feature_angle;
  options.periods.emplace();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    options.axes[i] = lattice().is_periodic(axis);
    const Eigen::Vector3d period = lattice().periods().col(axis);
    (*options.periods)[i] = {period[0], period[1], period[2]};
  }
  for (const PeriodicCopy& c : copies()) options.pairs.push_back({c.slave, c.master});
  return options;
}

std::vector<PeriodicCopy> PeriodicDomain::copies() const {
  const MultiMesh& tree = data_->tree;
  const Mesh &root = tree.mesh(NodeId::root), &mesh = tree.mesh(tile());
  const std::vector<Index> number = data_->numbers();
  std::vector<std::array<Index, 2>> of_root;  // a vertex of the root, and one of the tile that has copies
  std::vector<Index> image(number.size(), no_index), copies(root.capacity(0), 0);
  for (Index v = 0; v < number.size(); ++v)
    if (number[v] != no_index) ++copies[image[v] = root.vertex(tree.to_parent(tile(), mesh.dart_of(0, v)))];
  for (Index v = 0; v < number.size(); ++v)
    if (number[v] != no_index && copies[image[v]] > 1) of_root.push_back({image[v], v});
  std::ranges::sort(of_root);
  std::vector<PeriodicCopy> out;
  for (std::size_t i = 1, first = 0; i < of_root.size(); ++i) {
    if (of_root[i][0] != of_root[first][0]) {
      first = i;
      continue;
    }
    const Index slave = of_root[i][1], master = of_root[first][1];
    out.push_back({number[slave], number[master], offsets()[slave] - offsets()[master]});
  }
  return out;
}

std::vector<PeriodicSide> PeriodicDomain::sides() const {
  const MultiMesh& tree = data_->tree;
  const Mesh& mesh = tree.mesh(tile());
  const int k = mesh.dimension() - 1;
  const std::vector<Index> number = data_->numbers();
  std::map<LatticeVector, PeriodicSide> by_shift;
  DartBuffer copies;
  for (Index s = 0; s < mesh.capacity(k); ++s) {
    if (!mesh.is_live(k, s)) continue;
    const Dart d = mesh.dart_of(k, s);
    if (!mesh.is_boundary(d, k) || !data_->is_glued(d)) continue;
    copies.clear();
    tree.to_child(tile(), tree.to_parent(tile(), d), k, copies);
    if (s != std::min(mesh.simplex(copies[0], k), mesh.simplex(copies[1], k))) continue;  // each pair once
    // Darts with one image: their corners correspond.
    std::array<std::array<Index, 4>, 2> v{};
    mesh.vertices(copies[0], v[0].data());
    mesh.vertices(copies[1], v[1].data());
    LatticeVector shift = offsets()[v[1][0]] - offsets()[v[0][0]];
    if (shift == LatticeVector{}) continue;
    if (shift < LatticeVector{}) shift = LatticeVector{} - shift, std::swap(v[0], v[1]);
    PeriodicSide& side = by_shift[shift];
    for (std::size_t i = 0; i <= static_cast<std::size_t>(k); ++i) {
      side.master.corners.push_back(number[v[0][i]]);
      side.slave.corners.push_back(number[v[1][i]]);
    }
  }
  const auto vertices =
      static_cast<Index>(std::count_if(number.begin(), number.end(), [](Index n) { return n != no_index; }));
  std::vector<PeriodicSide> sides;
  for (auto& [shift, side] : by_shift) {
    side.shift = shift;
    side.master.dimension = side.slave.dimension = k;
    side.master.vertices = side.slave.vertices = vertices;
    sides.push_back(std::move(side));
  }
  return sides;
}

PeriodicOptions options_of_pairs(std::vector<std::array<Index, 2>> pairs,
                                 std::span<const std::array<double, 3>> translations) {
  std::vector<Vec3> vectors;
  double longest = 0;
  for (const auto& t : translations) longest = std::max(longest, vectors.emplace_back(t).norm());
  const std::vector<Vec3> basis = lattice_basis(vectors, 1e-6 * longest);
  if (basis.empty()) throw InputError("the periodic links of the file have no translation");

  std::array<std::size_t, 3> order{0, 1, 2}, best = order;
  double most = -1;
  do {
    double parallel = 0;
    for (std::size_t i = 0; i < basis.size(); ++i) parallel += std::abs(basis[i][order[i]]) / basis[i].norm();
    if (parallel > most) most = parallel, best = order;
  } while (std::next_permutation(order.begin(), order.end()));

  PeriodicOptions options;
  options.axes = {false, false, false};
  options.periods.emplace();
  options.pairs = std::move(pairs);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const std::size_t axis = best[i];
    const double sign = basis[i][axis] < 0 ? -1 : 1;
    options.axes[axis] = true;
    (*options.periods)[axis] = {sign * basis[i][0], sign * basis[i][1], sign * basis[i][2]};
  }
  return options;
}

}  // namespace multimesh
