// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "multimesh/error.hpp"

namespace multimesh::io::test {

namespace fs = std::filesystem;

/// A fresh directory per test, removed at its end.
class IoTest : public ::testing::Test {
 protected:
  void SetUp() override {
    static std::atomic<int> counter = 0;
    directory = fs::temp_directory_path() /
                ("multimesh-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    fs::create_directories(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  fs::path file(const std::string& name, const std::string& content) const {
    fs::create_directories((directory / name).parent_path());
    std::ofstream(directory / name, std::ios::binary) << content;
    return directory / name;
  }

  fs::path directory;
};

inline std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The message of the InputError that f throws; empty if it throws none.
template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A directory of the shared data, or an empty path when it is not there.
inline fs::path shared(const std::string& name) {
  const fs::path root = MULTIMESH_SHARED_DATA;
  return !root.empty() && fs::is_directory(root / name) ? root / name : fs::path();
}

inline std::vector<fs::path> files_under(const fs::path& root, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace multimesh::io::test
