// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/domain_file.hpp"

namespace multimesh::tools {

/// How commands that make a new mesh of a file of simplices take it.
struct DomainInputOptions {
  std::string weld;  ///< a distance; empty: points stay as they are
  bool no_weld = false;
  bool no_periodic = false;
};

/// Adds --weld and --no-weld. The options must live as long as the command.
void add_weld_options(CLI::App& command, DomainInputOptions& options);
/// Adds --no-periodic.
void add_periodic_option(CLI::App& command, DomainInputOptions& options);

/// Reads a file; welds points if asked for; of points at one place, and of sides that look periodic, warnings
/// tell. `sides_stay`: the command leaves the points and triangles of the sides as they are.
/// \throw InputError also for a file with periodic links, which would be lost, without --no-periodic
DomainFile read_domain_input(const std::filesystem::path& path, const DomainInputOptions& options,
                             bool sides_stay);
/// The same for a file that was read.
void prepare_domain_input(DomainFile& file, const DomainInputOptions& options, bool sides_stay);

/// Points at the place of another one. Cost: linear
std::size_t count_coincident(const io::SimplexSoup& soup);
/// Pairs of points that the file says are copies of one another on opposite sides.
std::size_t count_periodic_pairs(const io::SimplexSoup& soup);

}  // namespace multimesh::tools
