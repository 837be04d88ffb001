// SPDX-License-Identifier: BSD-3-Clause
// Scripts of operations that the fuzzer found (corpus/: together they reach everything that it could reach;
// crashes/: each once failed), and random ones.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "test/fuzz/read_bytes.hpp"
#include "test/fuzz/script.hpp"

namespace multimesh::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::filesystem::path> files_in(const char* folder) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path all = std::filesystem::path(MULTIMESH_FUZZ_DIR) / folder;
  if (std::filesystem::exists(all))
    for (const auto& entry : std::filesystem::directory_iterator(all)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Bytes bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

void replay(const char* folder, ScriptResult& sum) {
  for (const auto& file : files_in(folder)) {
    const ScriptResult r = run_script(bytes_of(file));
    EXPECT_EQ(r.fault, "") << file;
    sum.steps += r.steps, sum.done += r.done, sum.refused += r.refused;
  }
}

TEST(Scripts, OfTheCorpusLeaveEveryTreeValid) {
  ScriptResult sum;
  replay("corpus", sum);
  EXPECT_GT(sum.done, sum.steps / 10);
  EXPECT_GT(sum.refused, sum.steps / 10);
}

TEST(Scripts, ThatOnceFailedDoNot) {
  ScriptResult sum;
  replay("crashes", sum);
}

TEST(Scripts, AtRandomLeaveEveryTreeValid) {
  ScriptResult sum;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    Bytes bytes(200);
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    const ScriptResult r = run_script(bytes);
    ASSERT_EQ(r.fault, "") << "seed " << seed;
    sum.steps += r.steps, sum.done += r.done, sum.refused += r.refused;
  }
  EXPECT_GT(sum.done, sum.steps / 10);
  EXPECT_GT(sum.refused, sum.steps / 10);
}

TEST(FilesAtRandom, AreReadOrRefused) {
  std::size_t read = 0;
  for (const auto& file : files_in("files")) read += read_bytes(bytes_of(file));
  EXPECT_GT(read, 0U);
}

}  // namespace
}  // namespace multimesh::test
