// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "adapters/io/group_tags.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::files {

namespace {

using Tags = std::vector<std::int32_t>;
using Flags = std::vector<std::uint8_t>;

/// The simplices to be written. Tags and flags may be empty: none has any. \return those that the input does
/// not list
std::vector<std::size_t> add_block(io::SimplexSoup::Block& block, std::size_t k,
                                   const std::vector<Index>& corners, const Tags& tags, const Flags& flags,
                                   bool with_unlisted) {
  std::vector<std::size_t> unlisted;
  for (std::size_t i = 0; i < corners.size() / (k + 1); ++i) {
    const unsigned flag = flags.empty() ? 0U : flags[i];
    const bool is_listed = (flag & unlisted_simplex) == 0;
    if (!is_listed && !with_unlisted) continue;
    if (!is_listed) unlisted.push_back(block.size());
    for (std::size_t c = 0; c <= k; ++c) block.corners.push_back(corners[(k + 1) * i + c]);
    block.tags.push_back(tags.empty() ? 0 : tags[i]);
    block.flags.push_back(static_cast<std::uint8_t>(flag & (feature_simplex | required_simplex)));
  }
  return unlisted;
}

io::SimplexSoup to_soup(TaggedTetrahedra t, const DomainGroups& groups, const DomainWriteOptions& options) {
  io::SimplexSoup soup;
  soup.groups = groups.groups;
  soup.tag_sets = groups.tag_sets;
  soup.points = std::move(t.points);
  if (std::ranges::any_of(t.point_tags, [](auto tag) { return tag != 0; }))
    soup.point_tags = std::move(t.point_tags);
  t.regions.resize(t.tets.size());
  soup.simplices[3] = {std::move(t.tets.corners), std::move(t.regions), std::move(t.tet_flags)};
  auto& [points, edges, triangles, tets] = soup.simplices;
  const std::array<std::vector<std::size_t>, 3> unlisted = {
      add_block(points, 0, t.fixed, t.fixed_tags, t.fixed_flags, options.unlisted[0]),
      add_block(edges, 1, t.edges.corners, t.edge_tags, t.edge_flags, options.unlisted[1]),
      add_block(triangles, 2, t.triangles.corners, t.patches, t.triangle_flags, options.unlisted[2])};
  constexpr std::array<const char*, 3> names = {"fixed_points", "curves", "interfaces"};
  io::UnusedTags unused(soup);
  for (std::size_t k = 0; k < 3; ++k) {
    if (unlisted[k].empty()) continue;
    const std::int32_t tag = io::named_group(soup, static_cast<int>(k), names[k], unused);
    for (const std::size_t i : unlisted[k]) soup.simplices[k].tags[i] = tag;
  }
  return soup;
}

}  // namespace

std::vector<std::string> write_domain(const std::filesystem::path& path, TaggedTetrahedra lists,
                                      const DomainGroups& groups, const DomainWriteOptions& options) {
  return io::write_simplices(path, to_soup(std::move(lists), groups, options), options.format);
}

std::vector<std::string> write_domain(const std::filesystem::path& path, const TetDomain& domain,
                                      const DomainFile& file, const DomainWriteOptions& options) {
  return write_domain(path, domain.tagged(), file.groups(), options);
}

}  // namespace multimesh::files
