// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Parses a Gmsh file, version 2.2 (and 2.0, 2.1) or 4.1, text or binary. A simplex has its physical tag or,
/// if no simplex of its dimension has one, the tag of its geometrical entity. Names of physical groups become
/// the soup's groups; $Periodic is kept; elements of higher order keep only their corners. Messages name
/// `path`.
/// \throw InputError `FILE:LINE:` or `FILE: byte|element N:` for what cannot be read, and for volume elements
///   other than tetrahedra.
SimplexSoup parse_msh(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
