// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/surface_report.hpp"

#include <algorithm>

#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

/// The vertices that some edges use, and the pieces these make.
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

SeamReport report_seams(const TexturedSurface& surface) {
  SeamReport r;
  if (!surface.seams() || !surface.texture()) return r;
  const NodeId seams = *surface.seams();
  const Mesh& curves = surface.tree().mesh(seams);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  const Mesh& texture = surface.tree().mesh(*surface.texture());
  Pieces pieces(curves.capacity(0));
  std::vector<Index> degree(root.capacity(0), 0);
  DartBuffer copies;
  for (Index e = 0; e < curves.capacity(1); ++e) {
    if (!curves.is_live(1, e)) continue;
    const Dart own = curves.dart_of(1, e), d = surface.tree().to_parent(seams, own);
    copies.clear();
    surface.tree().to_child(*surface.texture(), d, 1, copies);
    if (copies.empty() || !texture.is_boundary(copies[0], 1)) continue;  // a border of another kind
    ++r.edges;
    pieces.join(curves.vertex(own), curves.vertex(curves.switch_dart(own, 0)));
    ++degree[root.vertex(d)];
    ++degree[root.vertex(root.switch_dart(d, 0))];
  }
  r.curves = pieces.count();
  r.ends = static_cast<std::size_t>(std::count(degree.begin(), degree.end(), 1));
  r.junctions =
      static_cast<std::size_t>(std::count_if(degree.begin(), degree.end(), [](Index n) { return n > 2; }));
  return r;
}

SurfaceReport report(const TexturedSurface& surface) {
  SurfaceReport r{report(surface.tree().mesh(NodeId::root)), {}, {}};
  if (surface.texture()) r.texture = report(surface.tree().mesh(*surface.texture()));
  if (surface.seams()) r.seams = report_seams(surface);
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
