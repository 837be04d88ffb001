// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// What the input calls its triangles.
struct TriangleNames {
  struct Part {
    std::string name;      ///< empty: none
    std::string object{};  ///< a larger one that it belongs to; empty: none
  };
  std::vector<std::int32_t> tags;      ///< per triangle; 0: none
  std::map<std::int32_t, Part> parts;  ///< of tags that have a name
  bool name_regions = true;            ///< regions may have these names, too
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

/// Regions are numbered from 1; a seed whose name is a positive number gives that. A region has the name of
/// its seed, or else that of the part or object whose triangles enclose it: all triangles at it have this
/// name, but for those that are listed for a neighbour only. A second region with the same name gets
/// NAME.2, and so on.
///
/// A patch is what has the same tags in the input and lies between the same two regions. It keeps its tag
/// and name where it is all that has the tag; others get new tags, the names of all their parts (A+B), and
/// those of their two regions (A:REGION|outside) where a part is at several pairs of regions.
Naming name_parts(const Tetrahedralization& mesh, const TriangleNames& names);

}  // namespace multimesh::tetgen
