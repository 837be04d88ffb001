// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>

namespace multimesh::test {

using Point3 = OpenMesh::Vec3d;

}  // namespace multimesh::test
