// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Parses an `MFEM mesh v1.0` whose vertices have coordinates. Attributes are the tags;
/// elements and the boundary are simplices of their dimensions. Messages name `path`.
/// \throw InputError `FILE:LINE: what; what to do`, also for curved and periodic
/// meshes, whose vertices have no coordinates, and for volume elements other than
/// tetrahedra.
SimplexSoup parse_mfem(std::string_view bytes, const std::filesystem::path& path,
                       const ReadOptions& options = {});

}  // namespace multimesh::io
