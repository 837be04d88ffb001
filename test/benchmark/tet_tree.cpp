// SPDX-License-Identifier: BSD-3-Clause
#include "test/benchmark/tet_tree.hpp"

#include "multimesh/build.hpp"
#include "multimesh/domains/make_mesh.hpp"

namespace multimesh::bench {

namespace {

FacetList kuhn_cube(Index n) {
  FacetList list{3, (n + 1) * (n + 1) * (n + 1), {}};
  list.corners.reserve(std::size_t{24} * n * n * n);
  constexpr Index paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const Index step[3] = {1, n + 1, (n + 1) * (n + 1)};
  for (Index z = 0; z < n; ++z)
    for (Index y = 0; y < n; ++y)
      for (Index x = 0; x < n; ++x)
        for (int p = 0; p < 6; ++p) {
          Index v[4] = {x + step[1] * y + step[2] * z};
          for (int i = 0; i < 3; ++i) v[i + 1] = v[i] + step[paths[p][i]];
          if (p >= 3) std::swap(v[2], v[3]);  // odd paths
          list.corners.insert(list.corners.end(), v, v + 4);
        }
  return list;
}

}  // namespace

TetTree::TetTree(Index n, unsigned children) {
  auto mesh = std::make_unique<tet::TetMesh>(kuhn_cube(n));
  auto& points = mesh->add_vertex_property<Eigen::Vector3d>("points");
  for (Index v = 0; v < mesh->capacity(0); ++v)
    points[v] = Eigen::Vector3d(v % (n + 1), v / (n + 1) % (n + 1), v / (n + 1) / (n + 1)) / n;
  root_ = mesh.get();
  tree_ = std::make_unique<MultiMesh>(std::move(mesh));
  if (children & outer_surface) add_child_from_boundary(*tree_, NodeId::root, make_mesh);

  // Between the cubes of the middle half and the others: the faces of a cube of n/2 cubes.
  const auto in_middle = [&](double x) { return x >= 0.25 && x <= 0.75; };
  const auto inside = [&](Index t) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i) middle += points[root_->corners(t)[i]] / 4;
    return in_middle(middle.x()) && in_middle(middle.y()) && in_middle(middle.z());
  };
  if (children & inner_surface)
    add_child_from_tags(
        *tree_, NodeId::root, 2,
        [&](Index s) {
          const Dart d = root_->dart_of(2, s), beyond = root_->switch_dart(d, 3);
          return beyond != no_dart && inside(root_->tet(d)) != inside(root_->tet(beyond));
        },
        make_mesh);
  // Round it, half way up.
  if (children & inner_curve) {
    const double middle = static_cast<double>(n / 2) / n, low = std::ceil(0.25 * n) / n,
                 high = std::floor(0.75 * n) / n;
    const auto on_rim = [&](Index v) {
      const Eigen::Vector3d& p = points[v];
      const bool on_x = p.x() == low || p.x() == high, on_y = p.y() == low || p.y() == high;
      return p.z() == middle &&
             ((on_x && p.y() >= low && p.y() <= high) || (on_y && p.x() >= low && p.x() <= high));
    };
    add_child_from_tags(
        *tree_, NodeId::root, 1,
        [&](Index s) {
          Index v[4];
          root_->vertices(root_->dart_of(1, s), v);
          return on_rim(v[0]) && on_rim(v[1]) && (points[v[0]] - points[v[1]]).norm() < 1.1 / n;
        },
        make_mesh);
  }
  operations_ = std::make_unique<Propagation>(*tree_);
  positions_ = std::make_unique<VertexAttribute<Eigen::Vector3d>>(NodeId::root, points.values);
  operations_->add(*positions_);
}

}  // namespace multimesh::bench
