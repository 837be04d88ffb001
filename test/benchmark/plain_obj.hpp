// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace multimesh::bench {

/// The triangles of an OBJ file: `v`, `vt` and `f` with positive indices, polygons as fans; everything else
/// is skipped. The least work with which a program can read its input, so that times with reading do not
/// measure the reader.
struct PlainObj {
  static constexpr std::uint32_t none = ~std::uint32_t{0};  ///< a corner without texture coordinates

  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<double, 2>> texcoords;
  std::vector<std::array<std::uint32_t, 3>> faces;     ///< indices of positions
  std::vector<std::array<std::uint32_t, 3>> uv_faces;  ///< indices of texcoords, or `none`; empty: no texture
};

/// \throw std::runtime_error naming the file
PlainObj read_plain_obj(const std::string& path);

/// Numbers are written with as many digits as it takes to read them back.
/// \throw std::runtime_error naming the file
void write_plain_obj(const std::string& path, const PlainObj& obj);

}  // namespace multimesh::bench
