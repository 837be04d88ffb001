// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "adapters/io/file_bytes.hpp"

namespace multimesh::io {

/// True for the beginning of a gzip file.
inline bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1F\x8B");
}

/// The content of a gzip file, of all its members. Cost: memory for the content. \throw InputError naming
/// `file` when the data is damaged or truncated.
std::string gunzip(std::string_view bytes, const std::string& file);

/// The content of one zlib stream, as in VTK files. At most `most` bytes. \throw InputError naming `file`
/// when it is damaged, truncated or longer.
std::string inflate_zlib(std::string_view bytes, std::size_t most, const std::string& file);

/// One zlib stream with that content.
std::string deflate_zlib(std::string_view content);

/// A file read into memory, and unpacked if it is gzip, whatever its name.
class UnpackedBytes {
 public:
  /// \throw InputError as InputFile and gunzip
  explicit UnpackedBytes(const std::filesystem::path& path);
  std::string_view view() const { return packed_ ? std::string_view(unpacked_) : bytes_.view(); }

 private:
  FileBytes bytes_;
  bool packed_;
  std::string unpacked_;
};

/// The extension that determines the format, in lower case: for `a.msh.gz` it is `.msh`.
std::string format_extension(const std::filesystem::path& path);

}  // namespace multimesh::io
