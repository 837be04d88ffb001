// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace multimesh::io {

/// The file that a write to `path` replaces: `path` itself, or what it links to.
/// \throw InputError when it is a directory or a device, or when its directory does not exist.
std::filesystem::path checked_output_path(const std::filesystem::path& path);

}  // namespace multimesh::io
