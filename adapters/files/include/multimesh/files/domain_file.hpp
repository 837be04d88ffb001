// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/textured_triangles.hpp"
#include "multimesh/io/simplex_soup.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::files {

/// What the tags of a domain mean.
struct DomainGroups {
  std::vector<io::SimplexSoup::Group> groups;
  std::vector<io::SimplexSoup::TagSet> tag_sets;
};

/// A file of tagged simplices, whatever their dimension. Warnings name the options of the `multimesh`
/// program; the fields of DomainReadOptions have the same names.
struct DomainFile {
  std::filesystem::path path;
  io::SimplexSoup soup;
  std::vector<std::string> warnings;

  bool has_tetrahedra() const { return soup.simplices[3].size() > 0; }
  DomainGroups groups() const { return {soup.groups, soup.tag_sets}; }
};

struct DomainReadOptions {
  std::optional<double> weld = {};  ///< join points at most this far apart; 0: those at one place
  bool no_weld = false;             ///< do not tell of points at one place
  bool no_periodic = false;         ///< take a periodic mesh as any other; its links are dropped
  bool sides_stay = false;  ///< nothing will change points and triangles of the sides: do not warn of it
};

/// What the file lists. Points that no simplex names are left out, with a warning.
/// \throw InputError as io::read_simplices does, and for coordinates of a size that cannot be computed with
DomainFile read_simplices(const std::filesystem::path& path);

/// Welds points if asked for. Of points at one place, and of sides that look periodic, warnings tell.
/// \throw InputError for periodic links, which would be lost, without no_periodic; if nothing is left
void prepare(DomainFile& file, const DomainReadOptions& options);

/// Both.
DomainFile read_domain(const std::filesystem::path& path, const DomainReadOptions& options = {});

/// The tetrahedra and all that is listed inside them; points that are listed are fixed. The lists of the soup
/// are moved. \throw InputError if it has no tetrahedron
TaggedTetrahedra take_tetrahedra(DomainFile& file);
/// The tree of them. What was odd about the input goes to the warnings.
TetDomain take_domain(DomainFile& file, const TetDomainOptions& options = {});
/// The triangles; the lists of the soup are copied.
TexturedTriangles triangles_of(const DomainFile& file);

/// What was odd about the input, in sentences.
std::vector<std::string> warnings_of(const TetDomainReport& report);

/// The tags of the simplices that are in these groups. \throw InputError naming `option`, the group, and the
/// groups there are, if there is none
std::vector<std::int32_t> tags_of_groups(const DomainFile& file, int dimension,
                                         const std::vector<std::int32_t>& groups, const std::string& option);
/// The same of patches that are given by tags or names.
std::vector<std::int32_t> tags_of_patches(const DomainFile& file, const std::vector<std::string>& patches,
                                          const std::string& option);

/// Points at the place of another one. Cost: linear
std::size_t count_coincident(const io::SimplexSoup& soup);
/// Pairs of points that the file says are copies of one another on opposite sides.
std::size_t count_periodic_pairs(const io::SimplexSoup& soup);

struct DomainWriteOptions {
  io::SimplexWriteOptions format = {};
  /// By dimension: also what the input does not list, in a group of its own: points where sheets touch,
  /// curves, interfaces. It follows from the tags, but for sharp curves.
  std::array<bool, 3> unlisted{};
};

/// Writes what TetDomain::tagged() gives, with its groups. \return sentences on what the format has no room
/// for. \throw InputError
std::vector<std::string> write_domain(const std::filesystem::path& path, TaggedTetrahedra lists,
                                      const DomainGroups& groups, const DomainWriteOptions& options = {});
/// The domain as it is now, with the groups of the file that it came from.
std::vector<std::string> write_domain(const std::filesystem::path& path, const TetDomain& domain,
                                      const DomainFile& file, const DomainWriteOptions& options = {});

}  // namespace multimesh::files
