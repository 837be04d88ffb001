// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/algorithms/surface_topology.hpp"
#include "multimesh/algorithms/tet_topology.hpp"
#include "multimesh/algorithms/tile_topology.hpp"
#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/files/tile_file.hpp"

namespace multimesh::tools {

// Each compares the result with the input. If they differ, that is our bug: the result is written to a path
// beside the output, and an InputError names that path and the differences. An older file at the output's
// path is left unchanged then.

/// A domain as plain lists, and their mesh, joined as a reader of the file will join them.
struct DomainResult {
  TaggedTetrahedra lists;
  TetTopology topology;
  explicit DomainResult(const TetDomain& domain) : lists(domain.tagged()), topology(topology_of(lists)) {}
};

/// Writes a domain, if its topology, boundary and volumes are those of the input. `displacement`: how far
/// points of the surface may have been moved on purpose. \return as files::write_domain()
std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output, const TetTopology& before,
                                            DomainResult after, const files::DomainGroups& groups,
                                            const files::DomainWriteOptions& options,
                                            double displacement = 0);
/// Writes a surface, if its topology is that of the input. \return as files::write_surface()
std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output,
                                            const SurfaceTopology& before, const TexturedSurface& surface,
                                            const files::SurfaceFile& file);

/// Writes a tile, if its topology, `after`, is that of the input. `sizes`: by how much of itself the size of
/// a region may have changed. \return as files::write_tile()
std::vector<std::string> write_if_same_mesh(const std::filesystem::path& output, const TileTopology& before,
                                            const TileTopology& after, const PeriodicDomain& domain,
                                            const files::DomainGroups& groups,
                                            const io::SimplexWriteOptions& options, double sizes);

}  // namespace multimesh::tools
