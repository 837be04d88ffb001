// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/orientation.hpp"

#include <utility>

namespace multimesh::oracle {

namespace {

/// The orientation that a facet gives its side opposite to position i, relative to ascending vertices.
bool is_positive(const Facet& f, int dim, int i) {
  bool even = i % 2 == 0;
  for (int j = 0; j <= dim; ++j)
    for (int k = j + 1; k <= dim; ++k)
      if (j != i && k != i && f[static_cast<std::size_t>(j)] > f[static_cast<std::size_t>(k)]) even = !even;
  return even;
}

struct Side {
  std::size_t facet;
  int opposite;
};

}  // namespace

bool orient(Complex& c, const std::function<bool()>& mirror) {
  if (c.dim <= 1) return true;
  std::map<Simplex, std::vector<Side>> sides;
  const auto side = [&](std::size_t f, int i) {
    return minus(facet_simplex(c, f), simplex({c.facets[f][static_cast<std::size_t>(i)]}));
  };
  for (std::size_t f = 0; f < c.facets.size(); ++f)
    for (int i = 0; i <= c.dim; ++i) sides[side(f, i)].push_back({f, i});
  const auto turn = [&](std::size_t f) {
    std::swap(c.facets[f][0], c.facets[f][1]);
    for (auto& [s, uses] : sides)
      for (Side& use : uses)
        if (use.facet == f && use.opposite < 2) use.opposite = 1 - use.opposite;
  };
  std::vector<bool> seen(c.facets.size(), false);
  for (std::size_t start = 0; start < c.facets.size(); ++start) {
    if (seen[start]) continue;
    if (mirror && mirror()) turn(start);
    seen[start] = true;
    std::vector<std::size_t> queue{start};
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (int i = 0; i <= c.dim; ++i) {
        const auto uses = sides.at(side(queue[q], i));
        if (uses.size() != 2) continue;
        const Side other = uses[0].facet == queue[q] ? uses[1] : uses[0];
        const bool agrees = is_positive(c.facets[queue[q]], c.dim, i) !=
                            is_positive(c.facets[other.facet], c.dim, other.opposite);
        if (seen[other.facet] && !agrees) return false;
        if (seen[other.facet]) continue;
        if (!agrees) turn(other.facet);
        seen[other.facet] = true;
        queue.push_back(other.facet);
      }
  }
  return true;
}

}  // namespace multimesh::oracle
