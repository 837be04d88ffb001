// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "adapters/io/input_location.hpp"
#include "adapters/io/msh_entities.hpp"
#include "adapters/io/msh_sink.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

/// Numbers of points and elements have 31 bits.
void check_sizes(const SimplexSoup& soup, const std::string& file) {
  std::size_t elements = 0;
  for (const SimplexSoup::Block& block : soup.simplices) elements += block.size();
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

/// In binary a block of one type, in text each on its line; `number` goes on over all dimensions.
void put_block(MshSink& sink, const SimplexSoup::Block& block, const std::vector<std::int32_t>& entities,
               std::size_t dimension, std::int32_t& number) {
  if (sink.binary() && block.size() != 0) {
    sink.integer(msh_types[dimension]);
    sink.integer(static_cast<std::int32_t>(block.size()));
    sink.integer(2);
  }
  for (std::size_t i = 0; i < block.size(); ++i) {
    sink.integer(++number);
    if (!sink.binary()) {
      sink.integer(msh_types[dimension]);
      sink.integer(2);
    }
    sink.integer(block.tags[i]);  // the physical tag
    sink.integer(entities[i]);
    for (std::size_t c = 0; c <= dimension; ++c)
      sink.integer(static_cast<std::int32_t>(block.corners[(dimension + 1) * i + c] + 1));
    sink.end_line();
  }
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

/// Text in binary files, too.
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
  check_sizes(soup, file);
  MshSink sink(out, binary);
  sink.header("2.2");
  sink.physical_names(soup);
  put_nodes(sink, soup);
  std::size_t elements = 0;
  for (const SimplexSoup::Block& block : soup.simplices) elements += block.size();
  sink.text("$Elements\n");
  sink.text_number(elements);
  sink.text("\n");
  std::int32_t number = 0;
  const std::array<MshEntities, 4> entities = msh_entities(soup);
  for (std::size_t k = 0; k < 4; ++k) put_block(sink, soup.simplices[k], entities[k].of_simplex, k, number);
  sink.end_section("Elements");
  put_periodic(sink, soup);
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
