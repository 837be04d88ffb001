// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/tetgen_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

namespace fs = std::filesystem;

/// The file with that extension beside `path`; the packed one if only that exists.
fs::path sibling(fs::path path, const char* extension) {
  if (path.extension() == ".gz") path = path.stem().empty() ? path : path.parent_path() / path.stem();
  path.replace_extension(extension);
  const fs::path packed = path.string() + ".gz";
  std::error_code error;
  return !fs::exists(path, error) && fs::exists(packed, error) ? packed : path;
}

struct Node {
  std::array<double, 3> point{};
  std::int32_t marker = 0;
  std::uint64_t line = 0;
};
struct NodeFile {
  std::int64_t first = 0;  ///< number of the first node
  std::vector<Node> nodes;
};

/// The numbers at the beginning: the number of entries, and two or three more that describe an entry.
template <std::size_t N>
std::array<std::size_t, N> header(WordSource& words) {
  std::array<std::size_t, N> sizes{};
  for (std::size_t& size : sizes) {
    const std::int64_t value = words.integer("the header");
    if (value < 0) words.fail("the header has a negative number; correct it");
    size = static_cast<std::size_t>(value);
  }
  return sizes;
}

/// Entries must be numbered consecutively.
void check_number(WordSource& words, std::int64_t number, std::int64_t expected) {
  if (number != expected)
    words.fail("entry " + std::to_string(number) + " comes where " + std::to_string(expected) +
               " should; renumber the file");
}

NodeFile read_nodes(const fs::path& path) {
  const UnpackedBytes bytes(path);
  WordSource words(bytes.view(), path.string(), '#');
  const auto [count, dimension, attributes, markers] = header<4>(words);
  if (dimension != 3) words.fail("the nodes have " + std::to_string(dimension) + " coordinates; 3 are read");
  words.check_count(count, "nodes", 8);
  NodeFile file;
  for (std::size_t i = 0; i < count; ++i) {
    Node node;
    const std::int64_t number = words.integer("the number of a node");
    if (i == 0) file.first = number;
    if (i == 0 && number != 0 && number != 1) words.fail("nodes must count from 0 or 1; renumber the file");
    check_number(words, number, file.first + static_cast<std::int64_t>(i));
    for (double& x : node.point) {
      x = words.number("a coordinate");
      if (!std::isfinite(x))
        words.fail("the node is not finite (nan, inf or too large); correct or remove it");
    }
    for (std::size_t a = 0; a < attributes; ++a) words.number("an attribute");
    if (markers != 0) node.marker = words.integer32("a boundary marker");
    node.line = words.line();
    file.nodes.push_back(node);
  }
  return file;
}

/// Tags are attributes, which may be any numbers.
class Tags {
 public:
  std::int32_t tag(double attribute) {
    if (attribute == std::floor(attribute) && std::abs(attribute) < 2147483648.0)
      return static_cast<std::int32_t>(attribute);
    all_whole_ = false;
    return 0;
  }
  bool all_whole() const { return all_whole_; }

 private:
  bool all_whole_ = true;
};

void read_elements(WordSource& words, SimplexBuilder& builder) {
  const auto [count, corners, attributes] = header<3>(words);
  if (corners != 4 && corners != 10)
    words.fail("the elements have " + std::to_string(corners) + " nodes; tetrahedra have 4 or 10");
  words.check_count(count, "tetrahedra", 2 * (1 + corners + attributes));
  builder.reserve(3, count);
  Tags tags;
  std::int64_t first = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t number = words.integer("the number of an element");
    if (i == 0) first = number;
    check_number(words, number, first + static_cast<std::int64_t>(i));
    std::array<std::uint32_t, 10> nodes{};
    for (std::size_t n = 0; n < corners; ++n)
      nodes[n] = builder.point_index(words.integer("a node of an element"), words.line());
    std::int32_t tag = 0;
    for (std::size_t a = 0; a < attributes; ++a) {
      const double attribute = words.number("an attribute");
      if (a == 0) tag = tags.tag(attribute);
    }
    if (corners == 10) ++builder.notes().high_order;
    builder.add(3, std::span(nodes).first(4), tag, words.line());
  }
  if (attributes > 1) builder.left_out("attributes but the first");
  if (tags.all_whole()) return;
  builder.left_out("the attribute, which is not a whole number everywhere");
  builder.soup().simplices[3].tags.assign(count, 0);
}

/// Numbers in the rest of a line, up to a comment: a marker may be among them, and neighbours after it.
std::vector<std::int32_t> rest_of_entry(WordSource& words) {
  std::string_view line = words.line_ahead();
  const std::size_t end = std::min(line.find('#'), line.size());
  WordSource rest(line.substr(0, end), words.file(), 0, words.line());
  std::vector<std::int32_t> numbers;
  while (!rest.peek().empty()) numbers.push_back(rest.integer32("a number of an entry"));
  words.rest_of_line();
  return numbers;
}

/// Triangles or edges, with a boundary marker each, which is their tag. TetGen can be asked to list all faces
/// or edges of the mesh, with marker 0 inside; in so long a list, those are left out.
void read_markers(const fs::path& path, int dimension, SimplexBuilder& builder) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  const UnpackedBytes bytes(path);
  WordSource words(bytes.view(), path.string(), '#');
  const auto [count, has_markers] = header<2>(words);
  const auto corners = static_cast<std::size_t>(dimension) + 1;
  words.check_count(count, "entries", 2 * (1 + corners));
  // All faces are more than two for each tetrahedron, all edges more than one.
  const bool lists_all = count > static_cast<std::size_t>(dimension) * builder.soup().simplices[3].size();
  for (std::size_t i = 0; i < count; ++i) {
    words.integer("the number of an entry");
    std::array<std::uint32_t, 3> nodes{};
    for (std::size_t n = 0; n < corners; ++n)
      nodes[n] = builder.point_index(words.integer("a node of an entry"), words.line());
    const std::uint64_t line = words.line();
    std::vector<std::int32_t> rest = rest_of_entry(words);
    const std::size_t middle = builder.notes().high_order == 0 ? 0 : corners == 2 ? 1 : 3;
    if (rest.size() > middle && has_markers != 0 && middle != 0)
      rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(middle));
    const std::int32_t marker = has_markers == 0 || rest.empty() ? 0 : rest.front();
    if (marker != 0 || !lists_all) builder.add(dimension, std::span(nodes).first(corners), marker, line);
  }
}

}  // namespace

SimplexSoup read_tetgen_pair(const fs::path& path, const ReadOptions& options) {
  const NodeFile nodes = read_nodes(sibling(path, ".node"));
  const fs::path elements = sibling(path, ".ele");
  const UnpackedBytes bytes(elements);
  SimplexBuilder builder(elements.string(), SimplexBuilder::Where::line, static_cast<int>(nodes.first));
  bool tagged = false;
  for (const Node& node : nodes.nodes) {
    builder.add_point(node.point, node.line);
    tagged = tagged || node.marker != 0;
  }
  if (tagged)
    for (const Node& node : nodes.nodes) builder.soup().point_tags.push_back(node.marker);
  WordSource words(bytes.view(), elements.string(), '#');
  read_elements(words, builder);
  read_markers(sibling(path, ".face"), 2, builder);
  read_markers(sibling(path, ".edge"), 1, builder);
  return builder.finish(options);
}

}  // namespace multimesh::io
