// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

struct RepeatedFace {
  std::uint32_t face;
  std::uint32_t earlier;  ///< the first one with its vertices
  friend auto operator<=>(const RepeatedFace&, const RepeatedFace&) = default;
};

/// The faces whose vertices, in any order, are those of an earlier face; ascending. Faces without corners are
/// skipped. Cost: O(\#F log) at worst, linear in practice.
/// \pre every vertex index is in range.
std::vector<RepeatedFace> repeated_faces(const PolygonSoup& soup);

}  // namespace multimesh::io
