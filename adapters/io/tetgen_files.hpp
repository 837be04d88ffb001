// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Reads TetGen's pair of files NAME.node and NAME.ele (each may be gzipped), given either. The first
/// attribute of a tetrahedron is its tag if all are whole numbers; boundary markers of points are point_tags.
/// Where NAME.face and NAME.edge are beside them, their triangles and edges are read, with their markers as
/// tags.
/// Points count from 0 or 1, as the first one does. \throw InputError naming the file and line, also when the
/// other file of the pair is missing.
SimplexSoup read_tetgen_pair(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace multimesh::io
