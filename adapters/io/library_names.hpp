// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace multimesh::io {

/// Splits what follows `mtllib` into file names. Names are separated by blanks, and exporters write names
/// with blanks: the longest run of words that names an existing file in `directory` is one name; where there
/// is none, the words up to the first that ends in .mtl; where there is none either, a word.
std::vector<std::string> split_library_names(std::string_view text, const std::filesystem::path& directory);

}  // namespace multimesh::io
