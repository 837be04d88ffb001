// SPDX-License-Identifier: BSD-3-Clause
// The documents: links lead to existing files, and code that is shown is compiled and run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path root = MULTIMESH_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> documents() {
  std::vector<fs::path> all{root / "README.md", root / "CHANGELOG.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") all.push_back(entry.path());
  return all;
}

TEST(Documents, LinkToFilesThatExist) {
  const std::regex link(R"(\]\(([^)\s]+)\))");
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (std::sregex_iterator m(text.begin(), text.end(), link), end; m != end; ++m) {
      std::string target = (*m)[1];
      if (target.starts_with("http")) continue;
      target = target.substr(0, target.find('#'));
      if (target.empty()) continue;
      ++links;
      EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document << " links to " << target;
    }
  }
  EXPECT_GT(links, 50U);
}

// A path that exists only on its writer's machine helps nobody else.
TEST(Documents, NameNoPathOfOneMachine) {
  const std::regex path(R"((^|[\s`"'(])/(work|home|root|Users|mnt)/)");
  for (const fs::path& document : documents())
    EXPECT_FALSE(std::regex_search(text_of(document), path)) << document;
}

std::string without_space(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
  return text;
}

/// Sources that are compiled, without white space.
const std::string& sources() {
  static const std::string all = [] {
    std::string text;
    for (const char* folder : {"examples", "test"})
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const auto extension = entry.path().extension();
        if (extension == ".cpp" || extension == ".hpp") text += without_space(text_of(entry.path()));
      }
    return text;
  }();
  return all;
}

// A line of three dots stands for what was left out.
TEST(Documents, ShowCodeThatIsRun) {
  std::size_t parts = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (std::size_t begin = text.find("```cpp\n"); begin != std::string::npos;
         begin = text.find("```cpp\n", begin + 1)) {
      std::string block = text.substr(begin + 7, text.find("```", begin + 7) - begin - 7);
      while (!block.empty()) {
        const std::size_t dots = block.find("...\n");
        const std::string part = block.substr(0, dots);
        block = dots == std::string::npos ? "" : block.substr(dots + 4);
        ++parts;
        EXPECT_NE(sources().find(without_space(part)), std::string::npos) << document << " shows\n" << part;
      }
    }
  }
  EXPECT_GT(parts, 4U);
}

}  // namespace
