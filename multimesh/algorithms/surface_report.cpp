// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/surface_report.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

/// The vertices that are in facets, and the pieces these make.
class Pieces {
 public:
  explicit Pieces(std::size_t n) : sets_(n), used_(n, false) {}
  void join(Index i, Index j) {
    used_[i] = used_[j] = true;
    sets_.join(i, j);
  }
  std::size_t used() const { return static_cast<std::size_t>(std::count(used_.begin(), used_.end(), true)); }
  std::size_t count() {
    std::size_t n = 0;
    for (Index i = 0; i < used_.size(); ++i) n += used_[i] && sets_.find(i) == i;
    return n;
  }

 private:
  UnionFind sets_;
  std::vector<bool> used_;
};

}  // namespace

MeshReport report(const Mesh& mesh) {
  MeshReport r;
  r.dimension = mesh.dimension();
  Pieces pieces(mesh.capacity(0)), rim(mesh.capacity(0));
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    if (!mesh.is_live(1, e)) continue;
    ++r.edges;
    const Dart d = mesh.dart_of(1, e);
    const Index a = mesh.vertex(d), b = mesh.vertex(mesh.switch_dart(d, 0));
    pieces.join(a, b);
    if (mesh.dimension() == 2) {
      if (mesh.is_boundary(d, 1)) rim.join(a, b);
    } else {
      for (const Dart end : {d, mesh.switch_dart(d, 0)}) r.boundary += mesh.is_boundary(end, 0);
    }
  }
  for (Index v = 0; mesh.dimension() == 0 && v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v)) pieces.join(v, v);
  if (mesh.dimension() == 2)
    for (Index f = 0; f < mesh.capacity(2); ++f) r.faces += mesh.is_live(2, f);
  r.vertices = pieces.used();
  r.components = pieces.count();
  r.euler_characteristic =
      static_cast<long>(r.vertices) - static_cast<long>(r.edges) + static_cast<long>(r.faces);
  if (mesh.dimension() == 2) {
    r.boundary = rim.count();
    r.genus =
        (2 * static_cast<long>(r.components) - static_cast<long>(r.boundary) - r.euler_characteristic) / 2;
  }
  return r;
}

CurveReport report_curves(const TexturedSurface& surface, CurveKinds kinds) {
  CurveReport r;
  if (!surface.seams()) return r;
  const Mesh& curves = surface.tree().mesh(*surface.seams());
  const Mesh& root = surface.tree().mesh(NodeId::root);
  UnionFind pieces(curves.capacity(1));
  std::vector<std::array<Index, 2>> at;  // vertex of the surface, edge
  for (Index e = 0; e < curves.capacity(1); ++e) {
    if (!curves.is_live(1, e) || (surface.curve_kinds_of(e) & kinds) == 0) continue;
    const Dart d = surface.tree().to_parent(*surface.seams(), curves.dart_of(1, e));
    at.push_back({root.vertex(d), e});
    at.push_back({root.vertex(root.switch_dart(d, 0)), e});
  }
  r.edges = at.size() / 2;
  r.curves = r.edges;
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0, j; i < at.size(); i = j) {
    for (j = i; j < at.size() && at[j][0] == at[i][0];) ++j;
    r.ends += j - i == 1;
    r.junctions += j - i > 2;
    if (j - i != 2 || pieces.find(at[i][1]) == pieces.find(at[i + 1][1])) continue;
    pieces.join(at[i][1], at[i + 1][1]);
    --r.curves;
  }
  return r;
}

SeamReport report_seams(const TexturedSurface& surface, std::size_t set) {
  return report_curves(surface, seam_of(set) | texture_border_of(set));
}

CurveReport report_features(const TexturedSurface& surface) {
  return report_curves(surface, sharp_curve);
}

namespace {

std::optional<CurveReport> if_any(const CurveReport& r) {
  return r.edges > 0 ? std::optional(r) : std::nullopt;
}

}  // namespace

SurfaceReport report(const TexturedSurface& surface) {
  SurfaceReport r;
  r.surface = report(surface.tree().mesh(NodeId::root));
  if (surface.texture()) r.texture = report(surface.tree().mesh(*surface.texture()));
  r.seams = if_any(report_seams(surface));
  r.features = if_any(report_features(surface));
  for (std::size_t set = 1; set < surface.textures().size(); ++set)
    r.more_uv_sets.push_back(
        {report(surface.tree().mesh(surface.textures()[set])), if_any(report_seams(surface, set))});
  return r;
}

ManifoldReport report_manifoldness(const TexturedTriangles& input, const TexturedSurface& surface) {
  struct Side {
    std::int32_t low, high;
    bool forward;
  };
  std::vector<Side> sides;
  for (const auto& t : input.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = t[i].position, b = t[(i + 1) % 3].position;
      sides.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return x.low != y.low ? x.low < y.low : x.high < y.high; });
  ManifoldReport r;
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;) ++j;
    r.edges_with_three_or_more += j - i > 2;
    r.inconsistent_edges += j - i == 2 && sides[i].forward == sides[i + 1].forward;
  }
  r.cut_vertices = surface.cut_report().copied_vertices;
  return r;
}

}  // namespace multimesh
