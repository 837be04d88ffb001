// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/io/cell_shape.hpp"
#include "adapters/io/msh_source.hpp"
#include "adapters/io/point_numbers.hpp"
#include "adapters/io/simplex_builder.hpp"

namespace multimesh::io {

/// What the sections of one Gmsh file have in common while they are read.
class MshContent {
 public:
  MshContent(MshSource& source, SimplexBuilder& builder) : in(source), out(builder) {}

  /// \throw InputError when there is a point of this number already.
  void add_point(std::uint64_t number, const std::array<double, 3>& point);
  /// \throw InputError when there is none.
  std::uint32_t point(std::uint64_t number, std::uint64_t where) const;

  /// The type that the file calls so. \throw InputError when it is not known.
  const CellType& element_type(std::int64_t number, std::uint64_t where) const;
  /// An element with both kinds of tag; which one is kept is decided in finish().
  void add_element(const CellType& type, std::span<const std::uint32_t> nodes, std::int32_t physical,
                   std::int32_t entity, std::uint64_t where);

  /// Per dimension: where no physical tag is there, the tags of entities take their place.
  void choose_tags();

  MshSource& in;
  SimplexBuilder& out;
  /// First physical tag by (dimension, tag) of an entity, of version 4.
  std::map<std::pair<int, std::int32_t>, std::int32_t> physical_of_entity;

 private:
  PointNumbers numbers_;
  std::array<std::vector<std::int32_t>, 4> entity_tags_;  // beside the builder's, which are physical
  std::vector<std::int32_t> polygon_entity_tags_;
};

/// Sections of version 2.
void read_msh2_nodes(MshContent& content);
void read_msh2_elements(MshContent& content);
void read_msh2_periodic(MshContent& content);

/// Sections of version 4.1.
void read_msh4_entities(MshContent& content);
void read_msh4_nodes(MshContent& content);
void read_msh4_elements(MshContent& content);
void read_msh4_periodic(MshContent& content);

}  // namespace multimesh::io
