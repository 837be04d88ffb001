// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <set>

#include "adapters/io/group_tags.hpp"
#include "multimesh/error.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::files {

std::vector<std::int32_t> tags_of_groups(const DomainFile& file, int dimension,
                                         const std::vector<std::int32_t>& groups, const std::string& option) {
  const auto& tags = file.soup.simplices[static_cast<std::size_t>(dimension)].tags;
  const std::set<std::int32_t> present(tags.begin(), tags.end());
  std::set<std::int32_t> known;
  for (const std::int32_t tag : present)
    for (const std::int32_t group : io::groups_of(file.soup, dimension, tag)) known.insert(group);
  std::vector<std::int32_t> found;
  for (const std::int32_t group : groups) {
    if (!known.contains(group)) {
      std::string list;
      for (const std::int32_t k : known) list.append(list.empty() ? "" : ", ").append(std::to_string(k));
      throw InputError(option + " " + std::to_string(group) + ": " + file.path.string() +
                       " has no such tag; it has " + list);
    }
    for (const std::int32_t tag : io::tags_with(file.soup, dimension, group))
      if (present.contains(tag)) found.push_back(tag);
  }
  return found;
}

std::vector<std::int32_t> tags_of_patches(const DomainFile& file, const std::vector<std::string>& patches,
                                          const std::string& option) {
  const auto group_of = [&](const std::string& patch) {
    for (const io::SimplexSoup::Group& g : file.soup.groups)
      if (g.dimension == 2 && g.name == patch) return static_cast<std::int32_t>(g.tag);
    std::int32_t tag{};
    const auto [end, error] = std::from_chars(patch.data(), patch.data() + patch.size(), tag);
    if (error == std::errc() && end == patch.data() + patch.size()) return tag;
    throw InputError(file.path.string() + ": " + option + " " + patch + ": no patch has this name");
  };
  std::vector<std::int32_t> groups;
  for (const std::string& patch : patches) groups.push_back(group_of(patch));
  return tags_of_groups(file, 2, groups, option);
}

}  // namespace multimesh::files
