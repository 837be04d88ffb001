// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl_rewrite.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

/// Options with their largest number of arguments. Those of more than one may have fewer: only numbers count.
constexpr std::array<std::pair<std::string_view, int>, 14> options = {{{"-blendu", 1},
                                                                       {"-blendv", 1},
                                                                       {"-bm", 1},
                                                                       {"-boost", 1},
                                                                       {"-cc", 1},
                                                                       {"-clamp", 1},
                                                                       {"-imfchan", 1},
                                                                       {"-mm", 2},
                                                                       {"-o", 3},
                                                                       {"-s", 3},
                                                                       {"-t", 3},
                                                                       {"-texres", 1},
                                                                       {"-type", 1},
                                                                       {"-colorspace", 1}}};

bool is_texture_statement(std::string_view word) {
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (lower == "map_aat") return false;  // on or off
  constexpr std::array<std::string_view, 5> words = {"bump", "disp", "decal", "refl", "norm"};
  return lower.starts_with("map_") || std::ranges::find(words, lower) != words.end();
}

bool is_number(std::string_view word) {
  double value = 0;
  return TextCursor(word).number(value);
}

/// Takes the arguments of an option. The last word of the line is never one: it belongs to the path.
void skip_arguments(TextCursor& cursor, int most) {
  for (int n = 0; n < most; ++n) {
    TextCursor ahead = cursor;
    const std::string_view word = ahead.word();
    if (trimmed(ahead.rest()).empty() || (most > 1 && !is_number(word))) return;
    cursor = ahead;
  }
}

/// What is left of the line after the statement and its options.
std::string_view texture_path(std::string_view line) {
  TextCursor cursor(line);
  if (!is_texture_statement(cursor.word())) return {};
  while (true) {
    TextCursor ahead = cursor;
    const std::string_view word = ahead.word();
    const auto option = std::ranges::find(options, word, &std::pair<std::string_view, int>::first);
    if (option == options.end()) return trimmed(cursor.rest());
    skip_arguments(ahead, option->second);
    cursor = ahead;
  }
}

}  // namespace

std::string rewrite_textures(std::string_view mtl,
                             const std::function<std::string(std::string_view)>& relocate) {
  std::string result;
  result.reserve(mtl.size() + mtl.size() / 8);
  while (!mtl.empty()) {
    const std::size_t end = std::min(mtl.find('\n'), mtl.size() - 1) + 1;
    const std::string_view line = mtl.substr(0, end);
    const std::string_view path = texture_path(line.substr(0, line.find('\n')));
    if (path.empty()) {
      result += line;
    } else {
      const auto begin = static_cast<std::size_t>(path.data() - line.data());
      result += line.substr(0, begin);
      result += relocate(path);
      result += line.substr(begin + path.size());
    }
    mtl.remove_prefix(end);
  }
  return result;
}

}  // namespace multimesh::io
