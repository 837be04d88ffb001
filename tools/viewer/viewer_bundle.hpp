// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace multimesh::tools {

/// The contents of every report page besides its data, in pieces to be written one after the other.
struct ViewerBundle {
  std::span<const std::string_view> page;    ///< HTML inside <body>
  std::span<const std::string_view> script;  ///< one script, three.js included; has no `</script`
  std::span<const std::string_view> style;   ///< one style sheet; has no `</style`
};

/// Null in a build without MULTIMESH_WITH_VIEWER.
const ViewerBundle* viewer_bundle();

}  // namespace multimesh::tools
