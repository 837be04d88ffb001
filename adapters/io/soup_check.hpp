// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// A position with a coordinate that is nan, inf or too large for a double.
struct NonfinitePosition {
  std::uint32_t position;
  std::size_t line;  ///< of the file, counted from 1; 0 = none (binary)
};

/// The last step of every reader. Checks all indices: a face that names a vertex out of range is refused; a
/// corner that names a texture coordinate or normal beyond the last one loses it. Then values that are not
/// finite: a position that a face or line names is refused; a corner that names such a texture coordinate
/// loses it; colours become white. Values that no corner names are ignored, and replaced by a named value.
/// Then the faces are cleaned (see clean_faces). Every change is counted in the notes, with one warning of
/// each kind. \post every index in range; every position, texture coordinate and colour finite; as
/// clean_faces. \throw InputError for an index out of range, a position that is not finite, or no face left.
/// Names the line or, in formats without lines, the face (counted from 0). Messages number vertices as the
/// format does, from `first_index`.
void check_soup(PolygonSoup& soup, std::string_view file, int first_index, const ReadOptions& options,
                std::span<const NonfinitePosition> nonfinite = {});

/// Removes corners that repeat the corner before them, faces with fewer than three distinct vertices left,
/// and (unless `keep_repeated`) faces with the vertices of an earlier one, in any order, and its texture and
/// material; counts faces without area. Each is counted in the notes, with one warning. \pre every index is
/// in range. \post no two consecutive corners of a face share their vertex. \throw InputError if there were
/// faces, and none with an area is left
void clean_faces(PolygonSoup& soup, std::string_view file, bool keep_repeated, int first_index = 0);

/// The part of clean_faces for corners that repeat the one before them, and for the remaining faces without
/// three distinct vertices.
void remove_collapsed_faces(PolygonSoup& soup, std::string_view file);

/// Removes the faces of the list, which is ascending, and those without corners.
void remove_faces(PolygonSoup& soup, std::span<const std::uint32_t> faces);

}  // namespace multimesh::io
