// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/surface_json.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

/// The options of a parsed command, by their names with underscores: those that were given, and those that
/// have a default. Without paths of files.
Json option_values(const CLI::App& command);

}  // namespace multimesh::tools
