// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/group_tags.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "adapters/io/simplex_names.hpp"

namespace multimesh::io {

UnusedTags::UnusedTags(const SimplexSoup& soup) {
  const auto add = [&](std::int32_t tag) {
    if (tag > 0 && (used_.empty() || used_.back() != tag)) used_.push_back(tag);
  };
  for (const SimplexSoup::Block& block : soup.simplices)
    for (const std::int32_t tag : block.tags) add(tag);
  for (const SimplexSoup::Group& group : soup.groups) add(group.tag);
  for (const SimplexSoup::TagSet& set : soup.tag_sets) {
    add(set.tag);
    for (const std::int32_t tag : set.groups) add(tag);
  }
  std::ranges::sort(used_);
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  if (!used_.empty()) last_ = used_.back();
}

std::int32_t UnusedTags::next() {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (last_ == most) last_ = 0;  // there are gaps: 2^31 tags do not fit into memory
  while (std::ranges::binary_search(used_, static_cast<std::int32_t>(++last_))) {
  }
  return static_cast<std::int32_t>(last_);
}

std::vector<std::int32_t> groups_of(const SimplexSoup& soup, int dimension, std::int32_t tag) {
  for (const SimplexSoup::TagSet& set : soup.tag_sets)
    if (set.dimension == dimension && set.tag == tag) return set.groups;
  return {tag};
}

std::vector<std::int32_t> tags_with(const SimplexSoup& soup, int dimension, std::int32_t group) {
  std::vector<std::int32_t> tags = {group};
  for (const SimplexSoup::TagSet& set : soup.tag_sets)
    if (set.dimension == dimension && std::ranges::binary_search(set.groups, group)) tags.push_back(set.tag);
  return tags;
}

std::int32_t named_group(SimplexSoup& soup, int dimension, const std::string& name, UnusedTags& unused) {
  std::string own = name;
  for (int number = 2;; ++number) {
    const auto found = std::ranges::find(soup.groups, own, &SimplexSoup::Group::name);
    if (found == soup.groups.end()) break;
    if (found->dimension == dimension && own == name && found->tag > 0) return found->tag;
    own = name + "_" + std::to_string(number);
  }
  soup.groups.push_back({dimension, unused.next(), own});
  return soup.groups.back().tag;
}

namespace {

/// New tags for the negative ones of a dimension, in its simplices, groups and tag sets.
void renumber(SimplexSoup& soup, std::size_t k, const std::map<std::int32_t, std::int32_t>& renumbered) {
  const auto change = [&](std::int32_t& tag) {
    if (const auto found = renumbered.find(tag); found != renumbered.end()) tag = found->second;
  };
  for (std::int32_t& tag : soup.simplices[k].tags) change(tag);
  for (SimplexSoup::Group& group : soup.groups)
    if (group.dimension == static_cast<int>(k)) change(group.tag);
  for (SimplexSoup::TagSet& set : soup.tag_sets) {
    if (set.dimension != static_cast<int>(k)) continue;
    change(set.tag);
    for (std::int32_t& tag : set.groups) change(tag);
    std::ranges::sort(set.groups);
  }
}

/// The negative tags of a dimension, and the new ones.
std::map<std::int32_t, std::int32_t> negative_tags(const SimplexSoup& soup, std::size_t k,
                                                   UnusedTags& unused) {
  std::map<std::int32_t, std::int32_t> tags;
  for (const std::int32_t tag : soup.simplices[k].tags)
    if (tag < 0) tags.emplace(tag, 0);
  for (const SimplexSoup::TagSet& set : soup.tag_sets)
    for (const std::int32_t tag : set.groups)
      if (set.dimension == static_cast<int>(k) && tag < 0) tags.emplace(tag, 0);
  for (auto& [tag, replacement] : tags) replacement = unused.next();
  return tags;
}

}  // namespace

std::vector<std::string> make_tags_positive(SimplexSoup& soup) {
  std::vector<std::string> told;
  UnusedTags unused(soup);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto negative = negative_tags(soup, k, unused);
    if (!negative.empty()) renumber(soup, k, negative);
    for (const auto& [tag, replacement] : negative)
      told.push_back(std::string(simplex_plurals[k]) + " with tag " + std::to_string(tag) + " have tag " +
                     std::to_string(replacement) + " there, for Gmsh's tags must be positive");
    std::vector<std::int32_t>& tags = soup.simplices[k].tags;
    const auto untagged = std::ranges::count(tags, 0);
    if (untagged == 0) continue;
    const std::string name = std::string("untagged_") + simplex_plurals[k];
    const std::int32_t tag = named_group(soup, static_cast<int>(k), name, unused);
    std::ranges::replace(tags, 0, tag);
    told.push_back(std::to_string(untagged) + " " + simplex_plurals[k] + " without a tag have tag " +
                   std::to_string(tag) + " there, the group \"" + name + "\"");
  }
  return told;
}

}  // namespace multimesh::io
