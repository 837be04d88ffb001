// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace multimesh::tools {

/// IN and -o of the commands that read a surface and write one.
inline void add_surface_paths(CLI::App& command, std::string& input, std::string& output) {
  command
      .add_option("IN", input, "surface to read: OBJ, PLY, OFF, STL; MSH, MEDIT, VTK, VTU, VTP; also gzipped")
      ->required();
  command.add_option("-o,--output", output, "file to write: OBJ; or PLY, OFF, STL, which have room for less")
      ->required();
}

}  // namespace multimesh::tools
