// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "multimesh/domains/textured_triangles.hpp"

namespace multimesh::figures {

/// Fills a surface with tetrahedra, remeshes the surface of these, and draws both, cut open.
void remeshed_tetrahedra(const TexturedTriangles& surface, const std::filesystem::path& directory);

}  // namespace multimesh::figures
