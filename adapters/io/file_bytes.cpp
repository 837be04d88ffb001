// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/file_bytes.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {
namespace {

[[noreturn]] void fail_open(const std::string& name, int error) {
  if (error == ENOENT) fail_file(name, "the file does not exist; check the path");
  if (error == EACCES || error == EPERM)
    fail_file(name, "the file cannot be read: permission denied; check its access rights");
  fail_file(name, std::string("the file cannot be opened: ") + std::strerror(error));
}

std::size_t regular_size(const std::string& name) {
  struct stat info {};
  if (::stat(name.c_str(), &info) != 0) fail_open(name, errno);
  if (S_ISDIR(info.st_mode)) fail_file(name, "this is a directory; give the path of a mesh file");
  if (!S_ISREG(info.st_mode)) fail_file(name, "this is not a regular file; save the mesh to a file first");
  return static_cast<std::size_t>(info.st_size);
}

/// Aligned for huge pages, which make the first write to a large buffer several times cheaper.
char* allocate(std::size_t size) {
  constexpr std::size_t page = std::size_t{2} << 20U;
  const bool large = size > 4 * page;
  const std::size_t rounded = large ? (size + page - 1) / page * page : size + 1;
  void* memory = large ? std::aligned_alloc(page, rounded) : std::malloc(rounded);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (large) ::madvise(memory, rounded, MADV_HUGEPAGE);
#endif
  return static_cast<char*>(memory);
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : name_(path.string()),
      left_(regular_size(name_)),
      descriptor_(::open(name_.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) fail_open(name_, errno);
}

InputFile::~InputFile() {
  ::close(descriptor_);
}

std::size_t InputFile::read(char* to, std::size_t size) {
  std::size_t done = 0;
  size = std::min(size, left_);
  while (done < size) {
    const ssize_t got = ::read(descriptor_, to + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_file(name_, std::string("the file cannot be read: ") + std::strerror(errno));
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  left_ = done < size ? 0 : left_ - done;
  return done;
}

FileBytes::FileBytes(const std::filesystem::path& path) {
  InputFile file(path);
  const std::size_t expected = file.left();
  data_.reset(allocate(expected));
  size_ = file.read(data_.get(), expected);
}

std::string_view TextPieces::next() {
  while (true) {
    fill();
    // A piece shorter than `least` may be cut short by a long line that begins in it.
    const std::size_t size = file_.left() == 0 ? end_ - begin_ : complete_lines();
    if (size >= least_ || file_.left() == 0) {
      const std::string_view piece(buffer_.data() + begin_, size);
      begin_ += size;
      return piece;
    }
    buffer_.resize(2 * buffer_.size());
  }
}

/// Moves the rest to the front, and reads as much as there is room for.
void TextPieces::fill() {
  if (buffer_.empty()) buffer_.resize(2 * least_);
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  end_ += file_.read(buffer_.data() + end_, buffer_.size() - end_);
}

/// The size of the lines that are complete and not continued in the rest.
std::size_t TextPieces::complete_lines() const {
  std::string_view text(buffer_.data() + begin_, end_ - begin_);
  while (!text.empty()) {
    text = text.substr(0, text.rfind('\n') + 1);  // 0 if there is none
    if (!text.ends_with("\\\n") && !text.ends_with("\\\r\n")) return text.size();
    text.remove_suffix(1);
  }
  return 0;
}

}  // namespace multimesh::io
