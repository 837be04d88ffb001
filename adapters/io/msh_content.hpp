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
  std::int32_t tag = 0;                 ///< of the entity that it is, or of which it is part
  std::vector<std::int32_t> physicals;  ///< tags of its groups
  bool is_partition_border = false;     ///< exists only because the mesh is partitioned
};

/// What the sections of one Gmsh file share while they are read.
class MshContent {
 public:
  MshContent(MshSource& source, SimplexBuilder& builder) : in(source), out(builder) {}

  /// \throw InputError when a point with this number exists already.
  void add_point(std::uint64_t number, const std::array<double, 3>& point, std::uint64_t where);
  /// Adds all points at once, with these numbers. Points whose numbers are 1 to n are sorted by them.
  /// \throw InputError as add_point
  void add_points(std::span<const std::uint64_t> numbers, std::span<const std::array<double, 3>> points,
                  std::span<const std::uint64_t> where);
  /// \throw InputError when there is no such point.
  std::uint32_t point(std::uint64_t number, std::uint64_t where) const;

  /// The type with this number in the file. \throw InputError when it is not known.
  const CellType& element_type(std::int64_t number, std::uint64_t where) const;
  /// Adds an element with both kinds of tag; finish() decides which one is kept.
  void add_element(const CellType& type, std::span<const std::uint32_t> nodes, std::int32_t physical,
                   std::int32_t entity, std::uint64_t where);
  /// The number of the next element. Elements of one dimension are sorted by their numbers.
  void set_number(std::uint64_t number) { number_ = number; }

  /// At the end. Per dimension: if there is no physical tag, the tags of entities are used instead.
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
  std::array<std::vector<std::int32_t>, 4> entity_tags_;  // in addition to the builder's, which are physical
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
