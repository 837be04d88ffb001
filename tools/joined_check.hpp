// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

#include "multimesh/algorithms/surface_topology.hpp"
#include "multimesh/algorithms/tet_topology.hpp"

namespace multimesh::tools {

using Write = std::function<void(const std::filesystem::path&)>;

/// Calls `write` with the output's path if the tetrahedra, joined as a reader of the file will join them,
/// have the topology, boundary and volumes that they had before. If not, that is a fault of ours: `write`
/// gets a path beside the output, and an InputError names it and what differs. An older file at the output's
/// path is left alone then. `displacement`: by how far points of the surface may have been moved on purpose.
void write_if_same_mesh(const std::filesystem::path& output, const TetTopology& before,
                        const TetDomain& domain, const Write& write, double displacement = 0);
/// The same of a surface.
void write_if_same_mesh(const std::filesystem::path& output, const SurfaceTopology& before,
                        const TexturedSurface& surface, const Write& write);

}  // namespace multimesh::tools
