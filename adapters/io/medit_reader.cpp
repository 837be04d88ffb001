// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/medit_reader.hpp"

#include <array>
#include <cctype>
#include <map>
#include <vector>

#include "adapters/io/cell_shape.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

struct ElementSection {
  std::string_view name;
  CellType type;
};

using enum CellShape;
constexpr std::array<ElementSection, 13> element_sections = {{
    {"Edges", {edge, 2, 2, "edge"}},
    {"EdgesP2", {edge, 2, 3, "edge"}},
    {"Triangles", {triangle, 3, 3, "triangle"}},
    {"TrianglesP2", {triangle, 3, 6, "triangle"}},
    {"Quadrilaterals", {quad, 4, 4, "quadrilateral"}},
    {"Tetrahedra", {tetrahedron, 4, 4, "tetrahedron"}},
    {"TetrahedraP2", {tetrahedron, 4, 10, "tetrahedron"}},
    {"Hexahedra", {other_volume, 8, 8, "hexahedron"}},
    {"Hexaedra", {other_volume, 8, 8, "hexahedron"}},
    {"Prisms", {other_volume, 6, 6, "prism"}},
    {"Pentahedra", {other_volume, 6, 6, "prism"}},
    {"Penta", {other_volume, 6, 6, "prism"}},
    {"Pyramids", {other_volume, 5, 5, "pyramid"}},
}};

struct FlagSection {
  std::string_view name;
  int dimension;
  SimplexFlag flag;
};

constexpr std::array<FlagSection, 6> flag_sections = {{
    {"Corners", 0, feature_flag},
    {"RequiredVertices", 0, required_flag},
    {"Ridges", 1, feature_flag},
    {"RequiredEdges", 1, required_flag},
    {"RequiredTriangles", 2, required_flag},
    {"RequiredTetrahedra", 3, required_flag},
}};

template <class Sections>
auto find_section(const Sections& sections, std::string_view name) -> decltype(sections.data()) {
  for (const auto& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

class MeditParser {
 public:
  MeditParser(std::string_view bytes, const std::string& file)
      : words_(bytes, file, '#'), builder_(file, SimplexBuilder::Where::line, 1) {}

  SimplexSoup parse(const ReadOptions& options) {
    begin();
    std::string_view name;
    while (words_.next(name) && name != "End") section(name);
    if (name != "End") builder_.warn("the file does not end with End; it may be truncated");
    // Elements and vertices may come after the lists that name them.
    for (const auto& [section, number, line] : flags_)
      builder_.add_flag(section->dimension, number, section->flag, line);
    for (const auto& [vertex, flag] : vertex_flags_) add_vertex(vertex, flag);
    return builder_.finish(options);
  }

 private:
  struct Flag {
    const FlagSection* section;
    std::int64_t number;
    std::uint64_t line;
  };
  struct VertexFlag {
    std::uint8_t flags = 0;
    std::uint64_t line = 0;
  };

  void begin() {
    if (words_.word("MeshVersionFormatted") != "MeshVersionFormatted")
      words_.fail(
          "this is not a MEDIT file: it does not begin with MeshVersionFormatted; check the file or "
          "its extension");
    words_.integer("the version");
  }

  void section(std::string_view name) {
    if (name == "Dimension") return dimension();
    if (name == "Vertices") return vertices();
    if (const auto* elements = find_section(element_sections, name)) return read_elements(elements->type);
    if (const auto* flags = find_section(flag_sections, name)) return read_flags(*flags);
    unknown(name);
  }

  void dimension() {
    dimension_ = words_.integer("the dimension");
    if (dimension_ != 2 && dimension_ != 3)
      words_.fail("the dimension is " + std::to_string(dimension_) + "; it must be 2 or 3");
  }

  void vertices() {
    const std::size_t count = words_.count("vertices", 6);
    builder_.reserve_points(count);
    bool tagged = false;
    std::vector<std::int32_t> tags;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> point{};
      for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c)
        point[c] = words_.number("a coordinate");
      builder_.add_point(point, words_.line());
      tags.push_back(words_.integer32("the reference of a vertex"));
      tagged = tagged || tags.back() != 0;
    }
    if (tagged) builder_.soup().point_tags = std::move(tags);
  }

  void read_elements(const CellType& type) {
    const std::size_t count = words_.count("elements", 2 * (type.nodes + std::size_t{1}));
    if (type.shape != quad && type.shape != other_volume) builder_.reserve(dimension_of(type.shape), count);
    std::vector<std::uint32_t> nodes(type.nodes);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::uint32_t& node : nodes) {
        const std::int64_t number = words_.integer("a vertex of an element");
        node = builder_.point_index(number, words_.line());
      }
      const std::int32_t tag = words_.integer32("the reference of an element");
      add_cell(builder_, type, nodes, tag, words_.line());
    }
  }

  void read_flags(const FlagSection& section) {
    for (std::size_t n = words_.count("entries", 2); n > 0; --n) {
      const std::int64_t number = words_.integer("an entry of the list");
      if (section.dimension != 0) {
        flags_.push_back({&section, number, words_.line()});
        continue;
      }
      VertexFlag& vertex = vertex_flags_[builder_.point_index(number, words_.line())];
      vertex.flags |= section.flag;
      vertex.line = words_.line();
    }
  }

  void add_vertex(std::uint32_t vertex, const VertexFlag& flag) {
    const auto& tags = builder_.soup().point_tags;
    builder_.add(0, std::array{vertex}, vertex < tags.size() ? tags[vertex] : 0, flag.line, flag.flags);
  }

  /// Words that are not numbers belong to the next section.
  void unknown(std::string_view name) {
    if (std::isalpha(static_cast<unsigned char>(name.front())) == 0)
      words_.fail("a section has to begin here, not " + quoted_word(name) +
                  "; the number of entries of the section before may be wrong");
    builder_.left_out(name);
    for (std::string_view word; !(word = words_.peek()).empty(); words_.next(word))
      if (std::isalpha(static_cast<unsigned char>(word.front())) != 0) return;
  }

  WordSource words_;
  SimplexBuilder builder_;
  std::int64_t dimension_ = 3;
  std::vector<Flag> flags_;
  std::map<std::uint32_t, VertexFlag> vertex_flags_;
};

}  // namespace

SimplexSoup parse_medit(std::string_view bytes, const std::filesystem::path& path,
                        const ReadOptions& options) {
  return MeditParser(bytes, path.string()).parse(options);
}

}  // namespace multimesh::io
