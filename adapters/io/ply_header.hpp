// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multimesh::io {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };

std::size_t byte_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType size_type = PlyType::uint8;  ///< of the length of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::size_t line = 0;  ///< of its declaration
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  ///< of `comment TextureFile NAME`
  std::size_t size = 0;               ///< bytes up to and including the line end_header
  std::size_t lines = 0;
};

/// \throw InputError naming the line that is wrong, or saying that end_header is missing.
PlyHeader read_ply_header(std::string_view bytes, std::string_view file);

}  // namespace multimesh::io
