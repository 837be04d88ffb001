// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/gunzip.hpp"

#define ZLIB_CONST  // next_in of z_stream is then a pointer to const
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "adapters/io/input_location.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

constexpr int zlib_format = 15, gzip_format = 15 + 16;  // window bits, as inflateInit2 takes them
constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();

/// zlib's state, released in any case.
class Inflater {
 public:
  Inflater(std::string_view bytes, int format) : bytes_(bytes) {
    if (inflateInit2(&stream_, format) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  /// Fills `to` as far as it can. \return how much; `status` is zlib's
  std::size_t read(char* to, std::size_t size, int& status) {
    const std::size_t in = std::min(bytes_.size(), most_at_once), out = std::min(size, most_at_once);
    stream_.next_in = reinterpret_cast<const Bytef*>(bytes_.data());
    stream_.avail_in = static_cast<uInt>(in);
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(out);
    status = inflate(&stream_, Z_NO_FLUSH);
    bytes_.remove_prefix(in - stream_.avail_in);
    return out - stream_.avail_out;
  }

  /// What follows the stream.
  std::string_view rest() const { return bytes_; }
  void begin_next() { inflateReset(&stream_); }

 private:
  std::string_view bytes_;
  z_stream stream_{};
};

[[noreturn]] void fail_unpacking(const std::string& file, int status, std::string_view what) {
  const char* reason = status == Z_OK || status == Z_BUF_ERROR ? " is truncated" : " is damaged";
  fail_file(file, std::string(what) + reason + "; get the file whole");
}

}  // namespace

std::string gunzip(std::string_view bytes, const std::string& file) {
  constexpr std::size_t step = std::size_t{1} << 20U;
  Inflater inflater(bytes, gzip_format);
  std::string content;
  while (true) {
    const std::size_t before = content.size();
    content.resize(before + std::max(step, before / 2));
    int status = Z_OK;
    const std::size_t got = inflater.read(content.data() + before, content.size() - before, status);
    content.resize(before + got);
    if (status == Z_STREAM_END) {
      if (!is_gzip(inflater.rest())) return content;  // the rest is padding
      inflater.begin_next();
    } else if (status != Z_OK || (got == 0 && inflater.rest().empty())) {
      fail_unpacking(file, status, "the gzip data");
    }
  }
}

std::string inflate_zlib(std::string_view bytes, std::size_t most, const std::string& file) {
  Inflater inflater(bytes, zlib_format);
  // Grows with the actual content, because `most` may be a false claim.
  std::string content(std::min(most, 4 * bytes.size() + 1024), '\0');
  std::size_t size = 0;
  int status = Z_OK;
  while (status == Z_OK) {
    if (size == content.size()) content.resize(std::min(most, 2 * size));
    const std::size_t got = inflater.read(content.data() + size, content.size() - size, status);
    size += got;
    if (status == Z_OK && got == 0) break;
  }
  if (status != Z_STREAM_END) fail_unpacking(file, status, "the zlib data of an array");
  content.resize(size);
  return content;
}

std::string deflate_zlib(std::string_view content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string packed(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(content.data());
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, from, static_cast<uLong>(content.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

UnpackedBytes::UnpackedBytes(const std::filesystem::path& path)
    : bytes_(path), packed_(is_gzip(bytes_.view())) {
  if (packed_) unpacked_ = gunzip(bytes_.view(), path.string());
}

std::string format_extension(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".gz" ? lower_case(path.stem().extension().string()) : extension;
}

}  // namespace multimesh::io
