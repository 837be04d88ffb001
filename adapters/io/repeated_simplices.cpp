// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/repeated_simplices.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "adapters/io/group_tags.hpp"

namespace multimesh::io {
namespace {

/// The simplices of one dimension by their points.
class SortedSimplices {
 public:
  SortedSimplices(const SimplexSoup::Block& block, std::size_t each, std::size_t points)
      : keys_(block.corners), each_(each), order_(block.size()), begin_(points + 1, 0) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      std::ranges::sort(std::span(keys_).subspan(each * i, each));
      ++begin_[keys_[each * i] + 1];
    }
    for (std::size_t v = 0; v < points; ++v) begin_[v + 1] += begin_[v];
    std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < block.size(); ++i) order_[end[keys_[each * i]]++] = i;
  }

  /// Calls `f` with each two or more simplices of the same points, their indices ascending.
  template <class F>
  void each_repeated(const F& f) {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      const auto bucket = std::span(order_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
      if (bucket.size() < 2) continue;
      std::ranges::stable_sort(bucket, [&](std::uint32_t a, std::uint32_t b) {
        return std::ranges::lexicographical_compare(key(a), key(b));
      });
      for (std::size_t first = 0, end = 0; first < bucket.size(); first = end) {
        while (end < bucket.size() && std::ranges::equal(key(bucket[end]), key(bucket[first]))) ++end;
        if (end - first > 1) f(bucket.subspan(first, end - first));
      }
    }
  }

 private:
  std::span<const std::uint32_t> key(std::uint32_t i) const {
    return std::span(keys_).subspan(each_ * i, each_);
  }

  std::vector<std::uint32_t> keys_;  // corners, ascending in each simplex
  std::size_t each_;
  std::vector<std::uint32_t> order_, begin_;  // by lowest point
};

/// All tags but 0, ascending, each once.
std::vector<std::int32_t> distinct_tags(const SimplexSoup::Block& block,
                                        std::span<const std::uint32_t> repeated) {
  std::vector<std::int32_t> tags;
  for (const std::uint32_t i : repeated)
    if (block.tags[i] != 0) tags.push_back(block.tags[i]);
  std::ranges::sort(tags);
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  return tags;
}

/// Tags by the simplex, of those that are in several groups.
using SeveralTags = std::map<std::uint32_t, std::vector<std::int32_t>>;

/// One tag for each set of tags, in the order of the simplices.
void add_tag_sets(SimplexSoup& soup, std::size_t k, const SeveralTags& several) {
  UnusedTags unused(soup);
  std::map<std::vector<std::int32_t>, std::int32_t> tag_of;
  for (const auto& [i, tags] : several) {
    const auto [entry, is_new] = tag_of.try_emplace(tags, 0);
    if (is_new) {
      entry->second = unused.next();
      soup.tag_sets.push_back({static_cast<int>(k), entry->second, tags});
    }
    soup.simplices[k].tags[i] = entry->second;
  }
}

}  // namespace

bool names_a_point_twice(std::span<const std::uint32_t> corners) {
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (std::ranges::find(corners.first(i), corners[i]) != corners.first(i).end()) return true;
  return false;
}

void remove_simplices(SimplexSoup::Block& block, const std::vector<bool>& removed) {
  const std::size_t each = block.size() == 0 ? 1 : block.corners.size() / block.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (removed[i]) continue;
    for (std::size_t c = 0; c < each; ++c) block.corners[each * kept + c] = block.corners[each * i + c];
    block.tags[kept] = block.tags[i];
    if (!block.flags.empty()) block.flags[kept] = block.flags[i];
    ++kept;
  }
  block.corners.resize(each * kept);
  block.tags.resize(kept);
  if (!block.flags.empty()) block.flags.resize(kept);
}

void unite_repeated_simplices(SimplexSoup& soup) {
  for (std::size_t k = 0; k < 4; ++k) {
    SimplexSoup::Block& block = soup.simplices[k];
    std::vector<bool> removed(block.size(), false);
    SeveralTags several;
    SortedSimplices sorted(block, k + 1, soup.points.size());
    sorted.each_repeated([&](std::span<const std::uint32_t> all) {
      std::vector<std::int32_t> tags = distinct_tags(block, all);
      soup.notes.doubled += all.size() - std::max<std::size_t>(1, tags.size());
      for (const std::uint32_t i : all.subspan(1)) {
        removed[i] = true;
        if (!block.flags.empty()) block.flags[all[0]] |= block.flags[i];
      }
      if (tags.size() == 1) block.tags[all[0]] = tags[0];
      if (tags.size() > 1) several.emplace(all[0], std::move(tags));
    });
    if (!several.empty()) add_tag_sets(soup, k, several);
    if (std::ranges::find(removed, true) != removed.end()) remove_simplices(block, removed);
  }
}

}  // namespace multimesh::io
