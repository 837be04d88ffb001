// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "tools/domain_arguments.hpp"

namespace multimesh::tools {

/// Checks an output before the work is done: refuses a path that cannot be written, or that is one of the
/// files in `others`. \throw InputError
void check_output_path(const std::filesystem::path& output, const std::vector<std::filesystem::path>& others);
/// The same for files of simplices, which must have an extension that is written in this format.
void check_output_path(const std::filesystem::path& output, const std::vector<std::filesystem::path>& others,
                       const SimplexFormat& format);

/// The same for a surface to be written, which must be an OBJ, PLY, OFF or STL file. \throw InputError
void check_surface_output(const std::filesystem::path& output);

}  // namespace multimesh::tools
