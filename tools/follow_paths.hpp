// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace multimesh::tools {

inline void add_follow_paths(CLI::App& command, bool& on) {
  command.add_flag("--follow-paths", on,
                   "also use material libraries and textures outside the input's directory");
}

}  // namespace multimesh::tools
