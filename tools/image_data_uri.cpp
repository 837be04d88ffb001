// SPDX-License-Identifier: BSD-3-Clause
#include "tools/image_data_uri.hpp"

#include <system_error>

#include "adapters/io/file_bytes.hpp"
#include "multimesh/error.hpp"
#include "tools/base64.hpp"

namespace multimesh::tools {

std::string_view image_type(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff"sv)) return "image/jpeg";
  if (bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv)) return "image/webp";
  if (bytes.starts_with("GIF87a"sv) || bytes.starts_with("GIF89a"sv)) return "image/gif";
  if (bytes.starts_with("BM"sv)) return "image/bmp";
  return {};
}

ImageDataUri image_data_uri(const std::filesystem::path& path, std::size_t limit) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {{}, "the file was not found"};
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > limit) return {{}, "the file is larger than " + std::to_string(limit >> 20U) + " MiB"};
  try {
    const io::FileBytes bytes(path);
    const std::string_view type = image_type(bytes.view());
    if (type.empty()) return {{}, "not a PNG, JPEG, WebP, GIF or BMP file"};
    return {"data:" + std::string(type) + ";base64," + base64(bytes.view()), {}};
  } catch (const InputError&) {
    return {{}, "the file cannot be read"};
  }
}

}  // namespace multimesh::tools
