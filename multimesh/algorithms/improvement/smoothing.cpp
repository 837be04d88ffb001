// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/smoothing.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "multimesh/algorithms/improvement/workspace.hpp"

namespace multimesh::improvement {

namespace {

constexpr int most_steps = 10, most_halvings = 12;
constexpr double least_gain = 1e-3;  // per step, relative to the energy

using Vector = Eigen::Vector3d;

struct Derivatives {
  Vector gradient = Vector::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// The sum over the tetrahedra of (E/s)^p, E their cubed energy.
struct Objective {
  const std::vector<Opposite>& around;
  int power = 1;
  double scale = 1;  ///< keeps powers within the range of doubles

  double value(const Vec3& v) const {
    double sum = 0;
    for (const Opposite& o : around) sum += raised(cubed_amips(v, o[0], o[1], o[2]), power);
    return sum;
  }

  Derivatives derivatives(const Vec3& v) const {
    Derivatives sum;
    for (const Opposite& o : around) {
      const AmipsDerivatives f = cubed_amips_derivatives(v, o[0], o[1], o[2]);
      const double once = power == 1 ? 1 : power * raised(f.value, power - 1) / scale;
      sum.gradient += once * f.gradient;
      sum.hessian += once * f.hessian;
      if (power > 1) sum.hessian += once * (power - 1) / f.value * (f.gradient * f.gradient.transpose());
    }
    return sum;
  }

 private:
  double raised(double e, int n) const {
    if (power == 1) return e;
    double product = 1;
    for (int i = 0; i < n; ++i) product *= e / scale;
    return product;
  }
};

void restrict_to(Axes axes, Derivatives& d) {
  const double scale = d.hessian.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    if (axes[static_cast<std::size_t>(i)]) continue;
    d.gradient[i] = 0;
    d.hessian.row(i).setZero();
    d.hessian.col(i).setZero();
    d.hessian(i, i) = scale;
  }
}

void restrict_to_plane(const Vec3& across, Derivatives& d) {
  const Vector n(across[0], across[1], across[2]);
  const double scale = d.hessian.cwiseAbs().maxCoeff();
  const Eigen::Matrix3d in_plane = Eigen::Matrix3d::Identity() - n * n.transpose();
  d.gradient = in_plane * d.gradient;
  d.hessian = in_plane * d.hessian * in_plane + scale * (n * n.transpose());
}

// Where the Hessian is not positive definite, its eigenvalues are made positive.
Vector descent(const Derivatives& d) {
  const Eigen::LLT<Eigen::Matrix3d> factors(d.hessian);
  if (factors.info() == Eigen::Success) return -factors.solve(d.gradient);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(d.hessian);
  const Vector size = eigen.eigenvalues().cwiseAbs();
  const Vector inverse = size.cwiseMax(1e-6 * size.maxCoeff()).cwiseInverse();
  return -(eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose() * d.gradient);
}

/// A place with finite energy to start from; false if none was found.
bool find_start(Vec3& v, double& value, const Objective& objective, Axes axes) {
  const std::vector<Opposite>& around = objective.around;
  value = objective.value(v);
  if (std::isfinite(value)) return true;
  Vec3 mean{};
  for (const Opposite& o : around) mean += o[0] + o[1] + o[2];
  mean /= 3 * static_cast<double>(around.size());
  for (int i = 0; i < 3; ++i)
    if (!axes[static_cast<std::size_t>(i)]) mean[i] = v[i];
  for (double t : {0.01, 0.1, 0.5, 1.0}) {
    const Vec3 p = (1 - t) * v + t * mean;
    value = objective.value(p);
    if (!std::isfinite(value)) continue;
    v = p;
    return true;
  }
  return false;
}

}  // namespace

Vec3 best_place(const Vec3& start, const std::vector<Opposite>& around, Axes axes, int sharpness,
                const std::optional<Vec3>& across) {
  Vec3 v = start;
  double value;
  Objective objective{around};
  if (sharpness > 1) {
    objective.scale = worst_quality(start, around, certainly_positive);
    if (!(objective.scale < certainly_positive)) return start;
    objective.power = sharpness;
  }
  if (!find_start(v, value, objective, axes)) return start;
  for (int step = 0; step < most_steps; ++step) {
    Derivatives d = objective.derivatives(v);
    restrict_to(axes, d);
    if (across) restrict_to_plane(*across, d);
    if (!d.gradient.allFinite() || !d.hessian.allFinite()) break;
    const Vector downhill = descent(d);
    const double slope = downhill.dot(d.gradient);
    if (!(slope < 0)) break;
    const Vec3 direction(downhill[0], downhill[1], downhill[2]);
    double t = 1, next = value;
    Vec3 p = v;
    for (int i = 0; i < most_halvings; ++i, t /= 2) {
      p = v + t * direction;
      next = objective.value(p);
      if (next <= value + 1e-4 * t * slope) break;
    }
    if (!(next < value)) break;
    const double gain = (value - next) / value;
    v = p;
    value = next;
    if (gain < least_gain) break;
  }
  return v;
}

double worst_quality(const Vec3& v, const std::vector<Opposite>& around, double limit) {
  double worst = 0;
  for (const Opposite& o : around) {
    worst = std::max(worst, quality(v, o[0], o[1], o[2], limit));
    if (worst >= limit) break;
  }
  return worst;
}

}  // namespace multimesh::improvement
