// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace multimesh::tools::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// How a run of the program ended.
struct Ended {
  int status = -1;  ///< of exit; -1 if a signal ended it
  int signal = 0;   ///< that ended it
  std::string out, err;
};

/// Runs the program in a process of its own, in a fresh directory that is removed at the end of the test.
class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Runs it with `directory` as the working directory. `prepare` is called in the child before.
  Ended run(const Arguments& arguments, const std::function<void()>& prepare = {}) const;
  /// decimate IN -o OUT, and more.
  Ended decimate(const std::string& in, const std::string& out, const Arguments& more) const;
  /// info FILE --json; the test fails if that fails.
  Json info(const std::string& file) const;

  pid_t start(const Arguments& arguments, const std::function<void()>& prepare = {}) const;
  Ended wait(pid_t process) const;

  fs::path file(const std::string& name, const std::string& content) const;
  std::string content(const std::string& name) const;
  bool exists(const std::string& name) const { return fs::exists(directory / name); }
  Json json(const std::string& name) const { return Json::parse(content(name)); }
  /// Names in the directory, sorted, without what run() put there.
  std::vector<std::string> names(const std::string& below = ".") const;

  fs::path directory;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A planar n x n grid of 2 n^2 triangles over [0, n]^2 as OBJ text, texture coordinates = position / n, with
/// a material and a group for each half in x: `left` and `right`. With a seam, `right` is moved by 2 in u.
std::string grid_obj(int n, bool seam = true, const std::string& head = {});

inline std::string spot() {
  return MULTIMESH_EXAMPLE_DATA "/spot/spot.obj";
}

/// A directory of the shared data, or an empty path when it is not there.
fs::path shared(const std::string& name);

}  // namespace multimesh::tools::test
