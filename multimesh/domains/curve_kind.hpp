// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace multimesh {

/// What runs along an edge of a surface's curves. An edge can have several kinds: they are the bits of a
/// CurveKinds.
enum CurveKind : std::uint32_t {
  no_curve = 0,
  seam_curve = 1,             ///< the texture is cut open there
  texture_border_curve = 2,   ///< a face with texture coordinates beside one without
  reversed_border_curve = 4,  ///< one of the two faces was reversed
  label_border_curve = 8,     ///< faces with different labels
  sharp_curve = 16,           ///< normals that differ by the feature angle or more
};
using CurveKinds = std::uint32_t;

/// For so many sets of texture coordinates there is a bit for their seams and one for their borders.
inline constexpr std::size_t max_uv_sets = 14;

/// `seam_curve` of a set of texture coordinates; set 0 is the first one.
constexpr CurveKinds seam_of(std::size_t set) noexcept {
  return set == 0 ? CurveKinds{seam_curve} : CurveKinds{1} << (3 + 2 * set);
}
/// `texture_border_curve` of a set of texture coordinates.
constexpr CurveKinds texture_border_of(std::size_t set) noexcept {
  return set == 0 ? CurveKinds{texture_border_curve} : CurveKinds{1} << (4 + 2 * set);
}

}  // namespace multimesh
