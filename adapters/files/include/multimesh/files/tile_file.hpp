// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::files {

/// A periodic tile, and the information needed to write its file again.
struct TileFile {
  std::filesystem::path path;
  PeriodicTile tile;
  /// The gluing that the file declares ($Periodic). By default, if it declares none, the sides of the
  /// bounding box are matched along all axes.
  PeriodicOptions options;
  DomainGroups groups;  ///< of the facets
  std::vector<std::string> warnings;
};

/// Reads the tetrahedra of a file of any format, else its triangles, to be glued as PeriodicDomain(file.tile,
/// file.options). Simplices of lower dimensions are left out, with a warning. \throw InputError for files of
/// points and edges, for links other than translations, as read_simplices
TileFile read_tile(const std::filesystem::path& path);

/// Writes the current tile, with its regions, and to .msh with its sides as periodic links, from which it can
/// be glued again. \return sentences on what the format cannot store. \throw InputError
std::vector<std::string> write_tile(const std::filesystem::path& path, const PeriodicDomain& domain,
                                    const DomainGroups& groups = {},
                                    const io::SimplexWriteOptions& options = {});

}  // namespace multimesh::files
