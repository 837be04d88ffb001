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

/// A file that is read once, from its beginning, up to the size it had when it was opened. If another program
/// truncates it meanwhile, nothing breaks, as it would with a memory map.
class InputFile {
 public:
  /// \throw InputError when the file is missing, a directory, a device or unreadable; each says so.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// The number of bytes not read yet, if it was not truncated.
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

/// A text file piece by piece, in one buffer. Each piece ends at the end of a line that
/// is not continued (by a `\` at its end); the last piece ends with the file. Pieces
/// have at least `least` bytes: as many as whole lines need. A text without LF is one
/// piece.
class TextPieces {
 public:
  /// \throw InputError as InputFile
  explicit TextPieces(const std::filesystem::path& path, std::size_t least = std::size_t{1} << 17U)
      : file_(path), size_(file_.left()), least_(least) {}

  /// Valid until the next call; empty at the end. \throw InputError
  std::string_view next();
  /// Size of the file when it was opened.
  std::size_t size() const { return size_; }

 private:
  void fill();
  std::size_t complete_lines() const;

  InputFile file_;
  std::size_t size_;
  std::size_t least_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // of the bytes in the buffer that were not returned yet
};

}  // namespace multimesh::io
