// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  using namespace multimesh;
  const exact::Point third =
      exact::crossing(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1));
  return !third.is_double() && exact::orient3d(third, Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)) == 0;
}
