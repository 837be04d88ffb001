// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "adapters/io/output_buffer.hpp"
#include "multimesh/io/simplex_soup.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::io {

/// The writers of single formats, for write_simplices. Each appends to `lost` what it did not write, as the
/// subject of a sentence (`names of groups`). \pre the soup was checked
using Lost = std::vector<std::string>;

/// For Gmsh's formats, tags must be positive (make_tags_positive). \throw InputError when version 2.2 cannot
/// hold the sizes. Messages name `file`.
void put_msh2(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file, Lost& lost);
void put_msh4(OutputBuffer& out, const SimplexSoup& soup, bool binary, Lost& lost);
void put_medit(OutputBuffer& out, const SimplexSoup& soup, Lost& lost);
void put_vtu(OutputBuffer& out, const SimplexSoup& soup, bool binary, Lost& lost);
/// \throw InputError when a coordinate is too large for a float. Messages name `file`.
void put_stl(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file);
void put_off(OutputBuffer& out, const SimplexSoup& soup);
void put_ply(OutputBuffer& out, const SimplexSoup& soup, bool binary);

/// `x y z`
inline void put_point(OutputBuffer& out, const std::array<double, 3>& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (i != 0) out.character(' ');
    out.number(point[i]);
  }
}

/// `corner corner …`, counted from `first`, each followed by a blank.
inline void put_corners(OutputBuffer& out, const SimplexSoup::Block& block, std::size_t dimension,
                        std::size_t i, std::uint64_t first) {
  for (std::size_t c = 0; c <= dimension; ++c) {
    out.number(block.corners[(dimension + 1) * i + c] + first);
    out.character(' ');
  }
}

inline bool has_flags(const SimplexSoup& soup) {
  for (const auto& block : soup.simplices)
    for (const std::uint8_t flag : block.flags)
      if (flag != 0) return true;
  return false;
}

}  // namespace multimesh::io
