// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace multimesh::test {

/// Bytes as a file of a mesh: the first one chooses the extension. \return whether it was read; else it was
/// an InputError. Anything else that a reader does is a fault, and goes out.
bool read_bytes(std::span<const std::uint8_t> bytes);

}  // namespace multimesh::test
