// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// The names of triangles in the input.
struct TriangleNames {
  struct Part {
    std::string name;      ///< empty: none
    std::string object{};  ///< a larger part to which it belongs; empty: none
  };
  std::vector<std::int32_t> tags;      ///< per triangle; 0: none
  std::map<std::int32_t, Part> parts;  ///< of tags that have a name
  bool name_regions = true;            ///< regions may also have these names
};

/// Numbers and names of what triangles bound, and of the parts of the surface.
struct Naming {
  struct Tag {
    std::int32_t tag = 0;
    std::string name;  ///< empty: none
  };
  std::vector<Tag> regions;             ///< per region
  std::vector<Tag> patches;             ///< by ascending tag
  std::vector<std::int32_t> face_tags;  ///< per face of the result
  std::vector<std::string> warnings;    ///< one sentence each
};

/// Regions are numbered from 1; a seed whose name is a positive number sets that number. A region has the
/// name of its seed, or else that of the part or object whose triangles enclose it: all triangles at it have
/// this name, except those listed only for a neighbour. A second region with the same name gets NAME.2, and
/// so on.
///
/// A patch is the set of faces with the same tags in the input and between the same two regions. It keeps its
/// tag and name if no other patch has the tag. Others get new tags, the names of all their parts (A+B), and
/// those of their two regions (A:REGION|outside) where a part is at several pairs of regions.
Naming name_parts(const Tetrahedralization& mesh, const TriangleNames& names);

}  // namespace multimesh::tetgen
