// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "adapters/io/polygon_soup.hpp"
#include "adapters/io/read_options.hpp"

namespace multimesh::io {

/// The last step of every reader. Checks all indices and the size of the model (CoordinateRange): a face that
/// names a vertex out of range is refused, a corner that names a texture coordinate or normal beyond the last
/// one loses it; removes corners that repeat the corner before them and the faces that are left with fewer
/// than three distinct vertices; counts faces without area and repeated ones. What was removed or counted
/// goes to the notes, and to one warning of each kind. \post face_count() > 0; every index in range; no two
/// consecutive corners of a face share their vertex. \throw InputError for an index out of range, more
/// defects than `options` allows, or no face left. Names
///   the line, or where the format has none, the face (counted from 0). Messages name vertices as the format
///   counts them, from `first_index`.
void check_faces(PolygonSoup& soup, std::string_view file, int first_index, const ReadOptions& options);

}  // namespace multimesh::io
