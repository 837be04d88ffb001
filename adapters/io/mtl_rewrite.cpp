// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl_rewrite.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "adapters/io/mtl_statements.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

/// Options with their largest number of arguments. Those with more than one may have fewer: only numbers
/// count.
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

bool is_number(std::string_view word) {
  double value = 0;
  return TextCursor(word).number(value);
}

const auto* option_of(std::string_view word) {
  return std::ranges::find(options, word, &std::pair<std::string_view, int>::first);
}

/// Skips the arguments of an option before a path. The last word of the line is never one, because it belongs
/// to the path.
void skip_arguments(TextCursor& cursor, int most) {
  for (int n = 0; n < most; ++n) {
    TextCursor ahead = cursor;
    const std::string_view word = ahead.word();
    if (trimmed(ahead.rest()).empty() || (most > 1 && !is_number(word))) return;
    cursor = ahead;
  }
}

/// Whether a text consists only of options with their arguments.
bool is_options(TextCursor cursor) {
  while (!cursor.at_end()) {
    const auto* option = option_of(cursor.word());
    if (option == options.end() || cursor.at_end()) return false;
    int n = 0;
    for (TextCursor ahead = cursor; n < option->second && !ahead.at_end(); ++n, cursor = ahead)
      if (!is_number(ahead.word()) && option->second > 1) break;
    if (n == 0) return false;
  }
  return true;
}

/// Removes the options that some programs write after a path.
std::string_view without_options_behind(std::string_view path) {
  for (std::size_t at = path.find(" -"); at != std::string_view::npos; at = path.find(" -", at + 1))
    if (is_options(TextCursor(path.substr(at)))) return trimmed(path.substr(0, at));
  return path;
}

std::string_view without_quotes(std::string_view path) {
  const bool quoted = path.size() > 2 && path.front() == '"' && path.back() == '"';
  return quoted ? path.substr(1, path.size() - 2) : path;
}

/// The rest of the line after the statement and its options.
std::string_view texture_path(std::string_view line) {
  TextCursor cursor(line);
  if (!is_texture_statement(cursor.word())) return {};
  while (true) {
    TextCursor ahead = cursor;
    const auto* option = option_of(ahead.word());
    if (option == options.end()) return without_quotes(without_options_behind(trimmed(cursor.rest())));
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
