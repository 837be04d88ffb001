// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace multimesh::comparison {

/// Calls work(begin, end) for blocks that together are [0, n), from `threads` threads; 0: as many as there
/// are cores. The blocks are the same for any number of threads, their order is not: let every i write its
/// own result, and add up afterwards. An exception of one of the calls is thrown again at the end.
void for_each_block(std::size_t n, unsigned threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace multimesh::comparison
