// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

constexpr std::array<const char*, 4> names = {"Vertices", "Edges", "Triangles", "Tetrahedra"};
constexpr std::array<const char*, 4> feature_names = {"Corners", "Ridges", nullptr, nullptr};
constexpr std::array<const char*, 4> required_names = {"RequiredVertices", "RequiredEdges",
                                                       "RequiredTriangles", "RequiredTetrahedra"};

void put_numbers(OutputBuffer& out, const char* name, const std::vector<std::uint64_t>& numbers) {
  if (numbers.empty()) return;
  out.text(name);
  out.character('\n');
  out.number(numbers.size());
  for (const std::uint64_t number : numbers) {
    out.character('\n');
    out.number(number);
  }
  out.character('\n');
}

/// References of points: their own, or the tags of vertices if they have none.
std::vector<std::int32_t> point_references(const SimplexSoup& soup) {
  std::vector<std::int32_t> references = soup.point_tags;
  references.resize(soup.points.size());
  const SimplexSoup::Block& vertices = soup.simplices[0];
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::int32_t& reference = references[vertices.corners[i]];
    if (reference == 0) reference = vertices.tags[i];
  }
  return references;
}

void put_points(OutputBuffer& out, const SimplexSoup& soup) {
  const std::vector<std::int32_t> references = point_references(soup);
  out.text("Vertices\n");
  out.number(soup.points.size());
  out.character('\n');
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    put_point(out, soup.points[i]);
    out.character(' ');
    out.number(references[i]);
    out.character('\n');
  }
}

void put_elements(OutputBuffer& out, const SimplexSoup::Block& block, std::size_t dimension) {
  if (block.tags.empty()) return;
  out.text(names[dimension]);
  out.character('\n');
  out.number(block.size());
  out.character('\n');
  for (std::size_t i = 0; i < block.size(); ++i) {
    put_corners(out, block, dimension, i, 1);
    out.number(block.tags[i]);
    out.character('\n');
  }
}

/// Lists of vertices name points. A vertex without flags is written as a corner, because there is no other
/// way.
void put_flags(OutputBuffer& out, const SimplexSoup::Block& block, std::size_t dimension) {
  std::vector<std::uint64_t> feature, required;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const std::uint8_t flags = block.flags.empty() ? std::uint8_t{0} : block.flags[i];
    const std::uint64_t number = 1 + (dimension == 0 ? std::uint64_t{block.corners[i]} : std::uint64_t{i});
    if ((flags & feature_flag) != 0 || (dimension == 0 && flags == 0)) feature.push_back(number);
    if ((flags & required_flag) != 0) required.push_back(number);
  }
  if (feature_names[dimension] != nullptr) put_numbers(out, feature_names[dimension], feature);
  put_numbers(out, required_names[dimension], required);
}

}  // namespace

void put_medit(OutputBuffer& out, const SimplexSoup& soup, Lost& lost) {
  out.text("MeshVersionFormatted 2\nDimension 3\n");
  put_points(out, soup);
  for (std::size_t k = 1; k < 4; ++k) put_elements(out, soup.simplices[k], k);
  for (std::size_t k = 0; k < 4; ++k) put_flags(out, soup.simplices[k], k);
  out.text("End\n");
  if (!soup.groups.empty()) lost.push_back("names of groups");
}

}  // namespace multimesh::io
