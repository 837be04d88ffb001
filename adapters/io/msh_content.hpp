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

/// A geometrical entity, or a part of one.
struct ReadEntity {
  std::int32_t tag = 0;                 ///< of the entity that it is, or is a part of
  std::vector<std::int32_t> physicals;  ///< tags of the groups that it is in
  bool is_partition_border = false;     ///< it is there only because the mesh is partitioned
};

/// What the sections of one Gmsh file have in common while they are read.
class MshContent {
 public:
  MshContent(MshSource& source, SimplexBuilder& builder) : in(source), out(builder) {}

  /// \throw InputError when there is a point of this number already.
  void add_point(std::uint64_t number, const std::array<double, 3>& point, std::uint64_t where);
  /// All points at once, of these numbers. Points whose numbers are 1 to n are sorted by them.
  /// \throw InputError as add_point
  void add_points(std::span<const std::uint64_t> numbers, std::span<const std::array<double, 3>> points,
                  std::span<const std::uint64_t> where);
  /// \throw InputError when there is none.
  std::uint32_t point(std::uint64_t number, std::uint64_t where) const;

  /// The type that the file calls so. \throw InputError when it is not known.
  const CellType& element_type(std::int64_t number, std::uint64_t where) const;
  /// An element with both kinds of tag; which one is kept is decided in finish().
  void add_element(const CellType& type, std::span<const std::uint32_t> nodes, std::int32_t physical,
                   std::int32_t entity, std::uint64_t where);
  /// The number of the element that is added next. Elements of one dimension are sorted by their numbers.
  void set_number(std::uint64_t number) { number_ = number; }

  /// At the end. Per dimension: where no physical tag is there, the tags of entities take their place.
  void finish();

  MshSource& in;
  SimplexBuilder& out;
  /// By dimension and tag, of version 4.
  std::map<std::pair<int, std::int32_t>, ReadEntity> entities;
  bool has_partitions = false;
  std::size_t border_elements = 0;  ///< between partitions, left out

 private:
  void choose_tags();
  void sort_elements();

  PointNumbers numbers_;
  std::array<std::vector<std::int32_t>, 4> entity_tags_;  // beside the builder's, which are physical
  std::vector<std::int32_t> polygon_entity_tags_;
  std::uint64_t number_ = 0;
  std::array<std::vector<std::uint64_t>, 4> numbers_of_;  // likewise
};

/// Sections of version 2.
void read_msh2_nodes(MshContent& content);
void read_msh2_parametric_nodes(MshContent& content);
void read_msh2_elements(MshContent& content);
void read_msh2_periodic(MshContent& content);

/// Sections of version 4.1.
void read_msh4_entities(MshContent& content);
void read_msh4_partitions(MshContent& content);
void read_msh4_nodes(MshContent& content);
void read_msh4_elements(MshContent& content);
void read_msh4_periodic(MshContent& content);

}  // namespace multimesh::io
