// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/file_bytes.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <string>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

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

FileBytes::FileBytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::size_t expected = regular_size(name);
  const Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail_open(name, errno);
  data_.reset(allocate(expected));
  while (size_ < expected) {
    const ssize_t got = ::read(file.get(), data_.get() + size_, expected - size_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_file(name, std::string("the file cannot be read: ") + std::strerror(errno));
    if (got == 0) break;
    size_ += static_cast<std::size_t>(got);
  }
}

}  // namespace multimesh::io
