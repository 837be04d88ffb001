// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {

/// A text as words separated by blanks and line ends (LF, CRLF, CR), for formats in which lines have no
/// meaning; with stretches of raw bytes in between. Every error is an InputError naming the line, or after
/// raw bytes, where lines can no longer be counted, the byte.
class WordSource {
 public:
  /// What follows `comment` on a line is skipped; 0 = there are no comments. A text that is part of a file
  /// begins on `first_line` of it.
  WordSource(std::string_view bytes, std::string file, char comment = 0, std::size_t first_line = 1)
      : bytes_(bytes), file_(std::move(file)), comment_(comment), line_(first_line) {}

  /// The next word. False at the end.
  bool next(std::string_view& word);
  /// The same without consuming it; empty at the end.
  std::string_view peek();

  /// The next word, which must exist. `what` names it in messages.
  std::string_view word(std::string_view what);
  /// The next word as a number; nan and inf are numbers.
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// \throw InputError also where it does not fit into 32 bits.
  std::int32_t integer32(std::string_view what);
  /// A number of things that follow, each of `least_bytes` or more. A number that the rest cannot hold is
  /// refused, so that nothing is allocated for a false claim.
  std::size_t count(std::string_view what, std::size_t least_bytes);
  /// \throw InputError when `count` things of `least_bytes` each are more than the rest can hold.
  void check_count(std::uint64_t count, std::string_view what, std::size_t least_bytes) const;

  /// The rest of the line of the last word, without its end. Includes comments.
  std::string_view rest_of_line();
  /// The same without consuming it.
  std::string_view line_ahead() const;
  /// Consumes one line end, if one comes next.
  void end_of_line();
  /// The next `size` bytes as they are. \throw InputError when there are fewer.
  std::string_view raw(std::size_t size, std::string_view what);
  /// Continues after the next `text`. False, and nothing is consumed, if it does not occur.
  bool skip_past(std::string_view text);

  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t offset() const { return at_; }
  /// Line of the last word, from 1; 0 once raw bytes were read.
  std::size_t line() const { return raw_ ? 0 : line_; }
  const std::string& file() const { return file_; }

  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_truncated(std::string_view what) const;

 private:
  void skip_blanks();

  std::string_view bytes_;
  std::string file_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t line_;
  bool raw_ = false;
};

}  // namespace multimesh::io
