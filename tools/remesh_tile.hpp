// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/remesh_arguments.hpp"

namespace multimesh::tools {

/// Runs the command on a periodic tile. \pre --periodic is given
void remesh_tile(RemeshArguments& a, RunReport& report);

}  // namespace multimesh::tools
