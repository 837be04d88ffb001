// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "multimesh/files/domain_file.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tools {

/// Tetrahedra of a surface, ready to be written.
struct FilledSurface {
  TaggedTetrahedra tets;
  files::DomainGroups groups;  ///< of regions and patches, and the file's of curves and points
};

/// Fills what the triangles of a file enclose; points within the tolerance, a length, are joined. Warnings
/// are added to those of the file. \throw InputError, naming the file
FilledSurface fill_surface(files::DomainFile& file, const tetgen::TetrahedralizeOptions& options,
                           double weld_tolerance = 0);

/// x,y,z. \throw InputError naming the option
tetgen::Point parse_point(const std::string& text, const std::string& option);

/// NAME:x,y,z. \throw InputError
tetgen::RegionSeed parse_region_seed(const std::string& text);

}  // namespace multimesh::tools
