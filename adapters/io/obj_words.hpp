// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace multimesh::io {

/// OBJ statements for free-form curves and surfaces, display attributes and superseded things: known, and
/// left out.
constexpr bool is_free_form(std::string_view word) {
  constexpr std::array<std::string_view, 27> words = {
      "vp",    "cstype", "deg",    "bmat",     "step",     "curv",   "curv2",      "surf",      "parm",
      "trim",  "hole",   "scrv",   "sp",       "end",      "con",    "mg",         "bevel",     "lod",
      "ctech", "stech",  "usemap", "c_interp", "d_interp", "maplib", "shadow_obj", "trace_obj", "call"};
  return std::ranges::find(words, word) != words.end();
}

}  // namespace multimesh::io
