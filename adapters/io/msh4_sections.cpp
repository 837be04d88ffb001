// SPDX-License-Identifier: BSD-3-Clause
// The sections of Gmsh's format 4.1.
#include <array>
#include <cstdlib>
#include <vector>

#include "adapters/io/msh_content.hpp"

namespace multimesh::io {
namespace {

int entity_dimension(MshSource& in) {
  const std::int32_t dimension = in.integer("the dimension of an entity");
  if (dimension < 0 || dimension > 3)
    in.fail("the dimension of an entity is " + std::to_string(dimension) + "; it must be 0 to 3");
  return dimension;
}

/// The sign is the orientation of the entity in the group, and not part of the tag.
std::int32_t physical_tag(std::int32_t signed_tag) {
  return signed_tag < -2147483647 ? signed_tag : std::abs(signed_tag);
}

/// Reads what follows the tag.
void read_entity(MshContent& content, int dimension, ReadEntity& entity) {
  MshSource& in = content.in;
  const int box = dimension == 0 ? 3 : 6;
  for (int i = 0; i < box; ++i) in.real("the bounding box of an entity");
  for (std::size_t n = in.count("physical tags", 1); n > 0; --n)
    entity.physicals.push_back(physical_tag(in.integer("a physical tag")));
  if (dimension == 0) return;
  for (std::size_t n = in.count("bounding entities", 1); n > 0; --n) in.integer("a bounding entity");
}

/// A part of an entity, which is called the parent.
void read_partitioned_entity(MshContent& content, int dimension) {
  MshSource& in = content.in;
  const std::int32_t tag = in.integer("the tag of an entity");
  const std::int32_t parent_dimension = in.integer("the dimension of a parent");
  const std::int32_t parent = in.integer("the tag of a parent");
  for (std::size_t n = in.count("partitions", 1); n > 0; --n) in.integer("a partition");
  ReadEntity entity;
  read_entity(content, dimension, entity);
  entity.tag = parent;
  entity.is_partition_border = parent_dimension > dimension;
  content.entities[{dimension, tag}] = entity;
}

std::array<std::size_t, 4> entity_counts(MshSource& in) {
  std::array<std::size_t, 4> counts{};
  for (std::size_t& count : counts) count = in.count("entities", 4);
  return counts;
}

/// The nodes of all blocks, in file order.
struct Nodes {
  std::vector<std::uint64_t> numbers, where;
  std::vector<std::array<double, 3>> points;
};

void read_node_block(MshContent& content, Nodes& nodes) {
  MshSource& in = content.in;
  const int dimension = entity_dimension(in);
  in.integer("the tag of an entity");
  const bool parametric = in.integer("whether nodes are parametric") != 0;
  const std::size_t count = in.count("nodes", 4);
  for (std::size_t i = 0; i < count; ++i) nodes.numbers.push_back(in.size("the number of a node"));
  while (nodes.points.size() < nodes.numbers.size()) {
    const std::uint64_t number = nodes.numbers[nodes.points.size()];
    for (double& x : nodes.points.emplace_back()) x = in.real("a coordinate");
    for (int i = 0; parametric && i < dimension; ++i) in.real("a parametric coordinate");
    nodes.where.push_back(in.where(number));
  }
}

void read_element_block(MshContent& content, std::vector<std::uint32_t>& nodes) {
  MshSource& in = content.in;
  const int dimension = entity_dimension(in);
  const std::int32_t entity = in.integer("the tag of an entity");
  const std::int32_t type_number = in.integer("the type of elements");
  const CellType& type = content.element_type(type_number, in.where(0));
  const std::size_t count = in.count("elements", 1 + std::size_t{type.nodes});
  const auto found = content.entities.find({dimension, entity});
  const ReadEntity known = found == content.entities.end() ? ReadEntity{entity, {}, false} : found->second;
  if (known.is_partition_border) content.border_elements += count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t number = in.size("the number of an element"), where = in.where(number);
    content.set_number(number);
    nodes.clear();
    for (int n = 0; n < type.nodes; ++n)
      nodes.push_back(content.point(in.size("the number of a node"), where));
    if (known.is_partition_border) continue;
    if (known.physicals.empty()) content.add_element(type, nodes, 0, known.tag, where);
    // Once for each group, as version 2.2 lists it.
    for (const std::int32_t physical : known.physicals)
      content.add_element(type, nodes, physical, known.tag, where);
  }
}

/// Reads the numbers at the beginning of $Nodes and $Elements. \return the number of blocks
std::size_t block_count(MshSource& in, std::string_view what) {
  in.begin_data();
  const std::size_t blocks = in.count("entity blocks", 4);
  in.count(what, 1);
  in.size("the least number");
  in.size("the largest number");
  return blocks;
}

}  // namespace

void read_msh4_entities(MshContent& content) {
  MshSource& in = content.in;
  in.begin_data();
  const std::array<std::size_t, 4> counts = entity_counts(in);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t n = counts[static_cast<std::size_t>(dimension)]; n > 0; --n) {
      const std::int32_t tag = in.integer("the tag of an entity");
      read_entity(content, dimension, content.entities[{dimension, tag}] = {tag, {}, false});
    }
}

void read_msh4_partitions(MshContent& content) {
  MshSource& in = content.in;
  in.begin_data();
  content.has_partitions = in.size("the number of partitions") > 0;
  for (std::size_t n = in.count("ghost entities", 2); n > 0; --n) {
    in.integer("the tag of a ghost entity");
    in.integer("a partition");
  }
  const std::array<std::size_t, 4> counts = entity_counts(in);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t n = counts[static_cast<std::size_t>(dimension)]; n > 0; --n)
      read_partitioned_entity(content, dimension);
}

void read_msh4_nodes(MshContent& content) {
  Nodes nodes;
  for (std::size_t n = block_count(content.in, "nodes"); n > 0; --n) read_node_block(content, nodes);
  content.add_points(nodes.numbers, nodes.points, nodes.where);
}

void read_msh4_elements(MshContent& content) {
  std::vector<std::uint32_t> nodes;
  for (std::size_t n = block_count(content.in, "elements"); n > 0; --n) read_element_block(content, nodes);
}

void read_msh4_periodic(MshContent& content) {
  MshSource& in = content.in;
  in.begin_data();
  for (std::size_t n = in.count("periodic links", 5); n > 0; --n) {
    SimplexSoup::Periodic link;
    link.dimension = entity_dimension(in);
    link.slave = in.integer("the tag of a periodic entity");
    link.master = in.integer("the tag of a master entity");
    for (std::size_t i = in.count("numbers of an affine map", 1); i > 0; --i)
      link.affine.push_back(in.real("an affine map"));
    if (!link.affine.empty() && link.affine.size() != 16) {
      content.out.left_out("an affine map of other than 16 numbers");
      link.affine.clear();
    }
    const std::size_t pairs = in.count("periodic nodes", 2);
    for (std::size_t i = 0; i < pairs; ++i) {
      std::array<std::uint32_t, 2> pair{};
      for (std::uint32_t& point : pair) {
        const std::uint64_t number = in.size("a periodic node");
        point = content.point(number, in.where(number));
      }
      link.points.push_back(pair);
    }
    content.out.soup().periodic.push_back(std::move(link));
  }
}

}  // namespace multimesh::io
