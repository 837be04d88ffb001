// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/oriented_parts.hpp"

#include "multimesh/union_find.hpp"

namespace multimesh {

std::vector<Index> parts_of(const FacetList& facets) {
  UnionFind vertices(facets.vertices);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const Index v : facets.facet(f)) vertices.join(facets.facet(f)[0], v);
  std::vector<Index> part(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) part[f] = vertices.find(facets.facet(f)[0]);
  return part;
}

std::vector<bool> in_negative_part(const std::vector<Index>& part, const std::vector<double>& sizes) {
  std::vector<double> sum;
  for (std::size_t f = 0; f < part.size(); ++f) {
    if (part[f] >= sum.size()) sum.resize(part[f] + std::size_t{1}, 0);
    sum[part[f]] += sizes[f];
  }
  std::vector<bool> negative(part.size());
  for (std::size_t f = 0; f < part.size(); ++f) negative[f] = sum[part[f]] < 0;
  return negative;
}

}  // namespace multimesh
