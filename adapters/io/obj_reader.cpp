// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "adapters/io/content_check.hpp"
#include "adapters/io/file_bytes.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/library_names.hpp"
#include "adapters/io/line_source.hpp"
#include "adapters/io/note_warnings.hpp"
#include "adapters/io/obj_words.hpp"
#include "adapters/io/soup_check.hpp"

namespace multimesh::io {
namespace {

class ObjParser {
 public:
  /// Parses the first text of a file of `size` bytes.
  ObjParser(std::string_view text, std::size_t size, const std::filesystem::path& path, bool keep_lines)
      : lines_(text, LineSource::Continuation::joined),
        directory_(path.parent_path()),
        file_(path.string()),
        keep_lines_(keep_lines) {
    reserve(size);
    statements();
  }

  void go_on(std::string_view text) {
    lines_.go_on(text);
    statements();
  }

  PolygonSoup finish(const ReadOptions& options) {
    check();
    check_soup(soup_, file_, 1, options, nonfinite_);
    return std::move(soup_);
  }

 private:
  /// Reserves room for a file of triangles with texture coordinates. Pages that are never written cost
  /// nothing.
  void reserve(std::size_t bytes) {
    soup_.positions.reserve(bytes / 120);
    soup_.texcoords.reserve(bytes / 120);
    soup_.corners.reserve(bytes / 24);
    soup_.face_begin.reserve(bytes / 72);
    soup_.face_line.reserve(bytes / 72);
    soup_.face_section.reserve(bytes / 72);
  }

  void statements() {
    for (std::string_view line; lines_.next(line);) statement(line);
  }

  void statement(std::string_view line) {
    TextCursor cursor(line);
    if (cursor.done()) return;
    const std::string_view word = cursor.word();
    if (word == "v") return position(cursor);
    if (word == "vt") return texcoord(cursor);
    if (word == "f" || word == "fo") return face(cursor);
    if (word == "vn") return normal(cursor);
    if (word == "l") return polyline(cursor);
    grouping(word, without_comment(trimmed(cursor.rest())));
  }

  void grouping(std::string_view word, std::string_view rest) {
    if (word == "usemtl") return set(section_.material, rest);
    if (word == "g") return set(section_.group, rest);
    if (word == "o") return set(section_.object, rest);
    if (word == "s") return set(section_.smoothing, rest == "off" || rest == "0" ? std::string_view{} : rest);
    if (word == "mtllib") return libraries(rest);
    if (word == "p") return void(++soup_.notes.points);
    if (is_free_form(word)) return void(++soup_.notes.curves);
    unknown(word);
  }

  void set(std::string& value, std::string_view text) {
    value = text;
    section_known_ = false;
  }

  void libraries(std::string_view rest) {
    for (std::string& name : split_library_names(rest, directory_))
      if (std::ranges::find(soup_.material_libraries, name) == soup_.material_libraries.end())
        soup_.material_libraries.push_back(std::move(name));
  }

  void unknown(std::string_view word) {
    if (soup_.notes.unknown++ != 0) return;
    first_unknown_ = quoted_word(word);
    first_unknown_line_ = lines_.number();
  }

  /// All numbers of the line, at most N. \return how many.
  template <std::size_t N>
  std::size_t numbers(TextCursor& cursor, std::array<double, N>& values, std::string_view what) {
    std::size_t count = 0;
    for (; !cursor.done(); ++count) {
      if (count == N)
        fail("the " + std::string(what) + " has more than " + std::to_string(N) +
             " numbers; remove the rest");
      if (!cursor.number(values[count]))
        fail(quoted_word(cursor.rest()) + " is not a number; write the " + std::string(what) +
             " with decimal points, separated by blanks");
    }
    return count;
  }

  void position(TextCursor& cursor) {
    std::array<double, 7> n;
    const std::size_t count = numbers(cursor, n, "vertex");
    if (count < 3) fail("the vertex has " + std::to_string(count) + " numbers; write three coordinates");
    if (count == 5) fail("the vertex has 5 numbers; write 3 coordinates, or 3 coordinates and 3 colours");
    if (count == 4 || count == 7) ++soup_.notes.weights;
    if (count >= 6) add_color({n[3], n[4], n[5]});
    if (!std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2])) [[unlikely]]
      nonfinite_.push_back({static_cast<std::uint32_t>(soup_.positions.size()), lines_.number()});
    soup_.positions.push_back({n[0], n[1], n[2]});
  }

  void add_color(const std::array<double, 3>& color) {
    soup_.colors.resize(soup_.positions.size(), {1, 1, 1});
    soup_.colors.push_back(color);
    ++colored_;
  }

  void texcoord(TextCursor& cursor) {
    std::array<double, 3> n{};
    if (numbers(cursor, n, "texture coordinate") == 0)
      fail("the texture coordinate has no number; write two");
    if (n[2] != 0 && std::isfinite(n[2])) ++soup_.notes.third_texcoords;
    soup_.texcoords.push_back({n[0], n[1]});
  }

  void normal(TextCursor& cursor) {
    std::array<double, 3> n{};
    if (numbers(cursor, n, "normal") != 3) fail("the normal does not have three numbers; write three");
    if (!std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2])) {
      ++soup_.notes.nonfinite_normals;
      n = {0, 0, 0};
    }
    soup_.normals.push_back(n);
  }

  void face(TextCursor& cursor) {
    while (!cursor.done()) soup_.corners.push_back(corner(cursor));
    const std::size_t size = soup_.corners.size() - soup_.face_begin.back();
    if (size < 3)
      fail("the face has " + std::to_string(size) + " corners; remove it or give it three or more");
    if (soup_.corners.size() > std::numeric_limits<std::uint32_t>::max())
      fail("more than 4294967295 face corners; split the file");
    soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.face_line.push_back(static_cast<std::uint32_t>(lines_.number()));
    if (!section_known_) enter_section();
    soup_.face_section.push_back(current_section_);
  }

  void polyline(TextCursor& cursor) {
    ++soup_.notes.lines;
    if (!keep_lines_) return;
    while (!cursor.done()) soup_.line_corners.push_back(corner(cursor).v);
    const std::size_t size = soup_.line_corners.size() - soup_.line_begin.back();
    if (size < 2)
      fail("the line has " + std::to_string(size) + " vertices; remove it or give it two or more");
    if (soup_.line_corners.size() > std::numeric_limits<std::uint32_t>::max())
      fail("more than 4294967295 vertices of lines; split the file");
    soup_.line_begin.push_back(static_cast<std::uint32_t>(soup_.line_corners.size()));
    polyline_line_.push_back(lines_.number());
  }

  /// Indices may refer to later positions.
  void check_polylines() const {
    for (std::size_t i = 0; i < soup_.line_count(); ++i)
      for (std::uint32_t c = soup_.line_begin[i]; c < soup_.line_begin[i + 1]; ++c)
        if (static_cast<std::size_t>(soup_.line_corners[c]) >= soup_.positions.size())
          fail_at(file_, polyline_line_[i],
                  "the line names vertex " + std::to_string(std::int64_t{soup_.line_corners[c]} + 1) +
                      " but the file has " + std::to_string(soup_.positions.size()) +
                      "; correct or remove the line");
  }

  PolygonSoup::Corner corner(TextCursor& cursor) {
    const std::string_view text = cursor.rest();
    PolygonSoup::Corner c;
    c.v = index(cursor, text, soup_.positions.size(), "vertex");
    if (cursor.take('/') && !cursor.at_word_end()) {
      if (cursor.rest().front() != '/')
        c.vt = index(cursor, text, soup_.texcoords.size(), "texture coordinate");
      if (cursor.take('/') && !cursor.at_word_end())
        c.vn = index(cursor, text, soup_.normals.size(), "normal");
    }
    if (!cursor.at_word_end()) fail_corner(text);
    return c;
  }

  /// Positive indices may refer to later elements and are checked at the end; negative ones count back from
  /// here.
  std::int32_t index(TextCursor& cursor, std::string_view text, std::size_t so_far, const char* what) {
    std::int64_t i = 0;
    if (!cursor.integer(i)) [[unlikely]]
      fail_corner(text);
    if (i > 0 && i <= std::numeric_limits<std::int32_t>::max()) [[likely]]
      return static_cast<std::int32_t>(i - 1);
    if (i >= 0 || -i > static_cast<std::int64_t>(so_far)) fail_index(i, so_far, what);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(so_far) + i);
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_index(std::int64_t i, std::size_t so_far,
                                                         const char* what) const {
    const std::string name = std::string(what) + " index " + std::to_string(i);
    if (i == 0) fail(name + " in the face; indices count from 1, correct or remove the face");
    fail(name + " in the face is out of range: the file has " + std::to_string(so_far) +
         " up to this line; correct or remove the face");
  }

  void enter_section() {
    const auto [at, is_new] =
        section_ids_.try_emplace(section_, static_cast<std::uint32_t>(soup_.sections.size()));
    if (is_new) soup_.sections.push_back(section_);
    current_section_ = at->second;
    section_known_ = true;
  }

  void check() {
    if (soup_.face_count() == 0 && soup_.line_count() == 0) fail_without_faces();
    check_polylines();
    if (!soup_.colors.empty()) {
      soup_.colors.resize(soup_.positions.size(), {1, 1, 1});
      soup_.notes.missing_colors = soup_.positions.size() - colored_;
    }
    if (soup_.notes.unknown != 0)
      soup_.warnings.push_back(file_ + ":" + std::to_string(first_unknown_line_) + ": unknown statement " +
                               first_unknown_ + " is left out; " + std::to_string(soup_.notes.unknown) +
                               " such lines in the file");
    add_note_warnings(soup_, file_);
  }

  [[noreturn]] void fail_without_faces() const {
    if (soup_.notes.lines + soup_.notes.points + soup_.notes.curves != 0)
      fail_file(file_, "the file has points, lines or curves but no face; give a surface");
    if (!soup_.positions.empty()) fail_file(file_, "the file has vertices but no face; give a surface");
    if (soup_.notes.unknown != 0)
      fail_at(file_, first_unknown_line_,
              "this is not a Wavefront OBJ file: unknown statement " + first_unknown_ +
                  ", and no vertex or face in the file; check its format");
    fail_file(file_, "the file has no vertex and no face; export the mesh again");
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail(const std::string& message) const {
    fail_at(file_, lines_.number(), message);
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail_corner(std::string_view text) const {
    fail(quoted_word(text) + " is not a face corner; write v, v/vt, v//vn or v/vt/vn with integers");
  }

  PolygonSoup soup_;
  LineSource lines_;
  std::filesystem::path directory_;
  std::string file_;
  bool keep_lines_;
  std::vector<std::size_t> polyline_line_;
  std::vector<NonfinitePosition> nonfinite_;
  PolygonSoup::Section section_;
  std::map<PolygonSoup::Section, std::uint32_t> section_ids_;
  std::uint32_t current_section_ = 0;
  bool section_known_ = false;
  std::size_t colored_ = 0;
  std::string first_unknown_;
  std::size_t first_unknown_line_ = 0;
};

/// Refuses by its first bytes what is not an OBJ file. \return the text without a byte order mark
std::string_view checked_beginning(std::string_view text, const std::string& file) {
  check_obj_content(text, file);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace

PolygonSoup read_obj(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  TextPieces pieces(path);
  ObjParser parser(checked_beginning(pieces.next(), file), pieces.size(), path, options.keep_lines);
  for (std::string_view piece; !(piece = pieces.next()).empty();) parser.go_on(piece);
  return parser.finish(options);
}

PolygonSoup parse_obj(std::string_view text, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  ObjParser parser(checked_beginning(text, file), text.size(), path, options.keep_lines);
  return parser.finish(options);
}

}  // namespace multimesh::io
