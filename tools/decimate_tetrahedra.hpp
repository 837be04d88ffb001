// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/decimate_arguments.hpp"

namespace multimesh::tools {

/// --improve, and what add_tetrahedra_options() adds.
void add_tetrahedra_options(CLI::App& command, DecimateArguments& a);

/// Decimates the surface of the tetrahedra in the input, and writes them. `command`: has been parsed into
/// `a`. \return false if the input has none: then nothing was done. \throw InputError also for options that
/// one kind of input has no use for
bool decimate_if_tetrahedra(const CLI::App& command, const DecimateArguments& a);

}  // namespace multimesh::tools
