// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace multimesh::io {

/// A file that appears under its name complete or not at all: it is written to a temporary file in the same
/// directory, which commit() renames. Without a commit the temporary file is removed, and an older file of
/// that name is unchanged. Permissions of an older file are kept. Not copyable; one thread at a time.
class AtomicFile {
 public:
  /// \throw InputError when the target is a directory or a device, or its directory does not exist or cannot
  ///   be written to.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// \throw InputError when the disk is full or the write fails otherwise.
  void write(std::string_view bytes);

  /// \pre called once, and nothing is written after it. \throw InputError; the target is then unchanged.
  void commit();

 private:
  void close_and_remove() noexcept;
  [[noreturn]] void fail(const std::string& what, int error) const;

  std::string name_;       ///< as given by the caller
  std::string target_;     ///< with links followed
  std::string temporary_;  ///< empty once renamed or removed
  int fd_ = -1;
  int slot_ = -1;
};

/// Makes SIGINT, SIGTERM and SIGHUP remove the temporary files of all pending AtomicFiles, and then end the
/// process as they otherwise would. For programs, once at the start of main; the library never calls it.
/// Signals that are ignored stay ignored. SIGXFSZ is ignored, so that a write beyond a limit is an error.
void install_signal_cleanup();

}  // namespace multimesh::io
