// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace multimesh::io {

/// Blanks are skipped, and padding may be anywhere: several encoded pieces in sequence are read as one. False
/// when another character occurs.
bool decode_base64(std::string_view text, std::string& bytes);

std::string encode_base64(std::string_view bytes);

}  // namespace multimesh::io
