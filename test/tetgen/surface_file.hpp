// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "test/tetgen/closed_shapes.hpp"

namespace multimesh::test {

/// The triangles of an OFF, OBJ or STL file, as few lines as these tests need; equal points of an STL are
/// merged.
ClosedSurface read_surface(const std::filesystem::path& path);

}  // namespace multimesh::test
