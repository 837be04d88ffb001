// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adapters/io/atomic_file.hpp"
#include "tools/html_mesh.hpp"

namespace multimesh::tools {

/// The position of a page's meshes in space: single precision is not enough for coordinates far from the
/// origin.
struct HtmlFrame {
  Vec3 center{0, 0, 0};
  double size = 1;

  Vec3 operator()(const Vec3& p) const { return (p - center) / size; }
};

/// Centred, and with size 1 for the diagonal of the bounding box of both, over the positions used by
/// triangles.
HtmlFrame common_frame(const TexturedTriangles& before, const TexturedTriangles& after);

/// A <script> element with text that is not a script; the page finds it by its id. \pre no `<` in the text.
void write_block(io::AtomicFile& file, const std::string& id, std::string_view text);

/// Numbers of four bytes, little-endian, in base64, as a block.
void write_numbers(io::AtomicFile& file, const std::string& id, const std::vector<double>& values);

/// The arrays of a mesh as such blocks, `NAME-positions` and so on (tools/viewer/src/page_data.js).
void write_blocks(io::AtomicFile& file, const std::string& name, const HtmlMesh& mesh,
                  const HtmlFrame& frame);

}  // namespace multimesh::tools
