// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "adapters/io/input_location.hpp"
#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// How often something was found in the faces of a file, and the first face where it was.
struct FirstFace {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t face) {
    if (count++ == 0) first = face;
  }
};

/// \throw InputError naming the line of face f, or its number if there is no line
[[noreturn, gnu::noinline, gnu::cold]] inline void fail_at_face(const PolygonSoup& soup,
                                                                const std::string& file, std::size_t f,
                                                                const std::string& message) {
  if (soup.face_line[f] != 0) fail_at(file, soup.face_line[f], message);
  fail_file(file, "face " + std::to_string(f) + " (from 0): " + message);
}

/// A warning that names the line of face f, or its number if there is no line.
inline void warn_at_face(PolygonSoup& soup, const std::string& file, std::size_t f,
                         const std::string& message) {
  const std::size_t line = soup.face_line[f];
  const std::string place =
      line != 0 ? ":" + std::to_string(line) : ": face " + std::to_string(f) + " (from 0)";
  soup.warnings.push_back(file + place + ": " + message);
}

}  // namespace multimesh::io
