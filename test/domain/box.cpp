// SPDX-License-Identifier: BSD-3-Clause
#include "test/domain/box.hpp"

#include <algorithm>

namespace multimesh::test {

TaggedTetrahedra box(Index nx, Index ny, Index nz,
                     const std::function<TaggedTetrahedra::Tag(Index, Index, Index)>& region) {
  TaggedTetrahedra t;
  for (Index z = 0; z <= nz; ++z)
    for (Index y = 0; y <= ny; ++y)
      for (Index x = 0; x <= nx; ++x) t.points.push_back({double(x), double(y), double(z)});
  constexpr Index paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const Index step[3] = {1, nx + 1, (nx + 1) * (ny + 1)};
  for (Index z = 0; z < nz; ++z)
    for (Index y = 0; y < ny; ++y)
      for (Index x = 0; x < nx; ++x)
        for (int p = 0; p < 6; ++p) {
          Index v[4] = {x + step[1] * y + step[2] * z};
          for (int i = 0; i < 3; ++i) v[i + 1] = v[i] + step[paths[p][i]];
          if (p >= 3) std::swap(v[2], v[3]);  // odd paths
          t.tets.corners.insert(t.tets.corners.end(), v, v + 4);
          t.regions.push_back(region ? region(x, y, z) : 0);
        }
  t.tets.vertices = t.triangles.vertices = t.edges.vertices = static_cast<Index>(t.points.size());
  return t;
}

Index point_of(const TaggedTetrahedra& box, double x, double y, double z) {
  const auto found = std::find(box.points.begin(), box.points.end(), std::array<double, 3>{x, y, z});
  return static_cast<Index>(found - box.points.begin());
}

}  // namespace multimesh::test
