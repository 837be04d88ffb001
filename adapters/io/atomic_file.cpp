// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "adapters/io/input_location.hpp"
#include "adapters/io/output_path.hpp"
#include "adapters/io/pending_files.hpp"

namespace multimesh::io {
namespace {

/// A name in the directory of the target that no other process or thread uses.
std::string temporary_name(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter = 0;
  const std::string name =
      ".multimesh-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
  const std::filesystem::path absolute = std::filesystem::absolute(target);
  return (absolute.parent_path() / name).string();
}

void copy_permissions(const std::string& from, int fd) {
  struct stat info {};
  if (::stat(from.c_str(), &info) == 0) ::fchmod(fd, info.st_mode & 0777);
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : name_(path.string()) {
  target_ = checked_output_path(path).string();
  if (::access(target_.c_str(), F_OK) == 0 && ::access(target_.c_str(), W_OK) != 0)
    fail("the existing output file is write-protected; choose another name", errno);
  const std::string temporary = temporary_name(target_);
  // Registered before the file exists: a signal in between finds nothing to unlink, which is harmless.
  slot_ = remember_pending(temporary);
  fd_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const int error = errno;
  if (fd_ < 0) {
    forget_pending(slot_);
    fail("no file can be written in this directory", error);
  }
  temporary_ = temporary;
  copy_permissions(target_, fd_);
}

AtomicFile::~AtomicFile() {
  close_and_remove();
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(fd_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("writing failed", errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void AtomicFile::commit() {
  const int closed = ::close(fd_);
  fd_ = -1;
  if (closed != 0) fail("writing failed when the file was closed", errno);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail("the file cannot be renamed into place", errno);
  forget_pending(slot_);
  temporary_.clear();
}

void AtomicFile::close_and_remove() noexcept {
  if (fd_ >= 0) ::close(fd_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget_pending(slot_);
}

void AtomicFile::fail(const std::string& what, int error) const {
  fail_file(name_, what + ": " + std::strerror(error));
}

}  // namespace multimesh::io
