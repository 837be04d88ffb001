// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace multimesh::test {

/// A shell script in place of the worker, for behaviour that the real one does not show on demand.
class WorkerScript {
 public:
  explicit WorkerScript(const std::string& lines) {
    std::string name = (std::filesystem::temp_directory_path() / "fake-worker-XXXXXX").string();
    const int fd = ::mkstemp(name.data());
    path_ = name;
    const std::string text = "#!/bin/sh\n" + lines + "\n";
    written_ = ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::close(fd);
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
  }
  ~WorkerScript() { std::filesystem::remove(path_); }
  WorkerScript(const WorkerScript&) = delete;
  WorkerScript& operator=(const WorkerScript&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool written_ = false;
};

}  // namespace multimesh::test
