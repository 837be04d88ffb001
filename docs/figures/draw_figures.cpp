// SPDX-License-Identifier: BSD-3-Clause
// draw_figures SPOT.obj DIRECTORY: the figures of the documents, from a real mesh, by the library itself.
#include <algorithm>
#include <iostream>

#include "cut_tetrahedra.hpp"
#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/operations.hpp"
#include "periodic_tile.hpp"
#include "picture.hpp"

namespace multimesh::figures {
namespace {

namespace fs = std::filesystem;
constexpr double around = 0.6, towards = -0.15;  // the view

TexturedTriangles coarse(const TexturedTriangles& input, std::size_t faces) {
  TexturedSurface surface(input);
  DecimateOptions options;
  options.faces = faces;
  (void)decimate(surface, options);
  std::vector<Index> source;
  return surface.triangles(source);
}

std::function<std::string(Index)> by_chart(const TexturedSurface& s, const std::vector<std::size_t>& chart) {
  const Mesh& root = s.tree().mesh(NodeId::root);
  return [&s, &root, &chart](Index f) {
    const Index t = s.tree().facet_over(*s.texture(), root.dart_of(2, f));
    return t == no_index ? std::string("white") : color(chart[t]);
  };
}

void surface_and_texture(const TexturedTriangles& spot, const fs::path& directory) {
  const TexturedSurface s(coarse(spot, 700));
  const auto chart = charts(s.tree().mesh(*s.texture()));
  Svg svg(640, 330, "A surface and its texture, two meshes",
          "A cow, cut open along red seams into charts of different colours; beside it the charts lie flat "
          "in the atlas, "
          "each with a red border.");
  draw_surface(svg, s, {10, 10}, {300, 290}, by_chart(s, chart), around, towards);
  draw_texture(svg, s, {330, 10}, {300, 290}, [&](Index t) { return color(chart[t]); });
  svg.text({160, 320}, "surface: the parent");
  svg.text({480, 320}, "texture: the child; red: where it is cut open");
  svg.write(directory / "surface_and_texture.svg");
}

/// The triangles around the ends of an edge, in the plane: of the surface, and of each copy in the texture.
class Neighbourhood {
 public:
  Neighbourhood(const TexturedSurface& s, Dart edge) : surface_(s), root_(s.tree().mesh(NodeId::root)) {
    for (const Dart end : {edge, root_.reorder(edge, exchange_ends)}) add(end);
    const auto v = vertices_of(root_, edge);
    origin_ = s.positions()[v[0]];
    x_ = (s.positions()[v[1]] - origin_).normalized();
    const Vec3 n = cross(x_, s.positions()[v[2]] - origin_).normalized();
    y_ = cross(n, x_);
  }
  Vec2 flat(const Vec3& p) const { return {dot(p - origin_, x_), dot(p - origin_, y_)}; }

  /// What is there now: all live triangles at the vertices that were there, and at new ones beyond
  /// `old_vertices`.
  void draw(Svg& svg, Vec2 corner, Index old_vertices, const std::string& title) {
    const MultiMesh& tree = surface_.tree();
    const Mesh& texture = tree.mesh(*surface_.texture());
    DartBuffer now;
    for (const Dart t : triangles_of(root_)) {
      const auto v = vertices_of(root_, t);
      const bool inside =
          std::count_if(v.begin(), v.begin() + 3, [&](Index x) {
            return x >= old_vertices || std::binary_search(vertices_.begin(), vertices_.end(), x);
          }) == 3;
      if (inside) now.push_back(t);
    }
    std::array<std::vector<Vec2>, 3> points;  // on the surface; in the texture, on both sides of the seam
    for (const Dart t : now)
      for (std::size_t i = 0; i < 3; ++i) {
        points[0].push_back(flat(surface_.positions()[vertices_of(root_, t)[i]]));
        points[side(t)].push_back(
            surface_.texcoords()[vertices_of(texture, tree.facet_copy(*surface_.texture(), t))[i]]);
      }
    if (frame_[0].empty()) frame_ = points;  // the same for all pictures
    const std::array<Fit, 3> fits{Fit(frame_[0], corner, {180, 90}),
                                  Fit(frame_[1], corner + Vec2(0, 120), {180, 65}),
                                  Fit(frame_[2], corner + Vec2(0, 205), {180, 65})};
    for (const Dart t : now) draw_triangle(svg, t, fits[0], fits[side(t)]);
    svg.text(corner + Vec2(90, -8), title, 12);
  }

 private:
  void add(Dart end) {
    DartBuffer star;
    root_.star(end, 0, star);
    for (const Dart t : star)
      for (std::size_t i = 0; i < 3; ++i) vertices_.push_back(vertices_of(root_, t)[i]);
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }
  /// 1 left of the edge, 2 right of it.
  std::size_t side(Dart t) const {
    double y = 0;
    for (std::size_t i = 0; i < 3; ++i) y += flat(surface_.positions()[vertices_of(root_, t)[i]])[1];
    return y > 0 ? 1 : 2;
  }
  void draw_triangle(Svg& svg, Dart t, const Fit& fit, const Fit& fit_uv) const {
    const MultiMesh& tree = surface_.tree();
    const Mesh& texture = tree.mesh(*surface_.texture());
    const Dart copy = tree.facet_copy(*surface_.texture(), t);
    std::vector<Vec2> p, q;
    for (std::size_t i = 0; i < 3; ++i) {
      p.push_back(fit(flat(surface_.positions()[vertices_of(root_, t)[i]])));
      q.push_back(fit_uv(surface_.texcoords()[vertices_of(texture, copy)[i]]));
    }
    svg.polygon(p, "#deebf7");
    svg.polygon(q, "#fee6ce");
    constexpr Permutation sides[] = {Permutation{}, edge_bx, edge_ax};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (surface_.curve_kinds(root_.reorder(t, sides[i])) == 0) continue;
      svg.line(p[i], p[j], "#c00", 1.6);
      svg.line(q[i], q[j], "#c00", 1.6);
    }
  }

  const TexturedSurface& surface_;
  const Mesh& root_;
  std::vector<Index> vertices_;
  Vec3 origin_, x_, y_;
  std::array<std::vector<Vec2>, 3> frame_;
};

/// An edge on a seam whose ends lie inside the seam, long beside the others.
Dart seam_edge(const TexturedSurface& s, Propagation& operations) {
  const Mesh& root = s.tree().mesh(NodeId::root);
  Dart best = no_dart;
  double longest = 0;
  for (Index e = 0; e < root.capacity(1); ++e) {
    const Dart d = root.dart_of(1, e);
    const auto v = vertices_of(root, d);
    const CollapseVerdict verdict = operations.judge(NodeId::root, d);
    if ((s.curve_kinds(d) & seam_curve) == 0 || verdict.refusal.refused() || verdict.hold_a || verdict.hold_b)
      continue;
    const double length = (s.positions()[v[0]] - s.positions()[v[1]]).norm();
    if (length > longest) longest = length, best = d;
  }
  return best;
}

void operations_across_a_seam(const TexturedTriangles& spot, const fs::path& directory) {
  TexturedSurface s(coarse(spot, 900));
  VertexAttribute<Vec3> positions(NodeId::root, s.positions());
  VertexAttribute<Vec2> texcoords(*s.texture(), s.texcoords());
  Propagation operations(s.tree());
  operations.add(positions).add(texcoords);
  const Dart edge = seam_edge(s, operations);
  Neighbourhood place(s, edge);
  const Index vertices = s.tree().mesh(NodeId::root).capacity(0);
  Svg svg(640, 330, "A split and a collapse, carried to two meshes",
          "A neighbourhood of a seam edge, above on the surface and below in the texture, where the edge has "
          "two copies: "
          "as it was, with a new vertex on the edge and on both copies, and with the edge collapsed on all.");
  place.draw(svg, {15, 25}, vertices, "before");
  {
    const Transaction undone = operations.transaction();
    if (!operations.split(NodeId::root, edge, 0.5)) std::cerr << "split refused\n";
    place.draw(svg, {230, 25}, vertices, "split of the seam edge");
  }
  if (!operations.collapse(NodeId::root, edge, Placement::at(0.5))) std::cerr << "collapse refused\n";
  place.draw(svg, {445, 25}, vertices, "collapse of the seam edge");
  svg.text({320, 320},
           "above: the surface; below: both sides in the texture, each with its copy of the edge. Red: seam");
  svg.write(directory / "operations.svg");
}

void remeshed(const TexturedTriangles& spot, const fs::path& directory) {
  const TexturedTriangles before = coarse(spot, 900);
  const TexturedSurface left(before);
  TexturedSurface right(before);
  RemeshOptions options;
  options.length = 0.11;
  (void)remesh(right, options);
  Svg svg(640, 330, "Remeshing",
          "The cow with triangles of many sizes, and with even ones; the seams run where they ran.");
  const auto chart = charts(left.tree().mesh(*left.texture())),
             chart_right = charts(right.tree().mesh(*right.texture()));
  draw_surface(svg, left, {10, 10}, {300, 290}, by_chart(left, chart), around, towards);
  draw_surface(svg, right, {330, 10}, {300, 290}, by_chart(right, chart_right), around, towards);
  svg.text({160, 320}, "input");
  svg.text({480, 320}, "remeshed: the seams have edges of the same length");
  svg.write(directory / "remesh.svg");
}

}  // namespace
}  // namespace multimesh::figures

int main(int argc, char** argv) try {
  using namespace multimesh::figures;
  if (argc != 3) {
    std::cerr << "Usage: draw_figures SPOT.obj DIRECTORY\n";
    return 2;
  }
  const auto spot = multimesh::files::read_surface(argv[1]).input;
  surface_and_texture(spot, argv[2]);
  operations_across_a_seam(spot, argv[2]);
  remeshed(spot, argv[2]);
  periodic_tiles(argv[2]);
  remeshed_tetrahedra(coarse(spot, 1500), argv[2]);
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
