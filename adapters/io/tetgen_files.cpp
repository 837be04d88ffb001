// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/tetgen_files.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

namespace fs = std::filesystem;

/// The file of that extension beside `path`; the packed one if only that is there.
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

/// The numbers at the beginning: of entries, and two or three more that say what an entry has.
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

/// Entries have to be numbered one after the other.
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
  return builder.finish(options);
}

}  // namespace multimesh::io
