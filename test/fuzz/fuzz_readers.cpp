// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry: see read_bytes.hpp.
#include "test/fuzz/read_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  multimesh::test::read_bytes({data, size});
  return 0;
}
