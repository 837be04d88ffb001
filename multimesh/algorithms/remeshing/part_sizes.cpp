// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/part_sizes.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>

namespace multimesh::remeshing {

namespace {

/// Of the bounding-box diagonal: vertices of a plane surface are no farther from it.
constexpr double flatness = 1e-9;
/// Curves that bend by less (the sine of the angle) are straight.
constexpr double straight = 1e-6;

const std::vector<std::int32_t>* told_parts(const EmbeddedMesh& surface) {
  for (const auto& [node, parts] : surface.embedding().kept().parts)
    if (node == surface.node()) return parts;
  return nullptr;
}

std::array<Vec3, 3> corners(const Mesh& mesh, const Coordinates& at, Dart triangle) {
  std::array<Index, 4> v{};
  mesh.vertices(triangle, v.data());
  return {at.at(v[0]), at.at(v[1]), at.at(v[2])};
}

/// The unit normal of the plane in which all vertices lie; 0 if there is none.
Vec3 plane_normal(const Mesh& mesh, const Coordinates& at) {
  Vec3 sum(0, 0, 0), low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = low * -1.0;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    const auto p = corners(mesh, at, mesh.dart_of(2, f));
    sum += cross(p[1] - p[0], p[2] - p[0]);
    for (const Vec3& x : p) low = min(low, x), high = max(high, x);
  }
  if (!(sum.norm() > 0)) return {0, 0, 0};
  const Vec3 n = sum / sum.norm();
  const double most = flatness * (high - low).norm();
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    for (const Vec3& x : corners(mesh, at, mesh.dart_of(2, f)))
      least = std::min(least, dot(n, x - low)), greatest = std::max(greatest, dot(n, x - low));
  }
  return greatest - least <= most ? n : Vec3(0, 0, 0);
}

/// The sine of the angle by which the curve turns; 0 if it is straight.
double bend(const PartSizes::CurveVertex& c, const Coordinates& at, Index v) {
  const Vec3& here = at.at(v);
  const double sine = cross((here - c.before).unit_or_zero(), (c.after - here).unit_or_zero()).norm();
  return sine > straight ? sine : 0;
}

}  // namespace

PartSizes::PartSizes(const EmbeddedMesh& surface)
    : mesh_(surface.mesh()), positions_(surface.positions()), parts_(told_parts(surface)) {
  if (parts_ == nullptr || !surface.charts().empty()) return;
  normal_ = plane_normal(mesh_, positions_);
  if (normal_.squared_norm() > 0) before_ = areas();
}

std::map<PartSizes::Part, double> PartSizes::areas() const {
  std::map<Part, double> sums;
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    const auto p = corners(mesh_, positions_, mesh_.dart_of(2, f));
    sums[(*parts_)[f]] += dot(normal_, cross(p[1] - p[0], p[2] - p[0])) / 2;
  }
  return sums;
}

double PartSizes::largest_change() const {
  double largest = 0;
  const auto now = areas();
  for (const auto& [part, size] : before_)
    if (const auto found = now.find(part); found != now.end())
      largest = std::max(largest, std::abs(found->second / size - 1));
  return largest;
}

std::map<PartSizes::Part, Vec3> PartSizes::gradients(Dart vertex) const {
  std::map<Part, Vec3> sums;
  mesh_.star(vertex, 0, star_);
  for (const Dart t : star_) {
    const auto p = corners(mesh_, positions_, t);
    sums.try_emplace(part(t), 0, 0, 0).first->second += cross(normal_, p[2] - p[1]) / 2;
  }
  return sums;
}

// Of all solutions, the solver finds the one with the least sum of squares if it starts from 0.
std::vector<PartSizes::Step> PartSizes::steps(const std::vector<CurveVertex>& vertices) const {
  using Matrix = Eigen::SparseMatrix<double>;
  std::map<Part, int> row;
  for (const auto& [part, size] : before_) row.emplace(part, static_cast<int>(row.size()));
  std::vector<Eigen::Triplet<double>> rates;
  std::vector<Step> steps;
  for (const CurveVertex& c : vertices) {
    const Vec3 across =
        cross(normal_, c.after - c.before).unit_or_zero() * bend(c, positions_, mesh_.vertex(c.vertex));
    const int column = static_cast<int>(steps.size());
    for (const auto& [part, gradient] : gradients(c.vertex))
      rates.emplace_back(row.at(part), column, dot(gradient, across));
    steps.push_back({c.vertex, across});
  }
  Matrix growth(static_cast<Eigen::Index>(row.size()), static_cast<Eigen::Index>(steps.size()));
  growth.setFromTriplets(rates.begin(), rates.end());
  const auto now = areas();
  Eigen::VectorXd wanted(growth.rows());
  for (const auto& [part, i] : row)
    if (const auto found = now.find(part); found != now.end())
      wanted[i] = before_.at(part) - found->second;
    else
      wanted[i] = 0;
  const Eigen::LeastSquaresConjugateGradient<Matrix> solver(growth);
  const Eigen::VectorXd factors = solver.solve(wanted);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].by *= factors[static_cast<Eigen::Index>(i)];
  return steps;
}

}  // namespace multimesh::remeshing
