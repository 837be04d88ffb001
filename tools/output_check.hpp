// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace multimesh::tools {

/// What can be known to go wrong with an output before the work is done: a path that cannot be written, or
/// that is one of the files in `others`. \throw InputError
void check_output_path(const std::filesystem::path& output, const std::vector<std::filesystem::path>& others);

/// The same of a surface that is to be written, which must be an OBJ, PLY, OFF or STL file. \throw InputError
void check_surface_output(const std::filesystem::path& output);

}  // namespace multimesh::tools
