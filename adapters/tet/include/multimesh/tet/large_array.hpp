// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace multimesh::tet {

/// Requests large pages for a large array: in a mesh of a million tetrahedra, visited in random order, every
/// access would miss the small pages' table (splits take 0.7 of the time).
template <class T>
class LargePageAllocator {
 public:
  using value_type = T;
  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&) noexcept {}  // NOLINT: the standard's conversion

  T* allocate(std::size_t n) {
    if (n > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    const std::size_t alignment = bytes < least_bytes ? 64 : page;
    void* p = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!p) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (alignment == page) (void)madvise(p, bytes, MADV_HUGEPAGE);  // only a request; small pages also work
#endif
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t) noexcept {
    std::free(p);
  }

  template <class U>
  friend bool operator==(const LargePageAllocator&, const LargePageAllocator<U>&) {
    return true;
  }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21, least_bytes = 2 * page;
};

template <class T>
using LargeArray = std::vector<T, LargePageAllocator<T>>;

}  // namespace multimesh::tet
