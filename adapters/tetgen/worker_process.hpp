// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "adapters/tetgen/file_descriptor.hpp"

namespace multimesh::tetgen {

/// How a worker ended.
struct WorkerEnd {
  enum class How : std::uint8_t {
    exited,     ///< number is its exit code
    signal,     ///< number is the signal
    timed_out,  ///< it was killed
    unknown     ///< the caller ignores SIGCHLD, or waits for all children: it got the status
  };
  How how = How::unknown;
  int number = 0;
  std::string log;  ///< the beginning of what it printed
};

/// Starts the program, waits for its end, at most until `deadline`, and leaves no process behind. In the
/// program, signals that the caller blocks or ignores are reset to their defaults. \throw WorkerError
/// (missing) if it cannot be started, std::system_error
WorkerEnd run_worker(const std::filesystem::path& program, const FileDescriptor& request,
                     const FileDescriptor& reply, std::chrono::steady_clock::time_point deadline);

}  // namespace multimesh::tetgen
