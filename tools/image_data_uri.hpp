// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace multimesh::tools {

/// Image files larger than this are not embedded in a page.
constexpr std::size_t max_image_bytes = std::size_t{16} << 20U;

/// A file as a `data:` URI, or the reason why there is none.
struct ImageDataUri {
  std::string uri;      ///< empty: none
  std::string problem;  ///< empty: none
};

/// Formats that every browser shows: PNG, JPEG, WebP, GIF, BMP, recognized by content. Never throws for a
/// file that is missing or cannot be read: that is a problem to be noted.
ImageDataUri image_data_uri(const std::filesystem::path& path, std::size_t limit = max_image_bytes);

/// `image/png`, for instance, from the first bytes of a file; empty for any other format.
std::string_view image_type(std::string_view bytes);

}  // namespace multimesh::tools
