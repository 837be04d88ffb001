// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multimesh::io {

/// Bits of SimplexSoup::Block::flags.
enum SimplexFlag : std::uint8_t {
  feature_flag = 1,   ///< a vertex that is a corner, an edge that is a ridge (MEDIT: Corners, Ridges)
  required_flag = 2,  ///< must be kept as it is (MEDIT: RequiredVertices, RequiredEdges, …)
};

/// Contents of a file that the soup does not have, and things that looked wrong but were harmless; counts.
struct SimplexNotes {
  std::size_t high_order = 0;       ///< simplices of order two or more; their corners are kept
  std::size_t cut_polygons = 0;     ///< polygons of four or more corners, cut into triangles
  std::size_t repeated_vertex = 0;  ///< simplices that name a vertex twice, left out
  std::size_t left_out = 0;         ///< unknown sections, arrays and elements, left out
  std::size_t doubled = 0;          ///< simplices listed again with the same tag, left out
  std::size_t merged_points = 0;    ///< vertices of an STL file that were joined with an equal one
  std::size_t unused_points = 0;    ///< points that no simplex names, kept
  std::size_t entity_tags = 0;      ///< simplices tagged by their geometrical entity (MSH)
  friend bool operator==(const SimplexNotes&, const SimplexNotes&) = default;
};

/// Tagged simplices of dimension 0 to 3 over shared points, as a file stores them: no connectivity, any
/// topology, any orientation. All volume formats are read into this, and written from it.
struct SimplexSoup {
  /// The simplices of one dimension k.
  struct Block {
    std::vector<std::uint32_t> corners;  ///< \#S x (k+1) indices into points, one simplex after the other
    std::vector<std::int32_t> tags;      ///< \#S; 0 = none
    std::vector<std::uint8_t> flags;     ///< \#S of SimplexFlag bits; or empty = none has any
    std::size_t size() const { return tags.size(); }
    friend bool operator==(const Block&, const Block&) = default;
  };

  /// The name of the simplices of one dimension with one tag: a physical group, a part.
  struct Group {
    int dimension = 0;
    std::int32_t tag = 0;
    std::string name;
    std::string object{};  ///< of which it is part, where the file says so (OBJ, STL); not written
    friend bool operator==(const Group&, const Group&) = default;
  };

  /// A tag that stands for several groups at once: its simplices are in each of them.
  struct TagSet {
    int dimension = 0;
    std::int32_t tag = 0;
    std::vector<std::int32_t> groups;  ///< two or more tags, ascending
    friend bool operator==(const TagSet&, const TagSet&) = default;
  };

  /// Points of one geometrical entity that are copies of points of another ($Periodic of MSH).
  struct Periodic {
    int dimension = 0;                   ///< of the entities
    std::int32_t slave = 0, master = 0;  ///< tags of the entities; not those of Block::tags
    std::vector<double> affine;          ///< 4 x 4 by rows, master to slave; or empty = not given
    std::vector<std::array<std::uint32_t, 2>> points;  ///< (slave, master), indices into points
    friend bool operator==(const Periodic&, const Periodic&) = default;
  };

  std::vector<std::array<double, 3>> points;
  std::vector<std::int32_t> point_tags;  ///< #points references (MEDIT); or empty = none has any
  std::array<Block, 4> simplices;        ///< by dimension: vertices, edges, triangles, tetrahedra
  std::vector<Group> groups;
  std::vector<TagSet> tag_sets;  ///< with any other tag a simplex is only in the group of that tag
  std::vector<Periodic> periodic;

  SimplexNotes notes;
  std::vector<std::string> warnings;  ///< one sentence each, naming file and line or element

  /// The largest dimension of a simplex, -1 if there is none.
  int dimension() const {
    int k = 3;
    while (k >= 0 && simplices[static_cast<std::size_t>(k)].tags.empty()) --k;
    return k;
  }
};

}  // namespace multimesh::io
