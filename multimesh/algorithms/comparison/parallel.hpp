// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace multimesh::comparison {

/// Calls work(begin, end) for blocks that together are [0, n), on `threads` threads; 0: one per core. The
/// blocks are the same for any number of threads, but their order is not: let every i write its own result,
/// and add them up afterwards. An exception of one of the calls is rethrown at the end.
void for_each_block(std::size_t n, unsigned threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace multimesh::comparison
