// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace multimesh::io {

/// Splits what follows `mtllib` into file names. Names are separated by blanks, but exporters also write
/// names with blanks. The longest run of words that names an existing file in `directory` is one name; if
/// there is none, the words up to the first that ends in .mtl; if there is none either, one word.
std::vector<std::string> split_library_names(std::string_view text, const std::filesystem::path& directory);

}  // namespace multimesh::io
