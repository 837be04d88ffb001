// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "adapters/io/input_location.hpp"
#include "adapters/io/msh_sink.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

struct Box {
  std::array<double, 3> low{}, high{};
  bool is_empty = true;

  void add(const std::array<double, 3>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = is_empty ? p[i] : std::min(low[i], p[i]);
      high[i] = is_empty ? p[i] : std::max(high[i], p[i]);
    }
    is_empty = false;
  }
};

/// One geometrical entity per tag, of the tag's number; so elements without a tag are in entity 0.
using Entities = std::map<std::int32_t, Box>;

Entities entities_of(const SimplexSoup& soup, std::size_t dimension, const std::string& file) {
  Entities entities;
  const SimplexSoup::Block& block = soup.simplices[dimension];
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (block.tags[i] < 0)
      fail_file(
          file,
          "tag " + std::to_string(block.tags[i]) +
              " is negative, which version 4.1 of Gmsh's format takes for a reversed orientation; write "
              "version 2.2, or renumber the tags");
    Box& box = entities[block.tags[i]];
    for (std::size_t c = 0; c <= dimension; ++c) box.add(soup.points[block.corners[(dimension + 1) * i + c]]);
  }
  return entities;
}

void put_entity(MshSink& sink, std::size_t dimension, std::int32_t tag, const Box& box) {
  sink.integer(tag);
  for (const double x : box.low) sink.real(x);
  if (dimension != 0)
    for (const double x : box.high) sink.real(x);
  sink.size(tag != 0 ? 1 : 0);  // physical tags
  if (tag != 0) sink.integer(tag);
  if (dimension != 0) sink.size(0);  // bounding entities
  sink.end_line();
}

void put_entities(MshSink& sink, const std::array<Entities, 4>& entities) {
  sink.text("$Entities\n");
  for (const Entities& e : entities) sink.size(e.size());
  sink.end_line();
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [tag, box] : entities[k]) put_entity(sink, k, tag, box);
  sink.end_section("Entities");
}

/// All in one block, of the first simplex of the largest dimension: to which entity a point belongs is not
/// known.
void put_nodes(MshSink& sink, const SimplexSoup& soup) {
  const auto dimension = static_cast<std::size_t>(soup.dimension());
  const std::size_t count = soup.points.size();
  sink.text("$Nodes\n");
  for (const std::uint64_t value :
       {std::uint64_t{1}, std::uint64_t{count}, std::uint64_t{1}, std::uint64_t{count}})
    sink.size(value);
  sink.end_line();
  sink.integer(static_cast<std::int32_t>(dimension));
  sink.integer(soup.simplices[dimension].tags.front());
  sink.integer(0);  // not parametric
  sink.size(count);
  sink.end_line();
  for (std::size_t i = 1; i <= count; ++i) {
    sink.size(i);
    sink.end_line();
  }
  for (const auto& point : soup.points) {
    for (const double x : point) sink.real(x);
    sink.end_line();
  }
  sink.end_section("Nodes");
}

/// Where the run of equal tags that begins at `begin` ends. Runs are blocks, so that elements keep their
/// order.
std::size_t run_end(const SimplexSoup::Block& block, std::size_t begin) {
  std::size_t end = begin;
  while (end < block.size() && block.tags[end] == block.tags[begin]) ++end;
  return end;
}

std::size_t run_count(const SimplexSoup::Block& block) {
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < block.size(); begin = run_end(block, begin)) ++count;
  return count;
}

void put_run(MshSink& sink, const SimplexSoup::Block& block, std::size_t dimension, std::size_t begin,
             std::uint64_t& number) {
  const std::size_t end = run_end(block, begin);
  sink.integer(static_cast<std::int32_t>(dimension));
  sink.integer(block.tags[begin]);
  sink.integer(msh_types[dimension]);
  sink.size(end - begin);
  sink.end_line();
  for (std::size_t i = begin; i < end; ++i) {
    sink.size(++number);
    for (std::size_t c = 0; c <= dimension; ++c)
      sink.size(std::uint64_t{block.corners[(dimension + 1) * i + c]} + 1);
    sink.end_line();
  }
}

void put_elements(MshSink& sink, const SimplexSoup& soup) {
  std::size_t blocks = 0, elements = 0;
  for (const SimplexSoup::Block& block : soup.simplices) {
    blocks += run_count(block);
    elements += block.size();
  }
  sink.text("$Elements\n");
  for (const std::size_t value : {blocks, elements, std::size_t{1}, elements}) sink.size(value);
  sink.end_line();
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const SimplexSoup::Block& block = soup.simplices[k];
    for (std::size_t begin = 0; begin < block.size(); begin = run_end(block, begin))
      put_run(sink, block, k, begin, number);
  }
  sink.end_section("Elements");
}

}  // namespace

void put_msh4(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file, Lost& lost) {
  std::array<Entities, 4> entities;
  for (std::size_t k = 0; k < 4; ++k) entities[k] = entities_of(soup, k, file);
  MshSink sink(out, binary);
  sink.header("4.1");
  sink.physical_names(soup);
  put_entities(sink, entities);
  put_nodes(sink, soup);
  put_elements(sink, soup);
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
