// SPDX-License-Identifier: BSD-3-Clause
#include "test/algorithms/cost_cases.hpp"

namespace multimesh::test {

namespace {

/// Two textures whose seams cross.
TexturedTriangles two_sets(TexturedTriangles s) {
  add_uv_set(s, [&](std::size_t t, const Vec3& p) {
    return Vec2(0.3 * p[0] + (centroid(s, t)[1] < 10 ? 0 : 20), 0.2 * p[1] + 0.05 * p[2]);
  });
  return s;
}

/// Half of it has no second texture.
TexturedTriangles half_of_a_set(TexturedTriangles s) {
  add_uv_set(
      s, [](std::size_t, const Vec3& p) { return Vec2(p[0] + 0.1 * p[2], p[1]); },
      [&](std::size_t t) { return centroid(s, t)[1] < 10; });
  return s;
}

TexturedTriangles with_labels(TexturedTriangles s) {
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    s.labels.push_back(centroid(s, t)[0] + centroid(s, t)[1] < 14 ? 0U : 1U);
  return s;
}

/// A vertex of the texture is nearly on the opposite edge of one of its triangles.
TexturedTriangles sliver(double height) {
  TexturedTriangles s = waves();
  const std::int32_t at = 5 * 21 + 7, left = 4 * 21 + 7, right = 4 * 21 + 6;
  const auto uv = [&](std::int32_t v) {
    for (auto& t : s.triangles)
      for (auto& c : t)
        if (c.position == v) return s.texcoords[static_cast<std::size_t>(c.texcoord)];
    return Vec2(0, 0);
  };
  const Vec2 place = (uv(left) + uv(right)) * 0.5 * (1 - height) + uv(at) * height;
  for (auto& t : s.triangles)
    for (auto& c : t)
      if (c.position == at) s.texcoords[static_cast<std::size_t>(c.texcoord)] = place;
  return s;
}

}  // namespace

// Places on planar surfaces are badly determined: those are bent a little.
std::vector<CostCase> cost_cases() {
  std::vector<CostCase> all;
  for (MadeSurface& m : made_surfaces()) {
    jitter(m.input, 0.15, 7);
    all.push_back({m.name, std::move(m.input)});
  }
  all.push_back({"Waves", waves()});
  all.push_back({"Sliver", sliver(1e-3)});
  all.push_back({"ThinSliver", sliver(1e-5)});
  all.push_back({"SharpWaves", waves(), {.feature_angle = 0.6}});
  all.push_back({"TwoSets", two_sets(waves())});
  all.push_back({"HalfOfASet", half_of_a_set(waves())});
  all.push_back({"Labels", with_labels(waves())});
  TexturedTriangles cross = cube(8);
  unwrap_to_cross(cross, 8);
  all.push_back({"Cross", cross, {.feature_angle = 1}});
  all.push_back({"Spot", spot()});
  return all;
}

DecimateOptions memoryless() {
  DecimateOptions o;
  o.memory_weight = 0;
  return o;
}

std::vector<Dart> edges_of(const Mesh& mesh) {
  std::vector<Dart> edges;
  for (Index e = 0; e < mesh.capacity(1); ++e)
    if (mesh.is_live(1, e))
      edges.push_back(e % 2 ? mesh.dart_of(1, e) : mesh.reorder(mesh.dart_of(1, e), exchange_ends));
  return edges;
}

}  // namespace multimesh::test
