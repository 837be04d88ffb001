// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::decimation {

/// UV sets that a surface may have.
inline constexpr std::size_t max_sets = 4;

/// What is to become of an edge a-b of the surface: where its merged vertex goes, in space and in each of its
/// copies in the textures.
///
/// Where sheets of a surface meet in an edge of the mesh above, each has its own edge there, and all collapse
/// together: what is said of a and b holds of the ends in the other sheets, too.
struct CollapsePlan {
  struct Copy {
    std::size_t set;
    Index a, b;  ///< vertices of that texture
    Vec2 texcoord;
  };

  struct Ends {
    Index a, b;
  };

  Index a = no_index, b = no_index;  ///< vertices of the surface
  std::vector<Ends> other_sheets;    ///< the same of the others
  Vec3 at_a, at_b;                   ///< where they are
  double cost = 0;                   ///< squared deviation, integrated: length^2 x area
  /// The merged vertex has the values of (1-t) a + t b, except for its position and texture coordinates,
  /// which are these:
  double t = 0.5;
  Vec3 position;
  std::array<Copy, 2 * max_sets> copy_list;  ///< an edge has at most two copies per set
  std::size_t n_copies = 0;

  std::span<Copy> copies() { return {copy_list.data(), n_copies}; }
  std::span<const Copy> copies() const { return {copy_list.data(), n_copies}; }
  /// Calls f(a, b) for each sheet.
  template <class F>
  void for_each_sheet(F f) const {
    f(a, b);
    for (const Ends& ends : other_sheets) f(ends.a, ends.b);
  }
  /// The same, where the caller knows whether there are others than the first.
  template <bool others, class F>
  void for_each_sheet_if(F f) const {
    f(a, b);
    if constexpr (others)
      for (const Ends& ends : other_sheets) f(ends.a, ends.b);
  }
  std::size_t n_sheets() const { return 1 + other_sheets.size(); }
  Ends sheet(std::size_t i) const { return i == 0 ? Ends{a, b} : other_sheets[i - 1]; }
  /// Whether the merged vertex has another place than this end.
  bool moves(End end) const { return t != (end == End::a ? 0.0 : 1.0); }
};

}  // namespace multimesh::decimation
