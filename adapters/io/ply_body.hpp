// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "adapters/io/line_source.hpp"
#include "adapters/io/ply_header.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {

/// The values of a PLY file one after the other, ASCII or binary, row by row: a row is one vertex, face, ….
/// Every error is an InputError naming the line (ASCII) or the row (binary).
class PlyBody {
 public:
  PlyBody(std::string_view bytes, const PlyHeader& header, std::string_view file);

  void begin_row(const PlyElement& element, std::size_t row);
  double value(PlyType type);
  /// The length of a list.
  std::size_t list_size(PlyType type);
  /// ASCII: requires that the whole line has been read.
  void end_row();

  /// Of the row, counted from 1; 0 in a binary file.
  std::size_t line() const { return ascii_ ? header_lines_ + lines_.number() : 0; }
  /// Non-blank bytes that belong to no row.
  std::size_t unread() const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  double text_value();
  double binary_value(PlyType type);
  [[noreturn]] void fail_truncated() const;

  std::string_view bytes_;
  std::string file_;
  bool ascii_;
  bool swap_;
  std::size_t header_lines_;
  LineSource lines_;
  TextCursor cursor_;
  std::size_t at_ = 0;
  const PlyElement* element_ = nullptr;
  std::size_t row_ = 0;
};

}  // namespace multimesh::io
