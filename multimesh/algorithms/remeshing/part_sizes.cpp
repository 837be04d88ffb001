// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/part_sizes.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>

#include "multimesh/geometry/tet_shape.hpp"

namespace multimesh::remeshing {

namespace {

/// Of the bounding-box diagonal: vertices of a plane surface are no farther from it.
constexpr double flatness = 1e-9;

using Corners = std::array<Vec3, 4>;

/// In the order of its orientation; of a triangle three.
Corners corners(const Mesh& mesh, const Coordinates& at, Index facet) {
  std::array<Index, 4> v{};
  mesh.facet_vertices(facet, v.data());
  Corners p{};
  for (std::size_t i = 0; i <= static_cast<std::size_t>(mesh.dimension()); ++i) p[i] = at.at(v[i]);
  return p;
}

Vec3 doubled_area(const Corners& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

template <class Visit>
void for_facets(const Mesh& mesh, const Coordinates& at, const Visit& visit) {
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    if (mesh.is_live(mesh.dimension(), f)) visit(f, corners(mesh, at, f));
}

/// The unit normal of the plane in which all vertices lie; 0 if there is none.
Vec3 plane_normal(const Mesh& mesh, const Coordinates& at) {
  Vec3 sum(0, 0, 0), low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -low;
  for_facets(mesh, at, [&](Index, const Corners& p) {
    sum += doubled_area(p);
    for (std::size_t i = 0; i < 3; ++i) low = min(low, p[i]), high = max(high, p[i]);
  });
  const Vec3 n = sum.unit_or_zero();
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for_facets(mesh, at, [&](Index, const Corners& p) {
    for (std::size_t i = 0; i < 3; ++i)
      least = std::min(least, dot(n, p[i] - low)), greatest = std::max(greatest, dot(n, p[i] - low));
  });
  return greatest - least <= flatness * (high - low).norm() ? n : Vec3(0, 0, 0);
}

}  // namespace

PartSizes::PartSizes(const EmbeddedMesh& surface)
    : tree_(surface.tree()), surface_(surface.node()), node_(surface.node()) {
  if (!surface.charts().empty()) return;
  for (const auto& [node, parts] : surface.embedding().kept().parts) {
    const Mesh& mesh = tree_.mesh(node);
    const bool is_above = mesh.dimension() == 3 && tree_.lowest_common_ancestor(node, node_) == node;
    if (node != surface_ && !is_above) continue;
    positions_ = surface.embedding().positions(node);
    if (positions_ == nullptr) continue;
    if (!is_above) normal_ = plane_normal(mesh, *positions_);
    if (!is_above && normal_.squared_norm() == 0) continue;
    mesh_ = &mesh;
    parts_ = parts;
    node_ = node;
    before_ = sizes();
    return;
  }
}

std::map<PartSizes::Part, double> PartSizes::sizes() const {
  std::map<Part, double> sums;
  for_facets(*mesh_, *positions_, [&](Index f, const Corners& p) {
    sums[(*parts_)[f]] +=
        are_areas() ? dot(normal_, doubled_area(p)) / 2 : six_volume(p[0], p[1], p[2], p[3]) / 6;
  });
  return sums;
}

double PartSizes::largest_change() const {
  double largest = 0;
  const auto now = sizes();
  for (const auto& [part, size] : before_)
    if (const auto found = now.find(part); found != now.end())
      largest = std::max(largest, std::abs(found->second / size - 1));
  return largest;
}

std::map<PartSizes::Part, Vec3> PartSizes::gradients(Dart vertex) const {
  std::map<Part, Vec3> sums;
  const Dart here = are_areas() ? vertex : tree_.to_ancestor(surface_, vertex, node_);
  const Index v = mesh_->vertex(here);
  mesh_->star(here, 0, star_);
  for (const Dart d : star_) {
    const Index f = mesh_->facet(d);
    std::array<Index, 4> at{};
    mesh_->facet_vertices(f, at.data());
    const Corners p = corners(*mesh_, *positions_, f);
    const auto i = static_cast<std::size_t>(std::ranges::find(at, v) - at.begin());
    const auto other = [&](std::size_t k) { return are_areas() ? p[(i + k) % 3] : p[i ^ k]; };
    sums.try_emplace((*parts_)[f], 0, 0, 0).first->second +=
        are_areas() ? cross(normal_, other(2) - other(1)) / 2
                    : cross(other(3) - other(1), other(2) - other(1)) / 6;
  }
  return sums;
}

// Of all solutions, the solver finds the one with the least sum of squares if it starts from 0.
void PartSizes::scale(std::vector<Step>& steps) const {
  using Matrix = Eigen::SparseMatrix<double>;
  std::map<Part, int> row;
  for (const auto& [part, size] : before_) row.emplace(part, static_cast<int>(row.size()));
  std::vector<Eigen::Triplet<double>> rates;
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const auto& [part, gradient] : gradients(steps[i].vertex))
      rates.emplace_back(row.at(part), static_cast<int>(i), dot(gradient, steps[i].by));
  Matrix growth(static_cast<Eigen::Index>(row.size()), static_cast<Eigen::Index>(steps.size()));
  growth.setFromTriplets(rates.begin(), rates.end());
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(growth.rows());
  for (const auto& [part, size] : sizes()) wanted[row.at(part)] = before_.at(part) - size;
  const Eigen::LeastSquaresConjugateGradient<Matrix> solver(growth);
  const Eigen::VectorXd factors = solver.solve(wanted);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].by *= factors[static_cast<Eigen::Index>(i)];
}

}  // namespace multimesh::remeshing
