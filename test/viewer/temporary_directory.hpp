// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace multimesh::tools::test {

/// A test with a fresh directory, removed at its end.
class InDirectory : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory = std::filesystem::temp_directory_path() /
                ("multimesh-report-" + std::to_string(::getpid()) + "-" + info->name());
    std::filesystem::create_directories(directory / "sub");
  }
  void TearDown() override { std::filesystem::remove_all(directory); }

  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(directory / name, std::ios::binary) << content;
    return directory / name;
  }
  std::string content(const std::string& name) const {
    std::ifstream in(directory / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path directory;
};

}  // namespace multimesh::tools::test
