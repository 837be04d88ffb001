// SPDX-License-Identifier: BSD-3-Clause
#include "tools/comparison_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace multimesh::tools {

namespace {

Json one_way(const OneWayDistance& d) {
  return {{"rms", d.rms}, {"max", d.max}};
}

Json texture(const TextureComparison& t) {
  const TextureDeviation& d = t.deviation;
  Json j;
  j["deviation"] = {{"rms", d.rms}, {"mean", d.mean}, {"p95", d.p95}, {"max", d.max}};
  j["color_psnr_db"] = std::isfinite(t.color_psnr) ? Json(t.color_psnr) : Json();
  j["seam_crack"] = {{"rms", t.crack.rms}, {"max", t.crack.max}};
  j["outside"] = t.outside;
  j["outside_own_chart"] = t.outside_own;
  return j;
}

Json counted(const CountedSurface& c) {
  Json j{{"triangles", c.triangles},
         {"untextured", c.untextured},
         {"flipped", c.flipped},
         {"zero_area", c.zero_area}};
  if (c.meshes) j["meshes"] = to_json(*c.meshes);
  return j;
}

}  // namespace

Json to_json(const SurfaceComparison& c) {
  Json j;
  j["diagonal"] = c.diagonal;
  j["distance"] = {{"rms", c.rms},
                   {"hausdorff", c.hausdorff},
                   {"to_original", one_way(c.to_original)},
                   {"from_original", one_way(c.from_original)}};
  j["texture"] = c.texture ? texture(*c.texture) : Json();
  j["original"] = counted(c.original);
  j["other"] = counted(c.other);
  return j;
}

}  // namespace multimesh::tools
