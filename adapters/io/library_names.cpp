// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/library_names.hpp"

#include <algorithm>
#include <system_error>

#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

bool is_mtl(std::string_view name) {
  if (name.size() < 4) return false;
  const std::string_view end = name.substr(name.size() - 4);
  return std::equal(end.begin(), end.end(), ".mtl",
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + ('a' - 'A') == b); });
}

bool exists(const std::filesystem::path& directory, std::string_view name) {
  std::error_code error;
  return std::filesystem::is_regular_file(directory / name, error);
}

/// Offsets of the word ends of a trimmed text.
std::vector<std::size_t> word_ends(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i <= text.size(); ++i)
    if ((i == text.size() || is_blank(text[i])) && !is_blank(text[i - 1])) ends.push_back(i);
  return ends;
}

std::size_t first_name_size(std::string_view text, const std::filesystem::path& directory) {
  const std::vector<std::size_t> ends = word_ends(text);
  for (auto end = ends.rbegin(); end != ends.rend(); ++end)
    if (exists(directory, text.substr(0, *end))) return *end;
  for (const std::size_t end : ends)
    if (is_mtl(text.substr(0, end))) return end;
  return ends.front();
}

}  // namespace

std::vector<std::string> split_library_names(std::string_view text, const std::filesystem::path& directory) {
  std::vector<std::string> names;
  text = trimmed(text);
  while (!text.empty()) {
    const std::size_t size = first_name_size(text, directory);
    names.emplace_back(text.substr(0, size));
    text = trimmed(text.substr(size));
  }
  return names;
}

}  // namespace multimesh::io
