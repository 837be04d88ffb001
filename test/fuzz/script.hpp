// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace multimesh::test {

struct ScriptResult {
  std::string fault;  ///< what went wrong, at which step; empty if nothing did
  std::size_t steps = 0, done = 0, refused = 0;
};

/// Bytes as a script of operations on a small tree: any bytes are one. The first three choose the kind of
/// tree, its seed and options; then step by step: splits, collapses, swaps, relocations on any mesh of the
/// tree, transactions opened, committed and rolled back, nested, refusals by an invariant before or after,
/// exceptions thrown at any stage, compactions. After each step the tree must be valid, of the same topology,
/// and children must lie where their images are; after a refusal, an exception or a rollback it must be what
/// it was, word by word. Never throws.
ScriptResult run_script(std::span<const std::uint8_t> bytes);

}  // namespace multimesh::test
