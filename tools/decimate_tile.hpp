// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/decimate_arguments.hpp"

namespace multimesh::tools {

/// --periodic and what belongs to it.
void add_tile_options(CLI::App& command, DecimateArguments& a);

/// Runs the command on a periodic tile. `command`: has been parsed into `a`. \pre --periodic is given
void decimate_tile(const CLI::App& command, DecimateArguments& a);

}  // namespace multimesh::tools
