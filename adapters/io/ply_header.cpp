// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/ply_header.hpp"

#include <array>
#include <limits>
#include <utility>

#include "adapters/io/input_location.hpp"
#include "adapters/io/line_source.hpp"

namespace multimesh::io {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names = {{{"char", PlyType::int8},
                                                                              {"int8", PlyType::int8},
                                                                              {"uchar", PlyType::uint8},
                                                                              {"uint8", PlyType::uint8},
                                                                              {"short", PlyType::int16},
                                                                              {"int16", PlyType::int16},
                                                                              {"ushort", PlyType::uint16},
                                                                              {"uint16", PlyType::uint16},
                                                                              {"int", PlyType::int32},
                                                                              {"int32", PlyType::int32},
                                                                              {"uint", PlyType::uint32},
                                                                              {"uint32", PlyType::uint32},
                                                                              {"float", PlyType::float32},
                                                                              {"float32", PlyType::float32},
                                                                              {"double", PlyType::float64},
                                                                              {"float64", PlyType::float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, std::string_view file)
      : lines_(bytes, LineSource::Continuation::ignored), file_(file) {}

  PlyHeader parse() {
    std::string_view line;
    lines_.next(line);  // 'ply', see check_ply_content
    while (lines_.next(line)) {
      TextCursor cursor(line);
      const std::string_view word = cursor.word();
      if (word == "end_header") return finish();
      statement(word, cursor);
    }
    fail_file(file_, "the PLY header has no line 'end_header'; the file is truncated, get it whole");
  }

 private:
  void statement(std::string_view word, TextCursor& cursor) {
    if (word == "format") return format(cursor.word());
    if (word == "element") return element(cursor);
    if (word == "property") return property(cursor);
    if (word == "comment") return comment(cursor);
    if (!word.empty() && word != "obj_info")
      fail("unknown statement " + quoted_word(word) + " in the PLY header");
  }

  void format(std::string_view name) {
    if (name == "ascii")
      header_.format = PlyFormat::ascii;
    else if (name == "binary_little_endian")
      header_.format = PlyFormat::little_endian;
    else if (name == "binary_big_endian")
      header_.format = PlyFormat::big_endian;
    else
      fail("unknown PLY format " + quoted_word(name) + "; write ascii or binary_little_endian");
    has_format_ = true;
  }

  void element(TextCursor& cursor) {
    PlyElement element;
    element.name = cursor.word();
    element.line = lines_.number();
    cursor.skip_blanks();
    std::int64_t count = -1;
    if (element.name.empty() || !cursor.integer(count) || !cursor.at_word_end() || count < 0 ||
        count > std::numeric_limits<std::int32_t>::max())
      fail("the element has no usable number; write 'element NAME NUMBER' with at most 2147483647");
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void property(TextCursor& cursor) {
    if (header_.elements.empty()) fail("property before the first element; correct the header");
    PlyProperty property;
    std::string_view word = cursor.word();
    property.is_list = word == "list";
    if (property.is_list) {
      property.size_type = type(cursor.word());
      word = cursor.word();
    }
    property.type = type(word);
    property.name = cursor.word();
    if (property.name.empty()) fail("the property has no name; correct the header");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type(std::string_view name) const {
    for (const auto& [known, type] : type_names)
      if (name == known) return type;
    fail("unknown PLY type " + quoted_word(name) + "; correct the header");
  }

  void comment(TextCursor& cursor) {
    if (cursor.word() != "TextureFile") return;
    if (const std::string_view name = trimmed(cursor.rest()); !name.empty())
      header_.textures.emplace_back(name);
  }

  PlyHeader finish() {
    if (!has_format_) fail("the PLY header has no line 'format'; add 'format ascii 1.0' or what the file is");
    header_.size = lines_.offset();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  [[noreturn]] void fail(const std::string& message) const { fail_at(file_, lines_.number(), message); }

  LineSource lines_;
  std::string_view file_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t byte_size(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes, std::string_view file) {
  return HeaderParser(bytes, file).parse();
}

}  // namespace multimesh::io
