// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/io/weld_surface.hpp"
#include "tools/surface_json.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace multimesh::tools {

/// Adds --weld, --no-weld and --uv-weld; they are written into `o` when the command line is parsed.
void add_weld_options(CLI::App& command, io::SurfaceWeldOptions& o);

Json to_json(const io::SurfaceWeldOptions& o);
Json to_json(const io::SurfaceWeldReport& r);

}  // namespace multimesh::tools
