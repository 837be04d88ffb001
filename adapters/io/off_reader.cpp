// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/off_reader.hpp"

#include <cmath>
#include <limits>

#include "adapters/io/content_check.hpp"
#include "adapters/io/note_warnings.hpp"
#include "adapters/io/soup_check.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

class OffParser {
 public:
  OffParser(std::string_view bytes, const std::string& file, std::vector<NonfinitePosition>& nonfinite)
      : words_(bytes, file, '#'), file_(file), nonfinite_(nonfinite) {}

  PolygonSoup parse() {
    const std::size_t vertex_count = header();
    const std::size_t face_count = words_.count("faces", 2);
    // The number of edges; some files omit it, and it is not needed.
    if (words_left_on_line() != 0) words_.integer("the number of edges");
    words_.check_count(vertex_count, "vertices", 6);
    if (face_count == 0) words_.fail("the file has no face; give a surface");
    for (std::size_t i = 0; i < vertex_count; ++i) vertex();
    for (std::size_t i = 0; i < face_count; ++i) face();
    soup_.sections.emplace_back();
    add_note_warnings(soup_, file_);
    if (face_colors_ != 0) warn("the colours of " + std::to_string(face_colors_) + " faces are left out");
    if (!words_.peek().empty()) warn("what follows the last face is left out");
    return std::move(soup_);
  }

 private:
  /// The keyword may be missing, or joined to the first number. \return the number of vertices
  std::size_t header() {
    std::string_view word = words_.peek();
    const std::size_t at = word.find("OFF");
    if (at == std::string_view::npos) {
      if (word.empty() || word.front() < '0' || word.front() > '9')
        words_.fail("this is not an OFF file: it does not begin with OFF; check the file or its extension");
      return words_.count("vertices", 0);
    }
    word = words_.word("the keyword OFF");
    flags(word.substr(0, at));
    const std::string_view glued = word.substr(at + 3);
    if (words_.peek() == "BINARY") words_.fail("binary OFF files are not read; save the mesh as text");
    if (glued.empty()) return words_.count("vertices", 0);
    std::int64_t count = 0;
    TextCursor cursor(glued);
    if (!cursor.integer(count) || !cursor.at_word_end() || count < 0)
      words_.fail(quoted_word(word) + " is not the keyword OFF; correct it");
    return static_cast<std::size_t>(count);
  }

  /// Letters before OFF, in the order that the format demands: ST C N 4 n.
  void flags(std::string_view letters) {
    has_texcoords_ = take(letters, "ST");
    has_colors_ = take(letters, "C");
    has_normals_ = take(letters, "N");
    if (!letters.empty())
      words_.fail("OFF files with " + quoted_word(letters) +
                  " (other dimensions) are not read; save the mesh "
                  "with three coordinates");
  }

  static bool take(std::string_view& letters, std::string_view flag) {
    if (!letters.starts_with(flag)) return false;
    letters.remove_prefix(flag.size());
    return true;
  }

  void vertex() {
    const auto position = numbers<3>("a coordinate");
    if (!is_finite(position))
      nonfinite_.push_back({static_cast<std::uint32_t>(soup_.positions.size()), words_.line()});
    soup_.positions.push_back(position);
    if (has_normals_) soup_.normals.push_back(normal());
    if (has_colors_) soup_.colors.push_back(color());
    if (has_texcoords_) soup_.texcoords.push_back(numbers<2>("a texture coordinate"));
  }

  template <std::size_t N>
  std::array<double, N> numbers(std::string_view what) {
    std::array<double, N> values{};
    for (double& x : values) x = words_.number(what);
    return values;
  }

  static bool is_finite(const std::array<double, 3>& n) {
    return std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]);
  }

  std::array<double, 3> normal() {
    const auto n = numbers<3>("a normal");
    if (is_finite(n)) return n;
    ++soup_.notes.nonfinite_normals;
    return {};
  }

  /// Three numbers or four: in [0, 1] if they have decimal points, otherwise in 0..255.
  std::array<double, 3> color() {
    std::array<double, 3> rgb{};
    bool has_points = false;
    for (double& x : rgb) {
      has_points = has_points || words_.peek().find('.') != std::string_view::npos;
      x = words_.number("a colour");
    }
    const std::size_t behind = has_texcoords_ ? 2 : 0;
    if (words_left_on_line() > behind) {
      words_.number("a colour");
      ++soup_.notes.weights;
    }
    if (!has_points)
      for (double& x : rgb) x /= 255;
    return rgb;
  }

  std::size_t words_left_on_line() {
    TextCursor cursor(words_.line_ahead());
    std::size_t count = 0;
    for (; !cursor.done(); ++count) cursor.word();
    return count;
  }

  void face() {
    const std::size_t size = words_.count("corners", 2);
    const std::size_t line = words_.line();
    if (size < 3)
      words_.fail("the face has " + std::to_string(size) + " corners; remove it or give it three or more");
    if (soup_.corners.size() + size > std::numeric_limits<std::uint32_t>::max())
      words_.fail("more than 4294967295 face corners; split the file");
    for (std::size_t i = 0; i < size; ++i) {
      const std::int64_t v = words_.integer("a corner");
      if (v < 0 || v > std::numeric_limits<std::int32_t>::max())
        words_.fail("the face names vertex " + std::to_string(v) +
                    "; vertices count from 0, correct the face");
      const auto index = static_cast<std::int32_t>(v);
      soup_.corners.push_back({index, has_texcoords_ ? index : -1, has_normals_ ? index : -1});
    }
    TextCursor rest(words_.rest_of_line());
    if (!rest.done()) ++face_colors_;
    soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.face_line.push_back(static_cast<std::uint32_t>(line));
    soup_.face_section.push_back(0);
  }

  void warn(const std::string& message) { soup_.warnings.push_back(file_ + ": " + message); }

  WordSource words_;
  std::string file_;
  std::vector<NonfinitePosition>& nonfinite_;
  PolygonSoup soup_;
  bool has_texcoords_ = false, has_colors_ = false, has_normals_ = false;
  std::size_t face_colors_ = 0;
};

}  // namespace

PolygonSoup parse_off(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  refuse_foreign(bytes, file);
  std::vector<NonfinitePosition> nonfinite;
  PolygonSoup soup = OffParser(bytes, file, nonfinite).parse();
  check_soup(soup, file, 0, options, nonfinite);
  return soup;
}

}  // namespace multimesh::io
