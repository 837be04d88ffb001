// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "adapters/tetgen/worker_protocol.hpp"

namespace multimesh::tetgen::worker {

/// Writes a reply that says what went wrong, and ends the process.
[[noreturn]] void fail(Outcome outcome, std::int64_t detail = 0) noexcept;

/// Also reports crashes and uncaught exceptions in the reply from now on. The exit status does not reach
/// a library whose program ignores SIGCHLD, and TetGen's exceptions must not be caught: TetGen frees its
/// memory before it throws, and once more when the stack is unwound; without a handler it is not
/// unwound.
void report_failures();

}  // namespace multimesh::tetgen::worker
