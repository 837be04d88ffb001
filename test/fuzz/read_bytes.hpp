// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace multimesh::test {

/// Reads bytes as a file of a mesh: the first one chooses the extension. \return whether it was read;
/// otherwise there was an InputError. Any other exception of a reader is a bug, and propagates.
bool read_bytes(std::span<const std::uint8_t> bytes);

}  // namespace multimesh::test
