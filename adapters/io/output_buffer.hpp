// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

#include "adapters/io/atomic_file.hpp"

namespace multimesh::io {

/// Collects text and binary numbers, and writes them to the file in large pieces. Call flush() at the end.
class OutputBuffer {
 public:
  explicit OutputBuffer(AtomicFile& file) : file_(file) {}

  void text(std::string_view s) {
    if (s.empty()) return;
    if (s.size() > capacity - used_) flush();
    if (s.size() > capacity) return file_.write(s);
    std::memcpy(data_.get() + used_, s.data(), s.size());
    used_ += s.size();
  }

  void character(char c) {
    room();
    data_[used_++] = c;
  }

  /// The fewest digits that reproduce the same number.
  template <class Number>
  void number(Number value) {
    room();
    char* const at = data_.get() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(at, at + 32, value).ptr - at);
  }

  /// The bytes of the number, little-endian.
  template <class Number>
  void little_endian(Number value) {
    static_assert(std::endian::native == std::endian::little, "swap the bytes here");
    room();
    std::memcpy(data_.get() + used_, &value, sizeof(Number));
    used_ += sizeof(Number);
  }

  void flush() {
    file_.write({data_.get(), used_});
    used_ = 0;
  }

 private:
  void room() {
    if (capacity - used_ < 64) flush();
  }

  static constexpr std::size_t capacity = std::size_t{1} << 20U;
  AtomicFile& file_;
  std::unique_ptr<char[]> data_ = std::make_unique_for_overwrite<char[]>(capacity);
  std::size_t used_ = 0;
};

}  // namespace multimesh::io
