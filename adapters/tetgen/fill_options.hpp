// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adapters/tetgen/worker_call.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// \throw UsageError if an option is out of its range
void check_options(const TetrahedralizeOptions& options);

/// The bound on volumes that the options imply; 0: none.
double volume_bound(const TetrahedralizeOptions& options);

/// Whether points may be added inside for size or quality.
bool refines(const TetrahedralizeOptions& options);

/// TetGen's switches that fill the whole convex hull, without unnecessary points.
std::string hull_switches(const TetrahedralizeOptions& options);

/// TetGen's switches that fill what is enclosed, and refine it.
std::string refining_switches(const TetrahedralizeOptions& options);

WorkerOptions worker_options(const TetrahedralizeOptions& options);

}  // namespace multimesh::tetgen
