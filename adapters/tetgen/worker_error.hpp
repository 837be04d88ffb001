// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace multimesh::tetgen {

/// TetGen's process returned no result, or a wrong one. The message says in words how it ended.
class WorkerError : public std::runtime_error {
 public:
  enum class Reason : std::uint8_t {
    missing,    ///< there is no worker program, or it cannot be started
    time_out,   ///< it was killed when its time was over
    memory,     ///< it ran out of memory
    signal,     ///< it crashed
    stopped,    ///< TetGen gave up
    bad_reply,  ///< it ended without a reply, or with one that is not understood
    bad_result  ///< its tetrahedra do not fill the surface
  };
  WorkerError(Reason reason, const std::string& message) : std::runtime_error(message), reason_(reason) {}
  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace multimesh::tetgen
