// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multimesh::io {

/// A file that is read once, from its beginning: no more bytes than it has when it is opened. A file that
/// another program truncates meanwhile does no harm, as it would under a memory map.
class InputFile {
 public:
  /// \throw InputError when the file is missing, a directory, a device or unreadable; each says so.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Bytes that are not read yet, if it was not truncated.
  std::size_t left() const { return left_; }
  /// The next bytes. \return how many: fewer than `size` at the end only. \throw InputError
  std::size_t read(char* to, std::size_t size);

 private:
  std::string name_;
  std::size_t left_;
  int descriptor_;
};

/// A file read into memory.
class FileBytes {
 public:
  /// \throw InputError as InputFile
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return {data_.get(), size_}; }

 private:
  struct Free {
    void operator()(char* memory) const { std::free(memory); }
  };
  std::unique_ptr<char[], Free> data_;
  std::size_t size_ = 0;
};

/// A text file piece by piece, in one buffer. A piece ends where a line does that goes on in no other one (by
/// a
/// `\` at its end); the last piece ends with the file. The others have `least` bytes or more: as many as the
/// lines need. A text without LF is one piece.
class TextPieces {
 public:
  /// \throw InputError as InputFile
  explicit TextPieces(const std::filesystem::path& path, std::size_t least = std::size_t{1} << 17U)
      : file_(path), size_(file_.left()), least_(least) {}

  /// Valid until the next call; empty at the end. \throw InputError
  std::string_view next();
  /// Of the file when it was opened.
  std::size_t size() const { return size_; }

 private:
  void fill();
  std::size_t complete_lines() const;

  InputFile file_;
  std::size_t size_;
  std::size_t least_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // of what is in the buffer and was not given out
};

}  // namespace multimesh::io
