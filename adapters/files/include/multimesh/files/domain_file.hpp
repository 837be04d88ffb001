// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/textured_triangles.hpp"
#include "multimesh/error.hpp"
#include "multimesh/io/simplex_soup.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::files {

/// The meaning of a domain's tags.
struct DomainGroups {
  std::vector<io::SimplexSoup::Group> groups;
  std::vector<io::SimplexSoup::TagSet> tag_sets;
};

/// A file of tagged simplices of any dimension. Warnings name the options of the `multimesh` program; the
/// fields of DomainReadOptions have the same names.
struct DomainFile {
  std::filesystem::path path;
  io::SimplexSoup soup;
  std::vector<std::string> warnings;

  bool has_tetrahedra() const { return soup.simplices[3].size() > 0; }
  DomainGroups groups() const { return {soup.groups, soup.tag_sets}; }
};

struct DomainReadOptions {
  std::optional<double> weld = {};  ///< join points at most this far apart; 0: those at one place
  bool no_weld = false;             ///< do not warn of points at one place
  bool no_periodic = false;         ///< treat a periodic mesh as any other; its links are dropped
  bool sides_stay = false;          ///< points and triangles of the sides will not change: no warning
};

/// The file declares its mesh periodic, and the reader would lose that.
class PeriodicMeshError : public InputError {
 public:
  using InputError::InputError;
};

/// Reads what the file lists. Points that no simplex names are left out, with a warning. \throw InputError
/// as io::read_simplices, and for coordinates too large or small to compute with
DomainFile read_simplices(const std::filesystem::path& path);

/// Welds points if requested. Warns of points at one place, and of sides that look periodic.
/// \throw PeriodicMeshError for periodic links, which would be lost, without no_periodic; InputError if
/// nothing is left
void prepare(DomainFile& file, const DomainReadOptions& options);

/// read_simplices(), then prepare().
DomainFile read_domain(const std::filesystem::path& path, const DomainReadOptions& options = {});

/// Takes the tetrahedra and everything listed inside them; listed points are fixed. The lists of the soup are
/// moved. \throw InputError if it has no tetrahedron
TaggedTetrahedra take_tetrahedra(DomainFile& file);
/// Builds the tree from them. Adds warnings about the input.
TetDomain take_domain(DomainFile& file, const TetDomainOptions& options = {});
/// The triangles; the lists of the soup are copied.
TexturedTriangles triangles_of(const DomainFile& file);

/// What was unusual about the input, in sentences.
std::vector<std::string> warnings_of(const TetDomainReport& report);

/// The tags of the simplices in these groups. \throw InputError naming `option`, the group, and the existing
/// groups, if a group does not exist
std::vector<std::int32_t> tags_of_groups(const DomainFile& file, int dimension,
                                         const std::vector<std::int32_t>& groups, const std::string& option);
/// The same for patches that are given by tags or names.
std::vector<std::int32_t> tags_of_patches(const DomainFile& file, const std::vector<std::string>& patches,
                                          const std::string& option);

/// The number of points at the place of another one. Cost: linear
std::size_t count_coincident(const io::SimplexSoup& soup);
/// The number of pairs of points that the file declares copies of one another on opposite sides.
std::size_t count_periodic_pairs(const io::SimplexSoup& soup);

struct DomainWriteOptions {
  io::SimplexWriteOptions format = {};
  /// By dimension: also write what the input does not list (points where sheets touch, curves, interfaces),
  /// in a group of its own. Except for sharp curves, it follows from the tags.
  std::array<bool, 3> unlisted{};
};

/// Writes the lists of TetDomain::tagged(), with their groups. \return sentences on what the format cannot
/// store. \throw InputError
std::vector<std::string> write_domain(const std::filesystem::path& path, TaggedTetrahedra lists,
                                      const DomainGroups& groups, const DomainWriteOptions& options = {});
/// Writes the current domain, with the groups of its original file.
std::vector<std::string> write_domain(const std::filesystem::path& path, const TetDomain& domain,
                                      const DomainFile& file, const DomainWriteOptions& options = {});

}  // namespace multimesh::files
