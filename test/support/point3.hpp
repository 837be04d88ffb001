// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/geometry/vector.hpp"

namespace multimesh::test {

using Point3 = Vec3;

}  // namespace multimesh::test
