// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/topology.hpp"

#include <algorithm>
#include <array>
#include <bit>
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

using Key = std::array<Index, 3>;  // vertices ascending, no_index last

/// The faces of k+1 vertices of all facets, sorted, with repetition.
std::vector<Key> faces(const std::vector<std::array<Index, 4>>& facets, int d, int k) {
  std::vector<Key> all;
  for (const auto& f : facets)
    for (unsigned chosen = 0; chosen < (1U << (d + 1)); ++chosen) {
      if (std::popcount(chosen) != k + 1) continue;
      Key key{no_index, no_index, no_index};
      std::size_t n = 0;
      for (std::size_t i = 0; i < 4; ++i)
        if (chosen >> i & 1U) key[n++] = f[i];
      std::sort(key.begin(), key.end());
      all.push_back(key);
    }
  std::sort(all.begin(), all.end());
  return all;
}

long count_different(std::vector<Key> list) {
  return std::unique(list.begin(), list.end()) - list.begin();
}

/// Those that occur once.
std::vector<Key> single(const std::vector<Key>& list) {
  std::vector<Key> once;
  for (std::size_t i = 0, j; i < list.size(); i = j) {
    for (j = i; j < list.size() && list[j] == list[i];) ++j;
    if (j - i == 1) once.push_back(list[i]);
  }
  return once;
}

}  // namespace

Topology topology(const Mesh& mesh) {
  const int d = mesh.dimension();
  const Index vertices = mesh.capacity(0);
  std::vector<std::array<Index, 4>> facets;
  Sets all(vertices), rim(vertices);
  std::vector<bool> used(vertices, false), on_rim(vertices, false);
  for (Index f = 0; f < mesh.capacity(d); ++f) {
    if (!mesh.is_live(d, f)) continue;
    auto& v = facets.emplace_back();
    mesh.vertices(mesh.dart_of(d, f), v.data());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(d); ++i) {
      used[v[i]] = true;
      all.join(v[0], v[i]);
    }
  }
  const std::vector<Key> boundary = d == 0 ? std::vector<Key>{} : single(faces(facets, d, d - 1));
  std::vector<std::array<Index, 4>> sides;
  for (const Key& side : boundary) {
    sides.push_back({side[0], side[1], side[2], no_index});
    for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
      on_rim[side[i]] = true;
      rim.join(side[0], side[i]);
    }
  }
  Topology t;
  t.components = count_sets(all, used);
  t.euler = std::count(used.begin(), used.end(), true);
  for (int k = 1; k < d; ++k) t.euler += (k % 2 ? -1 : 1) * count_different(faces(facets, d, k));
  if (d > 0) t.euler += (d % 2 ? -1 : 1) * static_cast<long>(facets.size());
  t.boundary = count_sets(rim, on_rim);
  if (d == 3)
    t.boundary_euler = std::count(on_rim.begin(), on_rim.end(), true) - count_different(faces(sides, 2, 1)) +
                       static_cast<long>(sides.size());
  return t;
}

}  // namespace multimesh::test
