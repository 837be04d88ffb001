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
  /// bounding box are matched along all axes. Interfaces are kept.
  PeriodicOptions options;
  DomainGroups groups;
  std::vector<std::string> warnings;
};

/// Reads the tetrahedra of a file of any format, else its triangles, to be glued as PeriodicDomain(file.tile,
/// file.options). Simplices of lower dimensions are listed in the tile. \throw InputError for files of
/// points and edges, for links other than translations, as read_simplices
TileFile read_tile(const std::filesystem::path& path);
/// read_tile(), of a file that has been read.
TileFile to_tile(DomainFile file);

/// Asks for other periods than the file's: along these axes, and these vectors if given. Sides are then
/// matched by place. If no vectors are given and the file declares the same axes, but for those without
/// extent, its pairs are used.
void set_periods(TileFile& file, const std::array<bool, 3>& axes,
                 const std::optional<std::array<std::array<double, 3>, 3>>& periods);

/// What was unusual about the input, in sentences.
std::vector<std::string> warnings_of(const PeriodicReport& report);

/// Writes the current tile, with its regions and what it lists, and to .msh with its sides as periodic links,
/// from which it can be glued again. \return sentences on what the format cannot store. \throw InputError
std::vector<std::string> write_tile(const std::filesystem::path& path, const PeriodicDomain& domain,
                                    const DomainGroups& groups = {},
                                    const io::SimplexWriteOptions& options = {});

// The copies of its vertices for solvers, by their numbers in a file that write_tile() writes, from 1 on; in
// order 2, those of the nodes in the middles of edges, too. Each has one master, that of the lowest number;
// no vertex is slave and master. \throw InputError
/// CSV with the columns slave,master,kx,ky,kz: the lattice vector from master to slave. The period vectors
/// are in comments.
void write_pair_table(const std::filesystem::path& path, const PeriodicDomain& domain, int order = 1);
/// Equations of Abaqus and CalculiX, one per pair and degree of freedom: the displacement of the slave is
/// that of the master, plus those of the reference nodes of the periods between them. These nodes are defined
/// in the same file.
void write_abaqus_equations(const std::filesystem::path& path, const PeriodicDomain& domain, int order = 1);

}  // namespace multimesh::files
