// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "multimesh/files/formats.hpp"

namespace multimesh::tools {

/// IN and -o of the commands that read a surface, which may be that of tetrahedra, and write it.
inline void add_surface_paths(CLI::App& command, std::string& input, std::string& output) {
  command.add_option("IN", input, files::all_formats)->required();
  command
      .add_option(
          "-o,--output", output,
          std::string(files::written_surface_formats) + "; tetrahedra: " + files::written_simplex_formats)
      ->required();
}

}  // namespace multimesh::tools
