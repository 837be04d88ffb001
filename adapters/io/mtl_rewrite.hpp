// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace multimesh::io {

/// The text of an MTL file with every texture path (map_*, bump, disp, decal, refl, norm) replaced by the
/// result of `relocate`. Options before or after a path (`-s 1 1 1`, `-bm 0.5`), quotes around it, names with
/// blanks, comments, line ends and everything else stay as they are.
std::string rewrite_textures(std::string_view mtl,
                             const std::function<std::string(std::string_view)>& relocate);

}  // namespace multimesh::io
