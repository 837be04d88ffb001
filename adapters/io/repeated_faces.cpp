// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/repeated_faces.hpp"

#include <algorithm>

namespace multimesh::io {
namespace {

struct Key {
  std::uint64_t hash;
  std::uint32_t face;
  friend auto operator<=>(const Key&, const Key&) = default;
};

/// The same for all orders of the vertices.
std::uint64_t hash_of(std::span<const PolygonSoup::Corner> face) {
  std::uint64_t sum = face.size();
  for (const auto& corner : face) {
    std::uint64_t x = static_cast<std::uint64_t>(corner.v) + 1;
    x *= 0x9E3779B97F4A7C15U;
    sum += x ^ (x >> 29U);
  }
  return sum;
}

std::size_t least_vertex(std::span<const PolygonSoup::Corner> face) {
  return static_cast<std::size_t>(std::ranges::min(face, {}, &PolygonSoup::Corner::v).v);
}

std::vector<std::int32_t> sorted_vertices(std::span<const PolygonSoup::Corner> face) {
  std::vector<std::int32_t> vertices;
  for (const auto& corner : face) vertices.push_back(corner.v);
  std::ranges::sort(vertices);
  return vertices;
}

bool same_vertices(std::span<const PolygonSoup::Corner> a, std::span<const PolygonSoup::Corner> b) {
  constexpr std::size_t few = 8;
  if (a.size() > few) return a.size() == b.size() && sorted_vertices(a) == sorted_vertices(b);
  return std::ranges::is_permutation(a, b, {}, &PolygonSoup::Corner::v, &PolygonSoup::Corner::v);
}

/// The faces sorted into one bucket per least vertex: bucket v is [begin[v], begin[v+1]).
struct Buckets {
  std::vector<std::uint32_t> begin;
  std::vector<Key> keys;
};

Buckets sort_by_least_vertex(const PolygonSoup& soup) {
  Buckets buckets{std::vector<std::uint32_t>(soup.positions.size() + 2), {}};
  for (std::size_t f = 0; f < soup.face_count(); ++f)
    if (!soup.face(f).empty()) ++buckets.begin[least_vertex(soup.face(f)) + 2];
  for (std::size_t v = 2; v < buckets.begin.size(); ++v) buckets.begin[v] += buckets.begin[v - 1];
  buckets.keys.resize(buckets.begin.back());
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    if (soup.face(f).empty()) continue;
    std::uint32_t& at = buckets.begin[least_vertex(soup.face(f)) + 1];
    buckets.keys[at++] = {hash_of(soup.face(f)), static_cast<std::uint32_t>(f)};
  }
  return buckets;
}

}  // namespace

std::vector<RepeatedFace> repeated_faces(const PolygonSoup& soup) {
  Buckets buckets = sort_by_least_vertex(soup);
  std::vector<RepeatedFace> repeated;
  for (std::size_t v = 0; v + 1 < buckets.begin.size(); ++v) {
    const std::span bucket =
        std::span(buckets.keys).subspan(buckets.begin[v], buckets.begin[v + 1] - buckets.begin[v]);
    if (bucket.size() < 2) continue;
    std::ranges::sort(bucket);
    std::size_t first = 0;
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].hash == bucket[first].hash &&
          same_vertices(soup.face(bucket[i].face), soup.face(bucket[first].face)))
        repeated.push_back({bucket[i].face, bucket[first].face});
      else
        first = i;
    }
  }
  std::ranges::sort(repeated);
  return repeated;
}

}  // namespace multimesh::io
