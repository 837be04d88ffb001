// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/word_source.hpp"

#include <algorithm>
#include <limits>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {
namespace {

bool is_end_of_line(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

bool WordSource::next(std::string_view& word) {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && bytes_[at_] != '\n') ++at_;
  word = bytes_.substr(begin, at_ - begin);
  return !word.empty();
}

std::string_view WordSource::peek() {
  // The blanks before it are not consumed either: binary data may begin with bytes that look like blanks.
  const std::size_t at = at_, line = line_;
  std::string_view word;
  next(word);
  at_ = at;
  line_ = line;
  return word;
}

std::string_view WordSource::word(std::string_view what) {
  std::string_view word;
  if (!next(word)) fail_truncated(what);
  return word;
}

double WordSource::number(std::string_view what) {
  const std::string_view text = word(what);
  TextCursor cursor(text);
  double value = 0;
  if (!cursor.number(value))
    fail(quoted_word(text) + " is not a number, for " + std::string(what) + "; correct it");
  return value;
}

std::int64_t WordSource::integer(std::string_view what) {
  const std::string_view text = word(what);
  TextCursor cursor(text);
  std::int64_t value = 0;
  if (!cursor.integer(value) || !cursor.at_word_end())
    fail(quoted_word(text) + " is not a whole number, for " + std::string(what) + "; correct it");
  return value;
}

std::int32_t WordSource::integer32(std::string_view what) {
  const std::int64_t value = integer(what);
  if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
    fail(std::to_string(value) + " is too large, for " + std::string(what) + "; use 32 bits");
  return static_cast<std::int32_t>(value);
}

std::size_t WordSource::count(std::string_view what, std::size_t least_bytes) {
  const std::int64_t value = integer("the number of " + std::string(what));
  if (value < 0) fail("the number of " + std::string(what) + " is negative; correct it");
  check_count(static_cast<std::uint64_t>(value), what, least_bytes);
  return static_cast<std::size_t>(value);
}

void WordSource::check_count(std::uint64_t count, std::string_view what, std::size_t least_bytes) const {
  // One more: the last one needs no separator after it.
  if (count == 0 || count - 1 <= left() / std::max<std::size_t>(least_bytes, 1)) return;
  fail("the file is too short for " + std::to_string(count) + " " + std::string(what) +
       "; it is truncated or the number is wrong, get it whole");
}

std::string_view WordSource::rest_of_line() {
  const std::string_view line = line_ahead();
  at_ += line.size();
  return line;
}

std::string_view WordSource::line_ahead() const {
  std::size_t end = at_;
  while (end < bytes_.size() && !is_end_of_line(bytes_[end])) ++end;
  return bytes_.substr(at_, end - at_);
}

void WordSource::end_of_line() {
  const std::string_view rest = bytes_.substr(at_);
  const std::size_t size = rest.starts_with("\r\n") ? 2 : rest.starts_with('\n') || rest.starts_with('\r');
  at_ += size;
  if (size != 0) ++line_;
}

std::string_view WordSource::raw(std::size_t size, std::string_view what) {
  raw_ = true;
  if (size > left()) fail_truncated(what);
  at_ += size;
  return bytes_.substr(at_ - size, size);
}

bool WordSource::skip_past(std::string_view text) {
  const std::size_t found = bytes_.find(text, at_);
  if (found == std::string_view::npos) return false;
  const std::string_view skipped = bytes_.substr(at_, found - at_);
  line_ += static_cast<std::size_t>(std::ranges::count(skipped, '\n'));
  at_ = found + text.size();
  return true;
}

void WordSource::fail(const std::string& message) const {
  if (!raw_) fail_at(file_, line_, message);
  fail_file(file_, "byte " + std::to_string(at_) + ": " + message);
}

void WordSource::fail_truncated(std::string_view what) const {
  fail("the file ends before " + std::string(what) + "; it is truncated, get it whole");
}

void WordSource::skip_blanks() {
  while (at_ < bytes_.size()) {
    const char c = bytes_[at_];
    const bool ends_line = c == '\n' || (c == '\r' && !bytes_.substr(at_ + 1).starts_with('\n'));
    if (ends_line) ++line_;
    if (c == comment_ && comment_ != 0)
      rest_of_line();
    else if (is_blank(c) || c == '\n')
      ++at_;
    else
      return;
  }
}

}  // namespace multimesh::io
