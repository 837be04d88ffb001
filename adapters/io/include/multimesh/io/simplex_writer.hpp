// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

enum class MshVersion { v2_2, v4_1 };

struct SimplexWriteOptions {
  /// For .msh files.
  MshVersion msh_version = MshVersion::v4_1;
  /// Binary form for .msh, .vtu, .stl and .ply; the other formats are always text.
  bool binary = true;
  /// 2: also a node in the middle of each edge (.msh, .vtu): elements of 3, 6 and 10 nodes. Their sides are
  /// straight. These nodes come after the points.
  int order = 1;
};

/// Writes a soup in the format that the extension names:
///
/// | extension | dimensions | tags | names | numbers |
/// |---|---|---|---|---|
/// | .msh (Gmsh 2.2, 4.1) | 0 to 3 | positive; others get new ones, named groups | yes | double |
/// | .mesh (MEDIT) | 0 to 3 | yes, with point_tags and flags | no | double, text |
/// | .vtu (VTK) | 0 to 3 | yes, cell array `tag` | no | double, zlib if binary |
/// | .obj | 1, 2 | no | no | double, text |
/// | .off | 2 | no | no | double, text |
/// | .ply | 2 | no | no | double |
/// | .stl | 2 | no | no | float if binary, double as text; points are not shared |
///
/// Text has the fewest digits that reproduce the same double. Vertices in MEDIT are written as Corners, or as
/// RequiredVertices if they have only that flag, and pass their tags to their points. Points and simplices
/// keep their order; in 4.1 their order by number, because they are grouped by entity there, one per tag. A
/// simplex in several groups (SimplexSoup::TagSet) stays so in .msh files: 2.2 lists it once per group, in
/// 4.1 its entity has them all. Periodic links are written to .msh ($Periodic), with the entities that they
/// name (MshEntities); in second order with the nodes in the middle of linked edges. A warning reports
/// everything that is not written. The file appears complete or not at all (AtomicFile). \return warnings,
/// one sentence each, naming the file \throw InputError as check_simplex_output, and for no simplex that the
/// format can store, coordinates or tags that it cannot store, a directory, a missing directory, a full disk.
/// UsageError for a soup whose arrays are inconsistent.
std::vector<std::string> write_simplices(const std::filesystem::path& path, const SimplexSoup& soup,
                                         const SimplexWriteOptions& options = {});

/// \throw InputError for an unknown extension, or second order in a format that is not written in it
void check_simplex_output(const std::filesystem::path& path, const SimplexWriteOptions& options = {});

}  // namespace multimesh::io
