// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace multimesh::io {

/// OBJ statements for free-form curves and surfaces, display attributes and superseded things: known, but
/// left out.
constexpr bool is_free_form(std::string_view word) {
  constexpr std::array<std::string_view, 27> words = {
      "vp",    "cstype", "deg",    "bmat",     "step",     "curv",   "curv2",      "surf",      "parm",
      "trim",  "hole",   "scrv",   "sp",       "end",      "con",    "mg",         "bevel",     "lod",
      "ctech", "stech",  "usemap", "c_interp", "d_interp", "maplib", "shadow_obj", "trace_obj", "call"};
  return std::ranges::find(words, word) != words.end();
}

/// The first word of a trimmed line.
constexpr std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find_first_of(" \t"));
}

/// Whether a trimmed line of an OBJ file is a statement, a comment or empty, so that it does not continue the
/// line before.
constexpr bool is_obj_statement(std::string_view line) {
  constexpr std::array<std::string_view, 13> words = {"v", "vt", "vn", "f",      "fo",     "l",     "p",
                                                      "o", "g",  "s",  "usemtl", "mtllib", "newmtl"};
  if (line.empty() || line.starts_with('#')) return true;
  // A name may equal a keyword, but is not followed by its arguments.
  const std::string_view word = first_word(line);
  return word.size() < line.size() && (std::ranges::find(words, word) != words.end() || is_free_form(word));
}

/// Whether a trimmed line of an OBJ file is a statement that ends in a name.
constexpr bool ends_in_name(std::string_view line) {
  constexpr std::array<std::string_view, 4> words = {"usemtl", "mtllib", "o", "g"};
  return std::ranges::find(words, first_word(line)) != words.end();
}

}  // namespace multimesh::io
