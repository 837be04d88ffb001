// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

namespace multimesh::test {

namespace {

class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i) { return parent_[i] == i ? i : parent_[i] = find(parent_[i]); }
  void join(Index i, Index j) { parent_[find(i)] = find(j); }

 private:
  std::vector<Index> parent_;
};

long count_sets(Sets& sets, const std::vector<bool>& used) {
  long n = 0;
  for (Index v = 0; v < used.size(); ++v) n += used[v] && sets.find(v) == v;
  return n;
}

}  // namespace

Topology topology(const Mesh& mesh) {
  const int d = mesh.dimension();
  const Index vertices = mesh.capacity(0);
  Sets all(vertices), rim(vertices);
  std::vector<bool> used(vertices, false), on_rim(vertices, false);
  std::vector<std::array<Index, 2>> sides;  // of triangles, with repetition
  std::vector<long> degree(vertices, 0);
  long facets = 0, vertex_count = 0;
  std::array<Index, 4> v{};
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    ++facets;
    mesh.vertices(mesh.dart_of(d, f), v.data());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i) {
      used[v[i]] = true;
      ++degree[v[i]];
      all.join(v[0], v[i]);
      const Index w = v[(i + 1) % 3];
      if (d == 2) sides.push_back({std::min(v[i], w), std::max(v[i], w)});
    }
  }
  Topology t;
  t.components = count_sets(all, used);
  vertex_count = std::count(used.begin(), used.end(), true);
  if (d == 1) {
    t.euler = vertex_count - facets;
    t.boundary = std::count(degree.begin(), degree.end(), 1);
    return t;
  }
  std::sort(sides.begin(), sides.end());
  long edges = 0;
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i; j < sides.size() && sides[j] == sides[i];) ++j;
    ++edges;
    if (j - i == 1) {
      rim.join(sides[i][0], sides[i][1]);
      on_rim[sides[i][0]] = on_rim[sides[i][1]] = true;
    }
  }
  t.euler = vertex_count - edges + facets;
  t.boundary = count_sets(rim, on_rim);
  return t;
}

}  // namespace multimesh::test
