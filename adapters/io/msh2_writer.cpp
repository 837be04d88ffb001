// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <map>
#include <span>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/msh_entities.hpp"
#include "adapters/io/msh_sink.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

/// The groups of each tag of one dimension.
using Groups = std::map<std::int32_t, std::vector<std::int32_t>>;

Groups groups_by_tag(const SimplexSoup& soup, std::size_t dimension) {
  Groups groups;
  for (const std::int32_t tag : soup.simplices[dimension].tags)
    if (!groups.contains(tag)) groups.emplace(tag, groups_of(soup, static_cast<int>(dimension), tag));
  return groups;
}

/// An element is listed once for each of its groups.
std::size_t element_count(const SimplexSoup::Block& block, const Groups& groups) {
  std::size_t count = 0;
  for (const std::int32_t tag : block.tags) count += groups.at(tag).size();
  return count;
}

/// Numbers of points and elements have 31 bits.
void check_sizes(const SimplexSoup& soup, std::size_t elements, const std::string& file) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  if (elements > most || soup.points.size() > most)
    fail_file(file,
              "version 2.2 of Gmsh's format holds at most 2147483647 elements and points; write version 4.1");
}

void put_nodes(MshSink& sink, const SimplexSoup& soup) {
  sink.text("$Nodes\n");
  sink.text_number(soup.points.size());
  sink.text("\n");
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    sink.integer(static_cast<std::int32_t>(i + 1));
    for (const double x : soup.points[i]) sink.real(x);
    sink.end_line();
  }
  sink.end_section("Nodes");
}

struct Element {
  std::int32_t type;
  std::span<const std::uint32_t> nodes;
  std::int32_t physical, entity;
};

void put_element(MshSink& sink, const Element& element, std::int32_t number) {
  sink.integer(number);
  if (!sink.binary()) {
    sink.integer(element.type);
    sink.integer(2);
  }
  sink.integer(element.physical);
  sink.integer(element.entity);
  for (const std::uint32_t node : element.nodes) sink.integer(static_cast<std::int32_t>(node + 1));
  sink.end_line();
}

/// In binary one block per type, in text one line per element; `number` continues over all dimensions.
void put_block(MshSink& sink, const SimplexSoup::Block& block, const Groups& groups,
               const std::vector<std::int32_t>& entities, std::size_t dimension, std::int32_t& number) {
  if (block.size() == 0) return;
  const std::int32_t type = msh_type(block, dimension);
  if (sink.binary()) {
    sink.integer(type);
    sink.integer(static_cast<std::int32_t>(element_count(block, groups)));
    sink.integer(2);
  }
  for (std::size_t i = 0; i < block.size(); ++i)
    for (const std::int32_t group : groups.at(block.tags[i]))
      put_element(sink, {type, nodes_of(block, i), group, entities[i]}, ++number);
}

void put_link(MshSink& text, const SimplexSoup::Periodic& link) {
  for (const std::int32_t i : {link.dimension, link.slave, link.master}) text.integer(i);
  text.end_line();
  if (!link.affine.empty()) {
    text.text("Affine ");
    for (const double x : link.affine) text.real(x);
    text.end_line();
  }
  text.size(link.points.size());
  text.end_line();
  for (const auto& [slave, master] : link.points) {
    text.size(std::uint64_t{slave} + 1);
    text.size(std::uint64_t{master} + 1);
    text.end_line();
  }
}

/// Text, also in binary files.
void put_periodic(MshSink& sink, const SimplexSoup& soup) {
  if (soup.periodic.empty()) return;
  MshSink text = sink.as_text();
  text.text("$Periodic\n");
  text.size(soup.periodic.size());
  text.end_line();
  for (const SimplexSoup::Periodic& link : soup.periodic) put_link(text, link);
  text.end_section("Periodic");
}

}  // namespace

void put_msh2(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file, Lost& lost) {
  std::array<Groups, 4> groups;
  std::size_t elements = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    groups[k] = groups_by_tag(soup, k);
    elements += element_count(soup.simplices[k], groups[k]);
  }
  check_sizes(soup, elements, file);
  MshSink sink(out, binary);
  sink.header("2.2");
  sink.physical_names(soup);
  put_nodes(sink, soup);
  sink.text("$Elements\n");
  sink.text_number(elements);
  sink.text("\n");
  std::int32_t number = 0;
  const std::array<MshEntities, 4> entities = msh_entities(soup);
  for (std::size_t k = 0; k < 4; ++k)
    put_block(sink, soup.simplices[k], groups[k], entities[k].of_simplex, k, number);
  sink.end_section("Elements");
  put_periodic(sink, soup);
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
