// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/random_solid_trees.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/image.hpp"
#include "oracle/orientation.hpp"
#include "oracle/solid_overlay.hpp"
#include "oracle/submesh.hpp"

namespace multimesh::oracle {

std::string to_string(SolidTreeKind kind) {
  static const std::array<const char*, kNumberOfSolidTreeKinds> kNames{
      "curve in solid",   "surface",         "surface, guarded",        "surfaces, guarded",
      "curve of surface", "boundary",        "part of a solid",         "part of cut solid",
      "mixed in solid",   "points in solid", "points of curve in solid"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string to_string(Solid kind) {
  static const std::array<const char*, kNumberOfSolids> kNames{"ball", "3-sphere", "solid torus", "shell",
                                                               "3-torus"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

/// Builds one tree; each function adds a node and returns its index, or fails.
class SolidTreeBuilder {
 public:
  SolidTreeBuilder(Complex root, std::mt19937_64& rng) : rng_(rng) {
    tree_.nodes.push_back({std::move(root), -1, {}});
  }

  Tree take() { return std::move(tree_); }
  bool failed() const { return failed_; }

  int curve(int parent) {
    if (failed_) return 0;
    return add(curve_child(mesh(parent), parent, random_edges(mesh(parent), rng_)));
  }

  int points(int parent) {
    if (failed_) return 0;
    return add(point_child(parent, random_points(mesh(parent), rng_)));
  }

  int surface() { return add(cut_child(0, random_triangles(mesh(0), rng_))); }

  int boundary_of(int parent) {
    if (failed_) return 0;
    const SimplexSet rim = of_dimension(boundary(mesh(parent)), 2);
    if (rim.empty()) return fail();
    return add(cut_child(parent, rim));
  }

  /// Some of the tetrahedra, or all, cut along random triangles.
  int part(int parent, bool all) {
    if (failed_) return 0;
    const SimplexSet tets = all ? facet_set(mesh(parent)) : random_lump(mesh(parent), rng_);
    const SimplexSet cuts = chance(rng_, 60) ? random_triangles(mesh(parent), rng_) : SimplexSet{};
    return add(cut_child(parent, tets, cuts));
  }

  /// A curve on what is not one surface, and points where no curve can hold that.
  void guard() {
    if (failed_) return;
    std::vector<Layer> layers;
    for (std::size_t i = 1; i < tree_.nodes.size(); ++i)
      layers.push_back({&tree_.nodes[i].mesh, tree_.nodes[i].image});
    SingularSet singular = singular_set(mesh(0), layers, false);
    const SingularSet joint = singular_set(mesh(0), layers, true);
    singular.edges = unite(singular.edges, joint.edges);
    singular.corners.insert(singular.corners.end(), joint.corners.begin(), joint.corners.end());
    if (!singular.edges.empty()) add(curve_child(mesh(0), 0, singular.edges, singular.corners));
    std::vector<int> points = singular.isolated;
    points.insert(points.end(), joint.isolated.begin(), joint.isolated.end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (!points.empty()) add(point_child(0, points));
  }

 private:
  const Complex& mesh(int node) const { return tree_.nodes[static_cast<std::size_t>(node)].mesh; }

  int fail() {
    failed_ = true;
    return 0;
  }

  int add(TreeNode node) {
    if (failed_ || !orient(node.mesh)) return fail();
    tree_.nodes.push_back(std::move(node));
    if (!tree_error(tree_).empty()) return fail();
    return static_cast<int>(tree_.nodes.size()) - 1;
  }

  std::mt19937_64& rng_;
  Tree tree_;
  bool failed_ = false;
};

void build(SolidTreeBuilder& b, SolidTreeKind kind) {
  switch (kind) {
    case SolidTreeKind::kCurve:
      return void(b.curve(0));
    case SolidTreeKind::kSurface:
      return void(b.surface());
    case SolidTreeKind::kSurfacesGuarded:
      b.surface();
      [[fallthrough]];
    case SolidTreeKind::kSurfaceGuarded:
      b.surface();
      return b.guard();
    case SolidTreeKind::kCurveOfSurface:
      return void(b.curve(b.surface()));
    case SolidTreeKind::kBoundary:
      b.curve(b.boundary_of(0));
      return void(b.curve(0));
    case SolidTreeKind::kPart:
      return void(b.boundary_of(b.part(0, false)));
    case SolidTreeKind::kSolids:
      return void(b.part(b.part(0, true), false));
    case SolidTreeKind::kMixed:
      b.boundary_of(b.part(0, false));
      b.curve(b.curve(b.surface()));
      return void(b.curve(0));
    case SolidTreeKind::kPoints:
      return void(b.points(0));
    case SolidTreeKind::kPointsOfCurve:
      b.points(b.curve(b.surface()));
      b.points(b.part(0, false));
      return void(b.points(0));
  }
}

}  // namespace

Tree random_solid_tree(std::uint64_t seed, SolidTreeKind kind, Solid root, const TreeOptions& options) {
  std::mt19937_64 rng(seed);
  if (kind == SolidTreeKind::kBoundary && root != Solid::kSolidTorus && root != Solid::kShell)
    root = Solid::kBall;
  while (true) {
    const std::size_t facets = options.min_facets + pick(rng, options.max_facets - options.min_facets + 1);
    SolidTreeBuilder builder(random_solid(root, facets, rng), rng);
    build(builder, kind);
    if (!builder.failed()) return builder.take();
  }
}

}  // namespace multimesh::oracle
