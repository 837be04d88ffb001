// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/mesh.hpp"

#include <array>

namespace multimesh {

Permutation matching(const Index* from, const Index* to, int k) {
  int p[4] = {0, 1, 2, 3};
  for (int i = 0; i <= k; ++i) {
    int j = 0;
    while (j < k && from[j] != to[i]) ++j;
    p[i] = j;
  }
  return permutation(p[0], p[1], p[2], p[3]);
}

Dart dart_with(const Mesh& mesh, Index facet, const Index* vertices) {
  const int d = mesh.dimension();
  const Dart any = mesh.dart_of(d, facet);
  if (any == no_dart) return no_dart;
  std::array<Index, 4> have{};
  mesh.vertices(any, have.data());
  const Dart found = mesh.reorder(any, matching(have.data(), vertices, d));
  mesh.vertices(found, have.data());
  for (int i = 0; i <= d; ++i)
    if (have[static_cast<std::size_t>(i)] != vertices[i]) return no_dart;
  return found;
}

}  // namespace multimesh
