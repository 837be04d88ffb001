// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>

namespace multimesh::io {

/// A file read into memory by one read: a file that another program truncates meanwhile does no harm,
/// as it would under a memory map.
class FileBytes {
 public:
  /// \throw InputError when the file is missing, a directory, a device or unreadable; each says so.
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return {data_.get(), size_}; }

 private:
  struct Free {
    void operator()(char* memory) const { std::free(memory); }
  };
  std::unique_ptr<char[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace multimesh::io
