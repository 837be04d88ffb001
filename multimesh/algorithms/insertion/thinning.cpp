// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insertion/thinning.hpp"

#include <algorithm>

#include "multimesh/faces.hpp"

namespace multimesh::insertion {

namespace {

/// A sweep that takes out a smaller share is the last one.
constexpr double few = 0.05;

void make_unique(auto& list) {
  std::ranges::sort(list);
  const auto repeated = std::ranges::unique(list);
  list.erase(repeated.begin(), repeated.end());
}

}  // namespace

void Thinning::look_around(Index v) {
  const tet::TetMesh& mesh = cells_.mesh();
  around_ = {};
  mesh.star(mesh.dart_of(0, v), 0, star_);
  for (const Dart d : star_) {
    for (const Permutation p : faces_around(3, 1, 0)) {
      const Dart edge = mesh.reorder(d, p);
      const Index other = cells_.corners(edge)[1];
      around_.neighbours.push_back(other);
      if (cells_.is_on_segment(edge)) around_.along.push_back(other);
    }
    for (const Permutation p : faces_around(3, 2, 0)) {
      const Dart face = mesh.reorder(d, p);
      if (!cells_.is_in_polygon(face)) continue;
      const auto at = cells_.corners(face);
      around_.faces.push_back({std::min(at[1], at[2]), std::max(at[1], at[2])});
    }
  }
  make_unique(around_.neighbours);
  make_unique(around_.along);
  make_unique(around_.faces);
}

// Then all that the vertex lies in contains the way to p.
bool Thinning::may_go_to(Index v, Index p) const {
  return std::ranges::all_of(around_.faces, [&](const auto& f) {
    return f[0] == p || f[1] == p || cells_.orientation(v, f[0], f[1], p) == 0;
  });
}

bool Thinning::remove(Index v) {
  look_around(v);
  if (!around_.along.empty() && around_.along.size() != 2) return false;  // segments cross
  if (around_.along.empty() && around_.faces.empty()) return false;
  for (const Index p : around_.along.empty() ? around_.neighbours : around_.along)
    if (may_go_to(v, p) && cells_.collapse(v, p)) return true;
  return false;
}

std::size_t Thinning::run() {
  const tet::TetMesh& mesh = cells_.mesh();
  const auto end = static_cast<Index>(cells_.size());
  std::size_t all = 0;
  for (std::size_t gone = 1, tried = 1; double(gone) > few * double(tried); all += gone) {
    gone = tried = 0;
    for (Index v = looked_at_; v < end; ++v)
      if (mesh.is_live(0, v)) ++tried, gone += remove(v);
  }
  looked_at_ = end;
  return all;
}

}  // namespace multimesh::insertion
