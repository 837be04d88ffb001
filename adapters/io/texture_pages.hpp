// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// Texture images that the faces of a file name by numbers, as in PLY: each becomes a material.
class TexturePages {
 public:
  /// `images`: file names, by number.
  explicit TexturePages(const std::vector<std::string>& images);

  /// The section of a face. Numbers without an image have a material without a texture; below 0: none.
  std::uint32_t section(std::int64_t page, PolygonSoup& soup);

 private:
  std::string unique_name(const std::string& image) const;

  std::vector<std::string> images_;
  std::vector<std::int64_t> pages_;  ///< per section
  std::vector<std::string> names_;
};

}  // namespace multimesh::io
