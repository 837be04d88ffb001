// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/stl_reader.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "adapters/io/byte_order.hpp"
#include "adapters/io/content_check.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/soup_check.hpp"
#include "adapters/io/text_cursor.hpp"
#include "adapters/io/weld.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

using Point = std::array<double, 3>;

constexpr std::size_t header_size = 84, facet_size = 50;

/// Collects facets, and joins equal corners.
class FacetCollector {
 public:
  FacetCollector() { soup_.sections.emplace_back(); }
  void reserve(std::size_t facets) {
    soup_.corners.reserve(3 * facets);
    soup_.face_begin.reserve(facets + 1);
    soup_.face_line.reserve(facets);
    soup_.face_section.reserve(facets);
    soup_.positions.reserve(3 * facets);
  }

  /// \pre finite
  void corner(const Point& p) {
    soup_.corners.push_back({static_cast<std::int32_t>(soup_.positions.size()), -1, -1});
    soup_.positions.push_back(p);
  }

  void end_facet(std::size_t line) {
    soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.face_line.push_back(static_cast<std::uint32_t>(line));
    soup_.face_section.push_back(static_cast<std::uint32_t>(soup_.sections.size()) - 1);
  }

  /// The facets that follow belong to this solid.
  void begin_solid(std::string_view name) {
    if (soup_.sections.back().object == name) return;
    soup_.sections.emplace_back().object = name;
  }

  PolygonSoup finish(const std::string& file) {
    if (soup_.face_count() == 0) fail_file(file, "the file has no facet; give a surface");
    join_equal_corners();
    return std::move(soup_);
  }

  /// Numbers of corners have 32 bits, those of positions 31.
  bool is_full() const { return soup_.corners.size() > std::numeric_limits<std::int32_t>::max() - 3U; }

  void warn(std::string message) { soup_.warnings.push_back(std::move(message)); }

 private:
  void join_equal_corners() {
    const std::vector<std::uint32_t> joins = coincident_points(soup_.positions);
    std::vector<std::int32_t> number(joins.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < joins.size(); ++i) {
      if (joins[i] == i) {
        for (double& x : soup_.positions[i]) x += 0.0;  // no -0
        soup_.positions[kept] = soup_.positions[i];
        number[i] = static_cast<std::int32_t>(kept++);
      } else {
        number[i] = number[joins[i]];
      }
    }
    soup_.notes.merged_positions = joins.size() - kept;
    soup_.positions.resize(kept);
    for (auto& c : soup_.corners) c.v = number[static_cast<std::size_t>(c.v)];
  }

  PolygonSoup soup_;
};

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// Numbers of STL are little-endian.
constexpr bool swap = std::endian::native == std::endian::big;

std::uint64_t claimed_facets(std::string_view bytes) {
  return bytes.size() < header_size ? 0 : load<std::uint32_t>(bytes.substr(80), swap);
}

PolygonSoup parse_binary(std::string_view bytes, const std::string& file) {
  const std::uint64_t count = claimed_facets(bytes);
  if (bytes.size() < header_size || count > (bytes.size() - header_size) / facet_size)
    fail_file(file, "the file has " + std::to_string(bytes.size()) + " bytes, too few for the " +
                        std::to_string(count) + " facets of its header; it is truncated, get it whole");
  FacetCollector facets;
  facets.reserve(count);
  for (std::uint64_t f = 0; f < count; ++f) {
    std::string_view numbers = bytes.substr(header_size + f * facet_size + 12);
    for (int c = 0; c < 3; ++c) {
      Point p{};
      for (double& x : p) {
        x = static_cast<double>(load<float>(numbers, swap));
        numbers.remove_prefix(4);
      }
      if (!is_finite(p))
        fail_file(file, "face " + std::to_string(f) +
                            " (from 0): a corner is not finite (nan, inf); correct or remove the face");
      if (facets.is_full()) fail_file(file, "more than 2147483647 corners; split the file");
      facets.corner(p);
    }
    facets.end_facet(0);
  }
  if (const std::size_t rest = bytes.size() - header_size - count * facet_size; rest != 0)
    facets.warn(file + ": " + std::to_string(rest) + " bytes after the last facet are left out");
  return facets.finish(file);
}

/// Only the keywords count: the rest of their lines is skipped, as all readers do.
class TextParser {
 public:
  TextParser(std::string_view bytes, const std::string& file) : words_(bytes, file) {}

  PolygonSoup parse() {
    std::string_view word;
    while (words_.next(word)) statement(lower_case(word));
    if (inside_facet_) words_.fail_truncated("the end of the facet, endfacet");
    if (inside_) facets_.warn(words_.file() + ": the file ends without endsolid; it may not be whole");
    return facets_.finish(words_.file());
  }

 private:
  void statement(const std::string& word) {
    if (word == "vertex") return vertex();
    if (word == "endloop") end_loop();
    if (word == "solid") inside_ = true;
    if (word == "endsolid") inside_ = false;
    if (word == "facet") inside_facet_ = true;
    if (word == "endfacet") inside_facet_ = false;
    if (word != "solid" && word != "endsolid" && word != "facet" && word != "outer" && word != "endloop" &&
        word != "endfacet" && word != "end" && word != "color")
      words_.fail(quoted_word(word) + " is no statement of STL; correct the file or export it again");
    const std::string_view rest = words_.rest_of_line();
    if (word == "solid") facets_.begin_solid(trimmed(rest));
  }

  void vertex() {
    if (corners_ == 3) words_.fail("the facet has more than three corners; cut it into triangles");
    if (facets_.is_full()) words_.fail("more than 2147483647 corners; split the file");
    Point p{};
    for (double& x : p) x = words_.number("a coordinate");
    if (!is_finite(p)) words_.fail("the corner is not finite (nan, inf); correct or remove the facet");
    facets_.corner(p);
    ++corners_;
  }

  void end_loop() {
    if (corners_ != 3)
      words_.fail("the facet has " + std::to_string(corners_) + " corners; it must have three, correct it");
    corners_ = 0;
    facets_.end_facet(words_.line());
  }

  WordSource words_;
  FacetCollector facets_;
  int corners_ = 0;
  bool inside_ = false;  // a solid
  bool inside_facet_ = false;
};

bool begins_as_text(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  const std::string_view text = bytes.substr(first, 5);
  return text == "solid" || text == "SOLID" || text == "Solid" || text == "facet";
}

}  // namespace

PolygonSoup parse_stl(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  refuse_foreign(bytes, file);
  const bool has_its_size =
      bytes.size() >= header_size && bytes.size() - header_size == claimed_facets(bytes) * facet_size;
  const bool has_zeros = bytes.substr(0, 4096).find('\0') != std::string_view::npos;
  const bool is_text = !has_its_size && !has_zeros && begins_as_text(bytes);
  if (!is_text && !has_its_size && !has_zeros)
    fail_file(file,
              "this is not an STL file: it neither begins with 'solid' nor has the size of a binary one; "
              "check the file or its extension");
  PolygonSoup soup = is_text ? TextParser(bytes, file).parse() : parse_binary(bytes, file);
  check_soup(soup, file, 0, options);
  return soup;
}

}  // namespace multimesh::io
