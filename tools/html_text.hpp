// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// Text escaped for HTML, in an element or between quotes. Invalid UTF-8 becomes U+FFFD.
std::string html_escaped(std::string_view text);

/// JSON as the content of a <script>: without `<`, so nothing begins or ends a tag or a comment. Invalid
/// UTF-8 becomes U+FFFD.
std::string json_for_html(const Json& j);

}  // namespace multimesh::tools
