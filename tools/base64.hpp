// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace multimesh::tools {

/// RFC 4648, with padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace multimesh::tools
