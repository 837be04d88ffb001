// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "multimesh/algorithms/decimate.hpp"

namespace multimesh {

/// How well a surface shows the texture of another one. See docs/compare.md.
struct TextureQuality {
  double deviation = 0;  ///< root mean square, relative to the bounding-box diagonal
  double outside = 0;    ///< share of the surface that reads its texture outside of its own chart
};

/// If either is exceeded, the texture counts as lost.
constexpr TextureQuality tolerable_texture{0.01, 0.05};

/// The point of a decimation at which the texture was lost.
struct TextureLoss {
  TextureQuality at_end;
  std::size_t faces = 0;  ///< the last measured count at which it was tolerable; 0: none
};

/// Whether measuring is worthwhile: costs are high for a surface with a texture, there are few faces per
/// chart, or the target was missed; and no bound on the texture was given. Cost: none.
bool may_have_lost_texture(const DecimateOptions& options, const DecimateResult& result);

/// Measures `left`. If its texture is lost, decimates the input again and measures during the run, each time
/// that a fifth of the faces is gone. \return nothing if the texture is tolerable, or there is none.
/// \pre `result` and `left` are the results of `options` on `input`. Cost: that of a comparison, and if the
/// texture is lost that of the decimation and some more.
std::optional<TextureLoss> find_texture_loss(const TexturedTriangles& input,
                                             const TexturedSurfaceOptions& surface_options,
                                             const DecimateOptions& options, const DecimateResult& result,
                                             const TexturedTriangles& left);

}  // namespace multimesh
