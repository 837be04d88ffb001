// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/msh_entities.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "adapters/io/second_order.hpp"

namespace multimesh::io {

void MshEntity::add(const std::array<double, 3>& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = is_empty ? p[i] : std::min(low[i], p[i]);
    high[i] = is_empty ? p[i] : std::max(high[i], p[i]);
  }
  is_empty = false;
}

namespace {

/// The periodic entities of one dimension by their numbers, and the entities that contain each point.
class PeriodicEntities {
 public:
  PeriodicEntities(const SimplexSoup& soup, int dimension) {
    for (const SimplexSoup::Periodic& link : soup.periodic) {
      if (link.dimension != dimension) continue;
      for (const std::int32_t number : {link.slave, link.master}) points_[number];
      for (const auto& [slave, master] : link.points) {
        points_[link.slave].push_back(slave);
        points_[link.master].push_back(master);
      }
    }
    if (!points_.empty()) of_point_.resize(soup.points.size());
    for (auto& [number, points] : points_) {
      std::ranges::sort(points);
      points.erase(std::unique(points.begin(), points.end()), points.end());
      for (const std::uint32_t p : points) of_point_[p].push_back(number);
    }
  }

  const std::map<std::int32_t, std::vector<std::uint32_t>>& points() const { return points_; }

  /// The first entity that contains all nodes. \return whether there is one
  bool find(std::span<const std::uint32_t> nodes, std::int32_t& number) const {
    if (of_point_.empty()) return false;
    for (const std::int32_t candidate : of_point_[nodes[0]]) {
      const bool everywhere = std::ranges::all_of(
          nodes, [&](std::uint32_t p) { return std::ranges::binary_search(of_point_[p], candidate); });
      if (everywhere) return number = candidate, true;
    }
    return false;
  }

 private:
  std::map<std::int32_t, std::vector<std::uint32_t>> points_;
  std::vector<std::vector<std::int32_t>> of_point_;  // ascending
};

/// The number of the entity for simplices with a tag, in a periodic entity or in none.
class EntityNumbers {
 public:
  EntityNumbers(const SimplexSoup::Block& block, const PeriodicEntities& periodic) : periodic_(periodic) {
    if (periodic.points().empty()) return;
    used_.insert(block.tags.begin(), block.tags.end());
    for (const auto& [number, points] : periodic.points()) used_.insert(number);
  }

  std::int32_t in_periodic(std::int32_t number, std::int32_t tag) {
    const bool is_first = first_tag_.try_emplace(number, tag).first->second == tag;
    return is_first ? number : other({number, tag});
  }
  std::int32_t of_tag(std::int32_t tag) {
    return periodic_.points().contains(tag) ? other({std::nullopt, tag}) : tag;
  }

 private:
  using Key = std::pair<std::optional<std::int32_t>, std::int32_t>;

  std::int32_t other(const Key& key) {
    const auto [entry, is_new] = others_.try_emplace(key, 0);
    if (is_new) {
      while (!used_.insert(next_).second) ++next_;
      entry->second = next_;
    }
    return entry->second;
  }

  const PeriodicEntities& periodic_;
  std::map<std::int32_t, std::int32_t> first_tag_;  // by the number of the periodic entity
  std::map<Key, std::int32_t> others_;
  std::set<std::int32_t> used_;
  std::int32_t next_ = 1;
};

MshEntities entities_of(const SimplexSoup& soup, std::size_t k) {
  const SimplexSoup::Block& block = soup.simplices[k];
  const PeriodicEntities periodic(soup, static_cast<int>(k));
  EntityNumbers numbers(block, periodic);
  MshEntities entities;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const auto nodes = nodes_of(block, i);
    std::int32_t number = 0;
    number = periodic.find(nodes, number) ? numbers.in_periodic(number, block.tags[i])
                                          : numbers.of_tag(block.tags[i]);
    entities.of_simplex.push_back(number);
    MshEntity& entity = entities.by_number[number];
    entity.physical = block.tags[i];
    for (const std::uint32_t p : nodes) entity.add(soup.points[p]);
  }
  for (const auto& [number, points] : periodic.points())  // also those without simplices
    for (const std::uint32_t p : points) entities.by_number[number].add(soup.points[p]);
  return entities;
}

}  // namespace

std::array<MshEntities, 4> msh_entities(const SimplexSoup& soup) {
  return {entities_of(soup, 0), entities_of(soup, 1), entities_of(soup, 2), entities_of(soup, 3)};
}

}  // namespace multimesh::io
