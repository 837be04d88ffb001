// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/file_descriptor.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace multimesh::tetgen {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// Moves a file above the numbers at which the worker has its files. Otherwise, if the caller has closed its
// standard streams, passing one file could overwrite another that is still to be passed.
FileDescriptor moved_up(FileDescriptor file) {
  return FileDescriptor(::fcntl(file.get(), F_DUPFD_CLOEXEC, 10));
}

}  // namespace

FileDescriptor::FileDescriptor(int fd) : fd_(fd) {
  if (fd < 0) fail("cannot open a file for the TetGen worker");
}

FileDescriptor::~FileDescriptor() {
  close();
}

void FileDescriptor::close() noexcept {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

FileDescriptor anonymous_file() {
#ifdef __linux__
  return moved_up(FileDescriptor(::memfd_create("multimesh-tetgen", MFD_CLOEXEC)));
#else
  std::string path = (std::filesystem::temp_directory_path() / "multimesh-tetgen-XXXXXX").string();
  FileDescriptor file(::mkostemp(path.data(), O_CLOEXEC));
  ::unlink(path.c_str());
  return moved_up(std::move(file));
#endif
}

std::pair<FileDescriptor, FileDescriptor> pipe_ends() {
  int ends[2];
#ifdef __linux__
  if (::pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe for the TetGen worker");
#else
  if (::pipe(ends) != 0) fail("cannot make a pipe for the TetGen worker");
#endif
  FileDescriptor read(ends[0]), write(ends[1]);
  read = moved_up(std::move(read)), write = moved_up(std::move(write));
  if (::fcntl(read.get(), F_SETFL, O_NONBLOCK) != 0) fail("cannot set up a pipe for the TetGen worker");
  return {std::move(read), std::move(write)};
}

std::uint64_t file_size(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) fail("cannot read the reply of the TetGen worker");
  return static_cast<std::uint64_t>(status.st_size);
}

bool read_at(int fd, void* to, std::size_t size, std::uint64_t offset) {
  auto* at = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t done = ::pread(fd, at, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += done, size -= static_cast<std::size_t>(done), offset += static_cast<std::uint64_t>(done);
  }
  return true;
}

bool write_at(int fd, const void* from, std::size_t size, std::uint64_t offset) {
  const auto* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t done = ::pwrite(fd, at, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += done, size -= static_cast<std::size_t>(done), offset += static_cast<std::uint64_t>(done);
  }
  return true;
}

}  // namespace multimesh::tetgen
