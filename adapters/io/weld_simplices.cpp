// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/weld_simplices.hpp"

#include <algorithm>
#include <span>

#include "adapters/io/repeated_simplices.hpp"
#include "adapters/io/used_points.hpp"
#include "adapters/io/weld.hpp"

namespace multimesh::io {
namespace {

std::size_t remove_collapsed(SimplexSoup& soup) {
  std::size_t count = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    SimplexSoup::Block& block = soup.simplices[k];
    std::vector<bool> removed(block.size());
    for (std::size_t i = 0; i < block.size(); ++i)
      removed[i] = names_a_point_twice(std::span(block.corners).subspan((k + 1) * i, k + 1));
    const auto collapsed = static_cast<std::size_t>(std::ranges::count(removed, true));
    if (collapsed != 0) remove_simplices(block, removed);
    count += collapsed;
  }
  return count;
}

}  // namespace

WeldReport weld_points(SimplexSoup& soup, double tolerance) {
  const std::vector<std::uint32_t> joins = coincident_points(soup.points, tolerance);
  WeldReport report;
  for (std::uint32_t i = 0; i < joins.size(); ++i) {
    if (joins[i] == i) continue;
    ++report.points;
    if (!soup.point_tags.empty() && soup.point_tags[joins[i]] == 0)
      soup.point_tags[joins[i]] = soup.point_tags[i];
  }
  if (report.points == 0) return report;
  for (SimplexSoup::Block& block : soup.simplices)
    for (std::uint32_t& v : block.corners) v = joins[v];
  for (SimplexSoup::Periodic& link : soup.periodic)
    for (auto& [slave, master] : link.points) slave = joins[slave], master = joins[master];
  report.collapsed = remove_collapsed(soup);
  const std::size_t doubled = soup.notes.doubled;
  unite_repeated_simplices(soup);
  report.doubled = soup.notes.doubled - doubled;
  remove_unused_points(soup);
  return report;
}

}  // namespace multimesh::io
