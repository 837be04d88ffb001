// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// Text as it stands in HTML, in an element or between quotes. What is not UTF-8 becomes U+FFFD.
std::string html_escaped(std::string_view text);

/// JSON as the content of a <script>: no `<` in it, so nothing that begins or ends a tag or a comment.
/// What is not UTF-8 becomes U+FFFD.
std::string json_for_html(const Json& j);

}  // namespace multimesh::tools
