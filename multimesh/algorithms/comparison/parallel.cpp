// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace multimesh::comparison {

namespace {
constexpr std::size_t block_size = 1024;
}

void for_each_block(std::size_t n, unsigned threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& work) {
  const std::size_t blocks = (n + block_size - 1) / block_size;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, blocks));
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto run = [&] {
    try {
      for (std::size_t b = next++; b < blocks; b = next++)
        work(b * block_size, std::min(n, (b + 1) * block_size));
    } catch (...) {
      next = blocks;
      const std::scoped_lock lock(failing);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace multimesh::comparison
