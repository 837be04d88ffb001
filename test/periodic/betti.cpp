// SPDX-License-Identifier: BSD-3-Clause
// Ranks of the boundary matrices by reduction of columns from the left (as in persistent homology).
#include "test/periodic/betti.hpp"

#include <algorithm>
#include <map>

namespace multimesh::test {

namespace {

using Vertices = std::vector<Index>;
using Numbers = std::map<Vertices, int>;

std::vector<Numbers> faces_of(const Mesh& mesh) {
  const int d = mesh.dimension();
  std::vector<Numbers> all(static_cast<std::size_t>(d) + 1);
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    Vertices v(4);
    mesh.vertices(mesh.dart_of(d, f), v.data());
    v.resize(static_cast<std::size_t>(d) + 1);
    std::sort(v.begin(), v.end());
    for (unsigned chosen = 1; chosen < 1U << v.size(); ++chosen) {
      Vertices s;
      for (std::size_t i = 0; i < v.size(); ++i)
        if (chosen >> i & 1U) s.push_back(v[i]);
      all[s.size() - 1].try_emplace(s, 0);
    }
  }
  for (auto& numbers : all) {
    int n = 0;
    for (auto& entry : numbers) entry.second = n++;
  }
  return all;
}

long rank_of_boundary(const Numbers& simplices, const Numbers& faces) {
  std::vector<std::vector<int>> reduced(faces.size());  // by highest entry
  long rank = 0;
  std::vector<int> column, sum;
  for (const auto& entry : simplices) {
    column.clear();
    for (std::size_t i = 0; i < entry.first.size(); ++i) {
      Vertices face = entry.first;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
      column.push_back(faces.at(face));
    }
    std::sort(column.begin(), column.end());
    while (!column.empty() && !reduced[static_cast<std::size_t>(column.back())].empty()) {
      const auto& other = reduced[static_cast<std::size_t>(column.back())];
      sum.clear();
      std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                    std::back_inserter(sum));
      column.swap(sum);
    }
    if (column.empty()) continue;
    ++rank;
    reduced[static_cast<std::size_t>(column.back())] = column;
  }
  return rank;
}

}  // namespace

std::vector<long> betti(const Mesh& mesh) {
  const auto all = faces_of(mesh);
  std::vector<long> ranks{0};
  for (std::size_t k = 1; k < all.size(); ++k) ranks.push_back(rank_of_boundary(all[k], all[k - 1]));
  ranks.push_back(0);
  std::vector<long> b;
  for (std::size_t k = 0; k < all.size(); ++k)
    b.push_back(static_cast<long>(all[k].size()) - ranks[k] - ranks[k + 1]);
  return b;
}

}  // namespace multimesh::test
