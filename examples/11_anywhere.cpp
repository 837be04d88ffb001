// SPDX-License-Identifier: BSD-3-Clause
// An algorithm that is written for a surface, and runs unchanged wherever the surface is. Short edges are
// collapsed on a plain surface, on one with a texture below, on the surface of tetrahedra, which follow, and
// on a periodic tile, whose copies of a vertex move as one.
#include <algorithm>
#include <iostream>

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/strata.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

// [algorithm]
/// Collapses edges until no edge that may be collapsed is shorter than `shortest`. Curves stay curves.
class Coarsening {
 public:
  Coarsening(const Embedding& embedding, NodeId n, double shortest)
      : surface_(embedding, n), mesh_(surface_.mesh()), strata_(surface_.tree(), n), shortest_(shortest) {}

  std::size_t run() {
    std::size_t collapsed = 0, before = 0;
    do {
      before = collapsed;
      for (Index e = 0; e < mesh_.capacity(1); ++e)
        if (mesh_.is_live(1, e)) collapsed += collapse(mesh_.dart_of(1, e));
    } while (collapsed > before);
    return collapsed;
  }

 private:
  bool collapse(Dart edge) {
    const Dart other = mesh_.reorder(edge, exchange_ends);
    const Coordinates& at = surface_.positions();
    if ((at.at(mesh_.vertex(edge)) - at.at(mesh_.vertex(other))).norm() >= shortest_) return false;
    return std::ranges::any_of(std::array{edge, other}, [&](Dart d) {
      return may_go(d) && turns_nothing_over(d) &&
             surface_.operations().collapse(surface_.node(), d, Placement::keep_b());
    });
  }
  /// For (a, b, ..): whether a is on no curve, or on a curve that contains the edge.
  bool may_go(Dart d) {
    const Freedom freedom = strata_.freedom(d);
    return freedom == Freedom::surface || (freedom == Freedom::line && !strata_.is_plain(d));
  }
  /// Whether a can move to b: at all copies of the edge, in space and in every chart below.
  bool turns_nothing_over(Dart d) {
    copies_.collect(surface_.tree(), surface_.node(), d, 1);
    return turns_nothing_over(surface_.positions()) &&
           std::ranges::all_of(surface_.charts(), [&](Coordinates* c) { return turns_nothing_over(*c); });
  }
  bool turns_nothing_over(const Coordinates& at) {
    const Mesh& mesh = surface_.tree().mesh(at.node());
    for (const Copy& copy : copies_.of(at.node())) {
      const Index b = mesh.vertex(mesh.reorder(copy.dart, exchange_ends));
      mesh.star(copy.dart, 0, star_);
      for (const Dart t : star_) {
        Index v[4];
        mesh.vertices(t, v);
        if (v[1] == b || v[2] == b) continue;
        const Vec3 q = at.at(v[1]), r = at.at(v[2]);
        const Vec3 was = cross(q - at.at(v[0]), r - at.at(v[0])), is = cross(q - at.at(b), r - at.at(b));
        if (!(dot(was, is) > 0.3 * was.norm() * is.norm())) return false;
      }
    }
    return true;
  }

  EmbeddedMesh surface_;
  const Mesh& mesh_;
  Strata strata_;
  double shortest_;
  Copies copies_;
  DartBuffer star_;
};
// [algorithm]

/// n^d small cubes, each cut into d! simplices around its diagonal.
PeriodicTile cube(Index n, std::size_t d) {
  const Index m = d == 3 ? n : 0;
  PeriodicTile tile{{}, {static_cast<int>(d), 0, {}}};
  for (Index k = 0; k <= m; ++k)
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) tile.points.push_back({double(i) / n, double(j) / n, double(k) / n});
  for (Index k = 0; k < std::max(m, Index{1}); ++k)
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        std::array<Index, 3> steps{1, n + 1, (n + 1) * (n + 1)};
        do {  // from corner to corner along the axes, in each order
          Index v = (k * (n + 1) + j) * (n + 1) + i;
          tile.facets.corners.push_back(v);
          for (std::size_t s = 0; s < d; ++s) tile.facets.corners.push_back(v += steps[s]);
        } while (std::next_permutation(steps.begin(), steps.begin() + static_cast<long>(d)));
      }
  tile.facets.vertices = static_cast<Index>(tile.points.size());
  return tile;
}

bool run(const char* name, const Embedding& embedding, NodeId surface, double shortest) {
  const std::size_t collapsed = Coarsening(embedding, surface, shortest).run();
  const auto problems = validate(embedding.tree());
  std::cout << name << ": " << collapsed << " collapses in " << embedding.tree().nodes().size()
            << " meshes\n";
  for (const std::string& p : problems) std::cerr << "wrong: " << p << '\n';
  return collapsed > 0 && problems.empty();
}

int main(int, char** arguments) try {
  files::SurfaceFile file = files::read_surface(arguments[1]);
  TexturedSurface textured(file.input);
  bool ok = run("with a texture", textured.embedding(), NodeId::root, 0.05);

  TexturedTriangles bare = file.input;
  bare.texcoords.clear(), bare.more_uv_sets.clear(), bare.shading.clear();
  for (auto& triangle : bare.triangles)
    for (auto& corner : triangle) corner.texcoord = -1;
  TexturedSurface plain(bare);
  ok &= run("plain", plain.embedding(), NodeId::root, 0.05);

  const PeriodicTile box = cube(8, 3);
  TaggedTetrahedra input;
  input.points = box.points;
  input.tets = box.facets;
  TetDomain domain(input, {.feature_angle = 0.5});  // the edges of the box are curves
  ok &= run("surface of tetrahedra", domain.embedding(), *domain.surface(), 0.2);

  PeriodicOptions in_plane;
  in_plane.axes = {true, true, false};
  PeriodicDomain tile(cube(12, 2), in_plane);
  ok &= run("periodic tile", tile.embedding(), tile.tile(), 0.15);
  return ok && tile.mismatch() < 1e-15 ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << "error: " << e.what() << '\n';
  return 1;
}
