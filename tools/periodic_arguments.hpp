// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multimesh/algorithms/tile_topology.hpp"
#include "multimesh/files/tile_file.hpp"
#include "tools/domain_arguments.hpp"
#include "tools/run_report.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace multimesh::tools {

/// Of the improvement of tetrahedra whose surface was changed: what it does not reach by then takes long, and
/// many more tetrahedra.
constexpr int passes_in_tile = 10;
constexpr double growth_in_tile = 1.5;

/// What commands are told about periodic tiles.
struct PeriodicArguments {
  std::string axes;  ///< empty: the mesh is not taken as a tile
  std::string periods, sides, pair_table, equations;
  double tolerance = 1e-6;
  double corner_angle = 20;    ///< degrees; of interfaces and boundaries in tiles of triangles
  double feature_angle = 180;  ///< the same of surfaces in tiles of tetrahedra

  bool is_given() const { return !axes.empty(); }
};

constexpr const char* periodic_group = "Periodic tiles";

/// --periodic, --periods and --match-tolerance. \return the first one
CLI::Option* add_periodic_tile_options(CLI::App& command, PeriodicArguments& a);
/// --sides, --pair-table and --abaqus-equations.
void add_tile_output_options(CLI::App& command, PeriodicArguments& a);

/// A tile of a file and the domain made of it.
struct ReadTile {
  files::TileFile file;
  PeriodicDomain domain;
};
/// \throw InputError naming the file, if it is not periodic as requested
ReadTile read_periodic(const std::string& input, const PeriodicArguments& a);

std::optional<TileSides> requested_sides(const PeriodicArguments& a);
const char* name_of(TileSides sides);

/// Checks the paths of all outputs. \throw InputError
void check_tile_outputs(const std::string& input, const std::string& output, const SimplexFormat& format,
                        const PeriodicArguments& a);

/// Writes the tile as write_if_same_mesh() does, then the tables.
std::vector<std::string> write_tile_outputs(const std::string& output, const TileTopology& before,
                                            const TileTopology& after, const PeriodicDomain& domain,
                                            const files::TileFile& file,
                                            const io::SimplexWriteOptions& options, double sizes,
                                            const PeriodicArguments& a);
/// A sentence, if anything was dropped.
std::vector<std::string> dropped_from_sides(std::size_t n);

Json to_json(const PeriodicDomain& domain, const TileTopology& topology);

}  // namespace multimesh::tools
