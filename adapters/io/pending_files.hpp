// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace multimesh::io {

/// Temporary files that a signal handler must remove. A fixed table, because a handler
/// may not allocate or lock. \return the slot, or -1 when the table (64 files) is full
/// or the path too long: the file is then not removed on a signal, but everything else
/// works.
int remember_pending(const std::string& path) noexcept;

/// \pre slot from remember_pending; -1 does nothing.
void forget_pending(int slot) noexcept;

/// Unlinks all files of the table. Async-signal-safe.
void remove_pending() noexcept;

}  // namespace multimesh::io
