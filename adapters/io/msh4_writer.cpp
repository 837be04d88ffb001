// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/input_location.hpp"
#include "adapters/io/msh_entities.hpp"
#include "adapters/io/msh_sink.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

using Entities = std::array<MshEntities, 4>;

void check_tags(const SimplexSoup& soup, const std::string& file) {
  for (const SimplexSoup::Block& block : soup.simplices)
    for (const std::int32_t tag : block.tags)
      if (tag < 0)
        fail_file(file,
                  "tag " + std::to_string(tag) +
                      " is negative, which version 4.1 of Gmsh's format takes for a reversed orientation; "
                      "write version 2.2, or renumber the tags");
}

void put_entity(MshSink& sink, std::size_t dimension, std::int32_t number, const MshEntity& entity) {
  sink.integer(number);
  for (const double x : entity.low) sink.real(x);
  if (dimension != 0)
    for (const double x : entity.high) sink.real(x);
  sink.size(entity.physical != 0 ? 1 : 0);  // physical tags
  if (entity.physical != 0) sink.integer(entity.physical);
  if (dimension != 0) sink.size(0);  // bounding entities
  sink.end_line();
}

void put_entities(MshSink& sink, const Entities& entities) {
  sink.text("$Entities\n");
  for (const MshEntities& e : entities) sink.size(e.by_number.size());
  sink.end_line();
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [number, entity] : entities[k].by_number) put_entity(sink, k, number, entity);
  sink.end_section("Entities");
}

/// All in one block, of the first simplex of the largest dimension: to which entity a point belongs is not
/// known.
void put_nodes(MshSink& sink, const SimplexSoup& soup, const Entities& entities) {
  const auto dimension = static_cast<std::size_t>(soup.dimension());
  const std::size_t count = soup.points.size();
  sink.text("$Nodes\n");
  for (const std::uint64_t value :
       {std::uint64_t{1}, std::uint64_t{count}, std::uint64_t{1}, std::uint64_t{count}})
    sink.size(value);
  sink.end_line();
  sink.integer(static_cast<std::int32_t>(dimension));
  sink.integer(entities[dimension].of_simplex.front());
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

/// Where the run of simplices of one entity that begins at `begin` ends. Runs are blocks, so that elements
/// keep their order.
std::size_t run_end(const std::vector<std::int32_t>& entity, std::size_t begin) {
  std::size_t end = begin;
  while (end < entity.size() && entity[end] == entity[begin]) ++end;
  return end;
}

std::size_t run_count(const std::vector<std::int32_t>& entity) {
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < entity.size(); begin = run_end(entity, begin)) ++count;
  return count;
}

void put_run(MshSink& sink, const SimplexSoup::Block& block, std::size_t dimension, std::int32_t entity,
             std::size_t begin, std::size_t end, std::uint64_t& number) {
  sink.integer(static_cast<std::int32_t>(dimension));
  sink.integer(entity);
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

void put_elements(MshSink& sink, const SimplexSoup& soup, const Entities& entities) {
  std::size_t blocks = 0, elements = 0;
  for (const MshEntities& e : entities) {
    blocks += run_count(e.of_simplex);
    elements += e.of_simplex.size();
  }
  sink.text("$Elements\n");
  for (const std::size_t value : {blocks, elements, std::size_t{1}, elements}) sink.size(value);
  sink.end_line();
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<std::int32_t>& entity = entities[k].of_simplex;
    for (std::size_t begin = 0, end = 0; begin < entity.size(); begin = end) {
      end = run_end(entity, begin);
      put_run(sink, soup.simplices[k], k, entity[begin], begin, end, number);
    }
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

void put_msh4(OutputBuffer& out, const SimplexSoup& soup, bool binary, const std::string& file, Lost& lost) {
  check_tags(soup, file);
  const Entities entities = msh_entities(soup);
  MshSink sink(out, binary);
  sink.header("4.1");
  sink.physical_names(soup);
  put_entities(sink, entities);
  put_nodes(sink, soup, entities);
  put_elements(sink, soup, entities);
  put_periodic(sink, soup);
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
