// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/predicates/orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace multimesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point3(const double* p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

int orient3d(const double* a, const double* b, const double* c, const double* d) {
  return static_cast<int>(CGAL::orientation(point3(a), point3(b), point3(c), point3(d)));
}

bool collinear(const double* a, const double* b, const double* c) {
  return CGAL::collinear(point3(a), point3(b), point3(c));
}

}  // namespace multimesh
