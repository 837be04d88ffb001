// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/compare.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

/// {"diagonal", "distance": .., "texture": .., "original": .., "other": ..}; docs/compare.md has the fields.
/// texture is null unless both are textured; a PSNR of infinity is null.
Json to_json(const SurfaceComparison& comparison);

}  // namespace multimesh::tools
