// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "adapters/io/obj_words.hpp"
#include "adapters/io/text_cursor.hpp"

namespace multimesh::io {

/// The lines of a text, with LF, CRLF or (when there is no LF at all) CR ends. On request, a `\` at the end
/// of a line of an OBJ file joins the next line to it, except for comments and where the next line does not
/// exist or is a statement itself: there the `\` is the end of a name, or a mistake and left out.
class LineSource {
 public:
  enum class Continuation { joined, ignored };

  LineSource(std::string_view text, Continuation continuation)
      : text_(text),
        end_of_line_(text.find('\n') == std::string_view::npos ? '\r' : '\n'),
        continuation_(continuation) {}

  /// Continues with a text that follows the previous one. \pre that one was read up to its end, a line end
  void go_on(std::string_view text) {
    text_ = text;
    at_ = 0;
  }

  /// False at the end. The line is valid until the next call.
  bool next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    line = physical();
    number_ = ++physical_lines_;
    if (continuation_ == Continuation::joined && continues(line)) [[unlikely]]
      line = join(line);
    return true;
  }

  /// Number of the line that next() returned, from 1; if lines were joined, that of the first part.
  std::size_t number() const { return number_; }

  /// Bytes read from the current text, line ends included.
  std::size_t offset() const { return at_; }

 private:
  std::string_view physical() {
    const char* begin = text_.data() + at_;
    const std::size_t left = text_.size() - at_;
    const void* found = std::memchr(begin, end_of_line_, left);
    const std::size_t size = found ? static_cast<std::size_t>(static_cast<const char*>(found) - begin) : left;
    at_ += size + (found ? 1 : 0);
    return {begin, size};
  }

  static bool continues(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line.ends_with('\\') && !trimmed(line).starts_with('#');
  }

  bool next_is_on_its_own() const {
    if (at_ >= text_.size()) return true;
    const std::string_view rest = text_.substr(at_);
    return is_obj_statement(trimmed(rest.substr(0, rest.find(end_of_line_))));
  }

  std::string_view join(std::string_view line) {
    joined_.clear();
    while (true) {
      const bool more = continues(line);
      const bool ends = more && next_is_on_its_own();
      if (ends && joined_.empty() && ends_in_name(trimmed(line))) return line;
      joined_ += more ? line.substr(0, line.rfind('\\')) : line;
      if (!more || ends) return joined_;
      joined_ += ' ';
      line = physical();
      ++physical_lines_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::size_t physical_lines_ = 0;
  std::string joined_;
  char end_of_line_;
  Continuation continuation_;
};

}  // namespace multimesh::io
