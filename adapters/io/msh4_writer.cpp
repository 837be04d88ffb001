// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "adapters/io/group_tags.hpp"
#include "adapters/io/msh_entities.hpp"
#include "adapters/io/msh_sink.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

using Entities = std::array<MshEntities, 4>;

void put_entity(MshSink& sink, const SimplexSoup& soup, std::size_t dimension, std::int32_t number,
                const MshEntity& entity) {
  sink.integer(number);
  for (const double x : entity.low) sink.real(x);
  if (dimension != 0)
    for (const double x : entity.high) sink.real(x);
  std::vector<std::int32_t> physicals;
  if (entity.physical != 0) physicals = groups_of(soup, static_cast<int>(dimension), entity.physical);
  sink.size(physicals.size());
  for (const std::int32_t physical : physicals) sink.integer(physical);
  if (dimension != 0) sink.size(0);  // bounding entities
  sink.end_line();
}

void put_entities(MshSink& sink, const SimplexSoup& soup, const Entities& entities) {
  sink.text("$Entities\n");
  for (const MshEntities& e : entities) sink.size(e.by_number.size());
  sink.end_line();
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [number, entity] : entities[k].by_number) put_entity(sink, soup, k, number, entity);
  sink.end_section("Entities");
}

/// Points or simplices by their entity, in their order within it: blocks of the file.
using Blocks = std::map<std::int32_t, std::vector<std::uint32_t>>;

/// A point is in the entity of lowest dimension that has a simplex at it; one without a simplex, in the first
/// entity of the mesh.
std::array<Blocks, 4> node_blocks(const SimplexSoup& soup, const Entities& entities) {
  const auto highest = static_cast<std::size_t>(soup.dimension());
  std::vector<std::uint8_t> dimension(soup.points.size(), static_cast<std::uint8_t>(highest));
  std::vector<std::int32_t> entity(soup.points.size(), entities[highest].of_simplex.front());
  for (std::size_t k = highest + 1; k-- > 0;)
    for (std::size_t c = 0; c < soup.simplices[k].corners.size(); ++c) {
      const std::uint32_t point = soup.simplices[k].corners[c];
      dimension[point] = static_cast<std::uint8_t>(k);
      entity[point] = entities[k].of_simplex[c / nodes_per_simplex(soup.simplices[k])];
    }
  std::array<Blocks, 4> blocks;
  for (std::uint32_t i = 0; i < soup.points.size(); ++i) blocks[dimension[i]][entity[i]].push_back(i);
  return blocks;
}

/// The numbers that begin $Nodes and $Elements.
void put_counts(MshSink& sink, std::string_view section, const std::array<Blocks, 4>& blocks) {
  std::size_t count = 0, entries = 0;
  for (const Blocks& of_dimension : blocks) {
    count += of_dimension.size();
    for (const auto& [entity, members] : of_dimension) entries += members.size();
  }
  sink.text(section);
  for (const std::size_t value : {count, entries, std::size_t{1}, entries}) sink.size(value);
  sink.end_line();
}

/// Nodes are numbered by their order in the soup.
void put_nodes(MshSink& sink, const SimplexSoup& soup, const Entities& entities) {
  const std::array<Blocks, 4> blocks = node_blocks(soup, entities);
  put_counts(sink, "$Nodes\n", blocks);
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [entity, points] : blocks[k]) {
      sink.integer(static_cast<std::int32_t>(k));
      sink.integer(entity);
      sink.integer(0);  // not parametric
      sink.size(points.size());
      sink.end_line();
      for (const std::uint32_t i : points) {
        sink.size(std::uint64_t{i} + 1);
        sink.end_line();
      }
      for (const std::uint32_t i : points) {
        for (const double x : soup.points[i]) sink.real(x);
        sink.end_line();
      }
    }
  sink.end_section("Nodes");
}

/// Simplices are numbered by their order in the soup, after those of lower dimension, from `number`.
void put_block(MshSink& sink, const SimplexSoup::Block& block, const std::vector<std::uint32_t>& members,
               std::uint64_t number) {
  for (const std::uint32_t i : members) {
    sink.size(number + i);
    for (const std::uint32_t node : nodes_of(block, i)) sink.size(std::uint64_t{node} + 1);
    sink.end_line();
  }
}

void put_elements(MshSink& sink, const SimplexSoup& soup, const Entities& entities) {
  std::array<Blocks, 4> blocks;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::uint32_t i = 0; i < soup.simplices[k].size(); ++i)
      blocks[k][entities[k].of_simplex[i]].push_back(i);
  put_counts(sink, "$Elements\n", blocks);
  std::uint64_t number = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    for (const auto& [entity, members] : blocks[k]) {
      sink.integer(static_cast<std::int32_t>(k));
      sink.integer(entity);
      sink.integer(msh_type(soup.simplices[k], k));
      sink.size(members.size());
      sink.end_line();
      put_block(sink, soup.simplices[k], members, number);
    }
    number += soup.simplices[k].size();
  }
  sink.end_section("Elements");
}

void put_link(MshSink& sink, const SimplexSoup::Periodic& link) {
  sink.integer(link.dimension);
  sink.integer(link.slave);
  sink.integer(link.master);
  sink.end_line();
  sink.size(link.affine.size());
  for (const double x : link.affine) sink.real(x);
  sink.end_line();
  sink.size(link.points.size());
  sink.end_line();
  for (const auto& [slave, master] : link.points) {
    sink.size(std::uint64_t{slave} + 1);
    sink.size(std::uint64_t{master} + 1);
    sink.end_line();
  }
}

void put_periodic(MshSink& sink, const SimplexSoup& soup) {
  if (soup.periodic.empty()) return;
  sink.text("$Periodic\n");
  sink.size(soup.periodic.size());
  sink.end_line();
  for (const SimplexSoup::Periodic& link : soup.periodic) put_link(sink, link);
  sink.end_section("Periodic");
}

}  // namespace

void put_msh4(OutputBuffer& out, const SimplexSoup& soup, bool binary, Lost& lost) {
  const Entities entities = msh_entities(soup);
  MshSink sink(out, binary);
  sink.header("4.1");
  sink.physical_names(soup);
  put_entities(sink, soup, entities);
  put_nodes(sink, soup, entities);
  put_elements(sink, soup, entities);
  put_periodic(sink, soup);
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
