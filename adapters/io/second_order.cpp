// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/second_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "adapters/io/input_location.hpp"

namespace multimesh::io {

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// The edges of a tetrahedron in the order of Gmsh's nodes 5 to 10. Those of a triangle and of an edge are
/// the first ones.
constexpr std::array<std::array<std::uint8_t, 2>, 6> edges_in_order = {
    {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}};

Edge edge_between(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

template <class Visit>
void for_each_edge(const std::uint32_t* corners, std::size_t dimension, const Visit& visit) {
  for (std::size_t e = 0; e < dimension * (dimension + 1) / 2; ++e)
    visit(edge_between(corners[edges_in_order[e][0]], corners[edges_in_order[e][1]]));
}

/// The numbers of the points in the middles of edges.
class Middles {
 public:
  explicit Middles(const SimplexSoup& soup) : edges_(edges_with_middles(soup)), first_(soup.points.size()) {}

  const std::vector<Edge>& edges() const { return edges_; }
  std::optional<std::uint32_t> find(const Edge& edge) const {
    const auto at = std::ranges::lower_bound(edges_, edge);
    if (at == edges_.end() || *at != edge) return std::nullopt;
    return static_cast<std::uint32_t>(first_ + static_cast<std::size_t>(at - edges_.begin()));
  }
  /// Those with this lower end.
  auto from(std::uint32_t a) const {
    return std::ranges::equal_range(edges_, a, {}, [](const Edge& e) { return e[0]; });
  }

 private:
  std::vector<Edge> edges_;
  std::size_t first_;
};

void put_nodes(SimplexSoup::Block& block, std::size_t dimension, const Middles& middles) {
  std::vector<std::uint32_t> nodes;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const std::uint32_t* corners = &block.corners[(dimension + 1) * i];
    nodes.insert(nodes.end(), corners, corners + dimension + 1);
    for_each_edge(corners, dimension, [&](const Edge& e) { nodes.push_back(*middles.find(e)); });
  }
  block.corners = std::move(nodes);
}

void link_middles(SimplexSoup::Periodic& link, const Middles& middles) {
  std::vector<Edge> masters = link.points;  // of slaves, ascending
  std::ranges::sort(masters);
  const auto master_of = [&](std::uint32_t slave) -> std::optional<std::uint32_t> {
    const auto at = std::ranges::lower_bound(masters, slave, {}, [](const Edge& pair) { return pair[0]; });
    return at == masters.end() || (*at)[0] != slave ? std::nullopt : std::optional((*at)[1]);
  };
  for (const auto& [a, master] : masters)
    for (const Edge& edge : middles.from(a)) {
      const auto other = master_of(edge[1]);
      const auto copy = other ? middles.find(edge_between(master, *other)) : std::nullopt;
      if (copy) link.points.push_back({*middles.find(edge), *copy});
    }
}

}  // namespace

std::vector<Edge> edges_with_middles(const SimplexSoup& soup) {
  std::vector<Edge> edges;
  for (std::size_t k = 1; k < 4; ++k)
    for (std::size_t i = 0; i < soup.simplices[k].size(); ++i)
      for_each_edge(&soup.simplices[k].corners[(k + 1) * i], k, [&](const Edge& e) { edges.push_back(e); });
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

SimplexSoup second_order(const SimplexSoup& soup, const std::string& file) {
  const Middles middles(soup);
  if (soup.points.size() + middles.edges().size() > std::numeric_limits<std::uint32_t>::max())
    fail_file(file, "the mesh has too many points for second order; write it without --order 2");
  SimplexSoup out = soup;
  for (const auto& [a, b] : middles.edges()) {
    auto& p = out.points.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) p[i] = std::midpoint(soup.points[a][i], soup.points[b][i]);
  }
  if (!out.point_tags.empty()) out.point_tags.resize(out.points.size());
  for (std::size_t k = 1; k < 4; ++k) put_nodes(out.simplices[k], k, middles);
  for (SimplexSoup::Periodic& link : out.periodic) link_middles(link, middles);
  return out;
}

}  // namespace multimesh::io
