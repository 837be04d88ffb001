// SPDX-License-Identifier: BSD-3-Clause
#include "cut_tetrahedra.hpp"

#include <algorithm>
#include <map>

#include "multimesh/algorithms/remesh_domain.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "picture.hpp"

namespace multimesh::figures {
namespace {

constexpr double around = 1.0, towards = -0.15;  // the view

TaggedTetrahedra filled(const TexturedTriangles& surface) {
  FacetList triangles{2, static_cast<Index>(surface.positions.size()), {}};
  for (const auto& t : surface.triangles)
    for (const auto& corner : t) triangles.corners.push_back(static_cast<Index>(corner.position));
  const std::vector<tetgen::Point> points(surface.positions.begin(), surface.positions.end());
  tetgen::Tetrahedralization result = tetgen::tetrahedralize(points, triangles);
  TaggedTetrahedra tets;
  tets.points = std::move(result.points);
  tets.tets = std::move(result.tets);
  return tets;
}

struct Face {
  std::array<Index, 3> corners;  ///< anticlockwise as seen from outside
  bool is_inside;                ///< of the domain: the cut has bared it
};

/// The boundary of the tetrahedra that have their centres beyond the plane x = 0.
std::vector<Face> half(const TaggedTetrahedra& t) {
  std::map<std::array<Index, 3>, std::pair<Face, int>> faces;  // by sorted corners; in how many tetrahedra
  for (std::size_t i = 0; i < t.tets.corners.size(); i += 4) {
    const Index* v = &t.tets.corners[i];
    double x = 0;
    for (int k = 0; k < 4; ++k) x += t.points[v[k]][0];
    for (const auto& f : tetgen::outward_faces) {
      const std::array<Index, 3> corners{v[f[0]], v[f[1]], v[f[2]]};
      std::array<Index, 3> key = corners;
      std::sort(key.begin(), key.end());
      auto& [face, kept] = faces.try_emplace(key, Face{corners, true}, 0).first->second;
      face.is_inside = !face.is_inside;  // twice if two tetrahedra have it
      if (x > 0) face.corners = corners, ++kept;
    }
  }
  std::vector<Face> bared;
  for (const auto& [key, known] : faces)
    if (known.second == 1) bared.push_back(known.first);
  return bared;
}

void draw(Svg& svg, const TaggedTetrahedra& tets, Vec2 corner, Vec2 size) {
  std::vector<Vec3> at;
  std::vector<Vec2> flat;
  for (const auto& p : tets.points) {
    at.push_back(turned(p, around, towards));
    flat.push_back({at.back()[0], at.back()[1]});
  }
  const Fit fit(flat, corner, size);
  std::vector<Face> faces = half(tets);
  std::erase_if(faces, [&](const Face& f) {
    const auto& [a, b, c] = f.corners;
    return cross(at[b] - at[a], at[c] - at[a])[2] <= 0;
  });
  const auto depth = [&](const Face& f) {
    return at[f.corners[0]][2] + at[f.corners[1]][2] + at[f.corners[2]][2];
  };
  std::stable_sort(faces.begin(), faces.end(),
                   [&](const Face& x, const Face& y) { return depth(x) < depth(y); });
  for (const Face& f : faces) {
    std::vector<Vec2> outline;
    for (const Index v : f.corners) outline.push_back(fit(flat[v]));
    svg.polygon(outline, color(f.is_inside ? 1 : 0));
  }
}

}  // namespace

void remeshed_tetrahedra(const TexturedTriangles& surface, const std::filesystem::path& directory) {
  const TaggedTetrahedra before = filled(surface);
  TetDomain domain(before);
  DomainRemeshOptions options;
  options.length = 0.09;
  (void)remesh(domain, options);
  Svg svg(640, 330, "Remeshing the surface of tetrahedra",
          "Half a cow, filled with tetrahedra: as it was filled, and with even triangles, which the "
          "tetrahedra inside have followed.");
  draw(svg, before, {10, 10}, {300, 290});
  draw(svg, domain.tagged(), {330, 10}, {300, 290});
  svg.text({160, 320}, "input, cut open");
  svg.text({480, 320}, "surface remeshed: the tetrahedra follow");
  svg.write(directory / "remesh_tetrahedra.svg");
}

}  // namespace multimesh::figures
