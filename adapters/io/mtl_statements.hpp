// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace multimesh::io {

/// The texture statements of MTL files: map_*, bump, disp, decal, refl, norm.
bool is_texture_statement(std::string_view word);

/// The lines of a text that are blank, comments or statements of an MTL file with valid arguments; all others
/// are counted and left out.
struct MtlText {
  std::string text;
  std::size_t statements = 0;  ///< that were kept
  std::size_t left_out = 0;    ///< lines

  /// A text is not a material library if it has no statement, or most of its lines are not statements.
  bool is_mtl() const { return statements > left_out; }
};

MtlText read_mtl(std::string_view bytes);

}  // namespace multimesh::io
