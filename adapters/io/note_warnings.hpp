// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// Appends a warning for each kind of thing that, according to the notes, was left out or replaced while
/// reading `file`. What check_soup counts is not repeated here.
void add_note_warnings(PolygonSoup& soup, const std::string& file);

}  // namespace multimesh::io
