// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/remesh_arguments.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

/// Remeshes the surface of the tetrahedra in the input, and writes them. \return false if it has none: then
/// nothing was done. \throw InputError also for options that do not apply to this kind of input
bool remesh_if_tetrahedra(RemeshArguments& a, RunReport& report);

}  // namespace multimesh::tools
