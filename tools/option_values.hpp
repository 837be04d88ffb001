// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// The options of a command that was parsed, by their names with underscores: those that were given, and
/// those that have a default. Not where files are.
Json option_values(const CLI::App& command);

}  // namespace multimesh::tools
