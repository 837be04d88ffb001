// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace multimesh::io {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// For ASCII letters; all other characters stay.
constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower_case(c);
  return result;
}

/// Without blanks at both ends.
constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// A trimmed name without the comment that follows it: from a `#` after a blank to the end. Names with such a
/// `#` of their own, as in `Material #25`, come from exporters that number them.
constexpr std::string_view without_comment(std::string_view name) {
  for (std::size_t i = name.find('#'); i != std::string_view::npos; i = name.find('#', i + 1)) {
    const char next = i + 1 < name.size() ? name[i + 1] : ' ';
    const bool is_number = next >= '0' && next <= '9';
    const bool is_comment = i == 0 ? is_blank(next) : is_blank(name[i - 1]) && !is_number;
    if (is_comment) return trimmed(name.substr(0, i));
  }
  return name;
}

/// Reads words and numbers from one line of text.
class TextCursor {
 public:
  explicit TextCursor(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }

  /// At the end of the line, or of its part before a comment.
  bool done() {
    skip_blanks();
    return at_ == end_ || *at_ == '#';
  }

  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// The characters up to the next blank.
  std::string_view word() {
    skip_blanks();
    const char* begin = at_;
    while (at_ != end_ && !is_blank(*at_)) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }

  /// The next word as a number, rounded to the nearest double; accepts nan and inf, and numbers too large
  /// (inf) or too small (0) for a double. False: not a number, nothing was read.
  bool number(double& value) {
    skip_blanks();
    const char* begin = at_;
    if (begin != end_ && *begin == '+' && end_ - begin > 1 && begin[1] != '-') ++begin;
    auto [stop, error] = std::from_chars(begin, end_, value);
    if (error == std::errc::invalid_argument) return false;
    if (stop != end_ && !is_blank(*stop)) [[unlikely]]
      return nonfinite(begin, stop, value);
    if (error == std::errc::result_out_of_range) value = beyond_double(begin, stop);
    at_ = stop;
    return true;
  }

  /// An integer of at most 18 digits, followed by anything. False: none here, nothing was read.
  bool integer(std::int64_t& value) {
    const char* digit = at_;
    const bool negative = digit != end_ && *digit == '-';
    if (digit != end_ && (*digit == '-' || *digit == '+')) ++digit;
    const char* const begin = digit;
    std::int64_t sum = 0;
    for (; digit != end_ && *digit >= '0' && *digit <= '9'; ++digit) {
      if (digit - begin == 18) return false;
      sum = 10 * sum + (*digit - '0');
    }
    if (digit == begin) return false;
    value = negative ? -sum : sum;
    at_ = digit;
    return true;
  }

  bool at_end() {
    skip_blanks();
    return at_ == end_;
  }
  bool at_word_end() const { return at_ == end_ || is_blank(*at_); }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

 private:
  /// What some runtime libraries print: 1.#INF, -1.#IND00, 1.#QNAN.
  bool nonfinite(const char* begin, const char* stop, double& value) {
    if (*stop != '#') return false;
    while (stop != end_ && !is_blank(*stop)) ++stop;
    const std::string_view word(begin, static_cast<std::size_t>(stop - begin));
    const double inf = std::numeric_limits<double>::infinity();
    if (word.find("#INF") != std::string_view::npos)
      value = *begin == '-' ? -inf : inf;
    else if (word.find("#IND") != std::string_view::npos || word.find("NAN") != std::string_view::npos)
      value = std::numeric_limits<double>::quiet_NaN();
    else
      return false;
    at_ = stop;
    return true;
  }

  static double beyond_double(const char* begin, const char* end) {
    long double value = std::numeric_limits<long double>::infinity();
    std::from_chars(begin, end, value);
    return static_cast<double>(value);
  }

  const char* at_;
  const char* end_;
};

/// The next word for a message: at most 30 characters, in quotes, without control characters.
inline std::string quoted_word(std::string_view text) {
  text = TextCursor(text).word().substr(0, 30);
  std::string quoted = "'";
  for (const char c : text) quoted += (c >= 0 && c < ' ') || c == 127 ? '?' : c;
  return quoted + "'";
}

}  // namespace multimesh::io
