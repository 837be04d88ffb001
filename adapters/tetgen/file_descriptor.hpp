// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace multimesh::tetgen {

/// An open file of this process, closed on destruction. Programs that other threads start do not inherit it.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  /// Takes ownership of an open file. \throw std::system_error if fd < 0, from errno
  explicit FileDescriptor(int fd);
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const noexcept { return fd_; }
  void close() noexcept;

 private:
  int fd_ = -1;
};

/// An empty file without a name; it is gone when it is closed everywhere. \throw std::system_error
FileDescriptor anonymous_file();

/// A pipe: the read end, which never blocks, and the write end. \throw std::system_error
std::pair<FileDescriptor, FileDescriptor> pipe_ends();

/// The size of a file in bytes. \throw std::system_error
std::uint64_t file_size(int fd);

/// Reads all bytes; or false at the end of the file, or on an error.
bool read_at(int fd, void* to, std::size_t size, std::uint64_t offset);
bool write_at(int fd, const void* from, std::size_t size, std::uint64_t offset);

}  // namespace multimesh::tetgen
