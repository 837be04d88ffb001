// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry: see script.hpp.
#include <cstdio>
#include <cstdlib>

#include "test/fuzz/script.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto result = multimesh::test::run_script({data, size});
  if (result.fault.empty()) return 0;
  std::fprintf(stderr, "fault: %s\n", result.fault.c_str());
  std::abort();
}
