// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "multimesh/error.hpp"

namespace multimesh::files::test {

/// A fresh directory, removed at the end of the test.
class InFolder : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("multimesh_files_" + std::to_string(std::random_device()()));
};

inline bool any_has(const std::vector<std::string>& sentences, const std::string& part) {
  return std::ranges::any_of(sentences, [&](const auto& s) { return s.find(part) != std::string::npos; });
}

/// What the InputError says; empty if there is none.
template <class Work>
std::string refusal(Work&& work) {
  try {
    work();
    return {};
  } catch (const InputError& e) {
    return e.what();
  }
}

}  // namespace multimesh::files::test
