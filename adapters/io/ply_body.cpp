// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/ply_body.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {
namespace {

template <class T>
double load(const std::array<char, 8>& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return static_cast<double>(value);
}

double load(const std::array<char, 8>& bytes, PlyType type) {
  switch (type) {
    case PlyType::int8:
      return load<std::int8_t>(bytes);
    case PlyType::uint8:
      return load<std::uint8_t>(bytes);
    case PlyType::int16:
      return load<std::int16_t>(bytes);
    case PlyType::uint16:
      return load<std::uint16_t>(bytes);
    case PlyType::int32:
      return load<std::int32_t>(bytes);
    case PlyType::uint32:
      return load<std::uint32_t>(bytes);
    case PlyType::float32:
      return load<float>(bytes);
    case PlyType::float64:
      return load<double>(bytes);
  }
  return 0;
}

}  // namespace

PlyBody::PlyBody(std::string_view bytes, const PlyHeader& header, std::string_view file)
    : bytes_(bytes.substr(header.size)),
      file_(file),
      ascii_(header.format == PlyFormat::ascii),
      swap_((header.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big)),
      header_lines_(header.lines),
      lines_(bytes_, LineSource::Continuation::ignored),
      cursor_(std::string_view{}) {}

void PlyBody::begin_row(const PlyElement& element, std::size_t row) {
  element_ = &element;
  row_ = row;
  if (!ascii_ || element.properties.empty()) return;
  std::string_view line;
  do {
    if (!lines_.next(line)) fail_truncated();
  } while (trimmed(line).empty());
  cursor_ = TextCursor(line);
}

double PlyBody::value(PlyType type) {
  return ascii_ ? text_value() : binary_value(type);
}

std::size_t PlyBody::list_size(PlyType type) {
  const double size = value(type);
  if (size >= 0 && size <= 2147483647.0 && size == std::floor(size)) return static_cast<std::size_t>(size);
  fail("the length of a list is not a whole number; correct the " + element_->name);
}

void PlyBody::end_row() {
  if (!ascii_ || element_->properties.empty() || trimmed(cursor_.rest()).empty()) return;
  fail("the line has more values than the header declares for a " + element_->name + ", beginning with " +
       quoted_word(cursor_.rest()) + "; header and data do not fit, export the mesh again");
}

std::size_t PlyBody::unread() const {
  const std::string_view rest = bytes_.substr(ascii_ ? lines_.offset() : at_);
  return static_cast<std::size_t>(
      std::ranges::count_if(rest, [&](char c) { return !ascii_ || !(is_blank(c) || c == '\n'); }));
}

void PlyBody::fail(const std::string& message) const {
  if (ascii_) fail_at(file_, line(), message);
  fail_file(file_, element_->name + " " + std::to_string(row_) + " (from 0): " + message);
}

double PlyBody::text_value() {
  double value = 0;
  if (cursor_.number(value)) return value;
  if (trimmed(cursor_.rest()).empty())
    fail("the line has fewer values than the header declares for a " + element_->name +
         "; correct it or export the mesh again");
  fail(quoted_word(cursor_.rest()) + " is not a number; correct the " + element_->name);
}

double PlyBody::binary_value(PlyType type) {
  const std::size_t size = byte_size(type);
  if (bytes_.size() - at_ < size) fail_truncated();
  std::array<char, 8> raw{};
  std::memcpy(raw.data(), bytes_.data() + at_, size);
  if (swap_) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
  at_ += size;
  return load(raw, type);
}

void PlyBody::fail_truncated() const {
  fail_file(file_, "the file ends in or before " + element_->name + " " + std::to_string(row_) +
                       " (from 0) of " + std::to_string(element_->count) + "; it is truncated, get it whole");
}

}  // namespace multimesh::io
