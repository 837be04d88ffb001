// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/algorithms/surface_topology.hpp"

namespace multimesh::tools {

/// Keeps the order of insertion: reports are read by people too.
using Json = nlohmann::ordered_json;

/// {"surface": .., "texture": .., "seams": .., "features": ..}; all but the first are null where there is
/// none. "more_uv_sets", a list of texture and seams, only if there are some.
Json to_json(const TexturedSurface& surface);
Json to_json(const SurfaceReport& report);
Json to_json(const MeshReport& mesh);
Json to_json(const SurfaceTopology& joined);

/// Indented. File and material names need not be UTF-8: invalid bytes become U+FFFD.
std::string to_text(const Json& j);

}  // namespace multimesh::tools
