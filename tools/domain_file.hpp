// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/io/polygon_soup.hpp"
#include "adapters/io/simplex_soup.hpp"
#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/textured_triangles.hpp"

namespace multimesh::tools {

/// A file of tagged simplices, whatever their dimension.
struct DomainFile {
  std::filesystem::path path;
  io::SimplexSoup soup;
  std::vector<std::string> warnings;
};

/// Whether the extension is that of a format that holds surfaces only, perhaps with texture coordinates.
bool is_surface_format(const std::filesystem::path& path);

/// Points that no simplex names are left out, with a warning. \throw InputError as io::read_simplices does
DomainFile read_domain_file(const std::filesystem::path& path);

/// The tags of the simplices that are in these groups. \throw InputError naming `option`, the group, and the
/// groups there are, if there is none
std::vector<std::int32_t> tags_of_groups(const DomainFile& file, int dimension,
                                         const std::vector<std::int32_t>& groups, const std::string& option);

/// The same of patches that are given by tags or names.
std::vector<std::int32_t> tags_of_patches(const DomainFile& file, const std::vector<std::string>& patches,
                                          const std::string& option);

/// The tetrahedra and all that is listed inside them; points that are listed are fixed. The lists of the soup
/// are moved. \throw InputError if it has no tetrahedron
TaggedTetrahedra take_tetrahedra(DomainFile& file);
/// The triangles; the lists of the soup are copied.
TexturedTriangles triangles_of(const DomainFile& file);
/// The triangles and edges, copied; a group for each tag. \throw InputError if there are none or too many
io::PolygonSoup polygons_of(const DomainFile& file);

/// What was odd about the input, in sentences.
std::vector<std::string> warnings_of(const TetDomainReport& report);

struct DomainWriteOptions {
  bool ascii = false;
  bool msh_2 = false;
  /// By dimension: also what the input does not list, in a group of its own: points where sheets touch,
  /// curves, interfaces. It follows from the tags, but for sharp curves.
  std::array<bool, 3> unlisted{};
};

/// What the tags of a domain mean.
struct DomainGroups {
  std::vector<io::SimplexSoup::Group> groups;
  std::vector<io::SimplexSoup::TagSet> tag_sets;
};

/// Writes the domain with its groups. What the format has no room for is told in `warnings`.
/// \throw InputError
void write_domain(const std::filesystem::path& path, const TetDomain& domain, const DomainGroups& groups,
                  const DomainWriteOptions& options, std::vector<std::string>& warnings);

}  // namespace multimesh::tools
