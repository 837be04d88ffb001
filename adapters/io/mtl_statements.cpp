// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl_statements.hpp"

#include <algorithm>
#include <array>

#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {
namespace {

/// Statements whose arguments are numbers, or a colour in another form.
constexpr std::array<std::string_view, 19> numeric = {"ka", "kd", "ks",    "ke",    "tf",        "ni", "ns",
                                                      "d",  "tr", "illum", "pr",    "sharpness", "pm", "ps",
                                                      "pc", "km", "pcr",   "aniso", "anisor"};
constexpr std::array<std::string_view, 3> before_numbers = {"spectral", "xyz", "-halo"};

bool contains(const auto& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool has_numbers(TextCursor cursor) {
  double value = 0;
  if (cursor.number(value)) {
    while (cursor.number(value)) continue;
    return cursor.done();
  }
  // "spectral FILE FACTOR", "xyz X Y Z", "-halo FACTOR"
  return contains(before_numbers, lower_case(cursor.word())) && !cursor.done();
}

bool is_text(std::string_view line) {
  return std::ranges::none_of(line, [](char c) { return (c >= 0 && c < ' ' && !is_blank(c)) || c == 127; });
}

bool is_statement(std::string_view line) {
  TextCursor cursor(line);
  const std::string word = lower_case(cursor.word());
  if (word == "newmtl" || is_texture_statement(word)) return true;
  if (word == "map_aat") return !cursor.done();
  return contains(numeric, word) && has_numbers(cursor);
}

/// The next line with what follows it after a `\` at its end.
std::string_view next_line(std::string_view text) {
  std::size_t end = 0;
  do {
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  } while (end < text.size() && trimmed(text.substr(0, end - 1)).ends_with('\\'));
  return text.substr(0, end);
}

}  // namespace

bool is_texture_statement(std::string_view word) {
  constexpr std::array<std::string_view, 5> words = {"bump", "disp", "decal", "refl", "norm"};
  const std::string lower = lower_case(word);
  if (lower == "map_aat") return false;  // on or off
  return lower.starts_with("map_") || contains(words, lower);
}

MtlText read_mtl(std::string_view bytes) {
  MtlText mtl;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  mtl.text.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::string_view line = next_line(bytes);
    bytes.remove_prefix(line.size());
    std::string joined(line);
    std::ranges::replace(joined, '\n', ' ');
    const std::string_view content = trimmed(joined);
    const bool statement = is_text(content) && is_statement(content);
    const bool kept = statement || content.empty() || (content.front() == '#' && is_text(content));
    mtl.statements += statement;
    mtl.left_out += !kept;
    if (kept) mtl.text += line;
  }
  return mtl;
}

}  // namespace multimesh::io
