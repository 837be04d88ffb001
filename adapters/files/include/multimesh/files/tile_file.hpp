// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::files {

/// A periodic tile, and what of its file is needed to write it again.
struct TileFile {
  std::filesystem::path path;
  PeriodicTile tile;
  /// What the file says is glued ($Periodic); the defaults if it says nothing: the sides of the bounding box
  /// are matched, along all axes.
  PeriodicOptions options;
  DomainGroups groups;  ///< of the facets
  std::vector<std::string> warnings;
};

/// The tetrahedra of a file of any format, or the triangles if it has none, to be glued as
/// PeriodicDomain(file.tile, file.options). Simplices of lower dimensions are left out, with a warning.
/// \throw InputError for files of points and edges, for links that are no translations, as read_simplices
TileFile read_tile(const std::filesystem::path& path);

/// Writes the tile as it is now, with its regions, and in .msh with its sides as periodic links, from which
/// it can be glued again. \return sentences on what the format has no room for. \throw InputError
std::vector<std::string> write_tile(const std::filesystem::path& path, const PeriodicDomain& domain,
                                    const DomainGroups& groups = {},
                                    const io::SimplexWriteOptions& options = {});

}  // namespace multimesh::files
