// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace multimesh::io {

/// Refuses content that is not a mesh in text form, whatever its name: an empty file, a web page, a Git LFS
/// pointer, UTF-16 or UTF-32 text, a compressed or another binary file, a mesh of another format. Examines
/// the first 4096 bytes.
/// \throw InputError naming the file, what it is and what to do.
void check_obj_content(std::string_view bytes, std::string_view file);

/// Refuses what is not a mesh in any of our formats: an empty file, a web page, a Git LFS pointer, UTF-16 or
/// UTF-32 text, XML, compressed files. \throw InputError naming the file, what it is and what to do.
void refuse_foreign(std::string_view bytes, std::string_view file);

/// The same for PLY: refuses what does not begin with the line `ply`, naming it as precisely as we can.
void check_ply_content(std::string_view bytes, std::string_view file);

}  // namespace multimesh::io
