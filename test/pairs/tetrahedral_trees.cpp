// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra with meshes that no domain of the library has: an interface as a mesh of its own, beside the
// boundary; and a texture of the boundary.
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "multimesh/build.hpp"
#include "multimesh/domains/make_mesh.hpp"
#include "test/domain/box.hpp"
#include "test/pairs/domains.hpp"

namespace multimesh::test {

namespace {

constexpr Index width = 6;

/// The planes of the sides of a box, as bits, on which a point is; and that in its middle.
unsigned planes_of(const Vec3& p) {
  unsigned planes = p[0] == double(width) / 2 ? 64 : 0;
  for (unsigned i = 0; i < 3; ++i) planes |= (p[i] == 0 ? 1U << i : 0) | (p[i] == width ? 8U << i : 0);
  return planes;
}

/// A box of tetrahedra, on which the meshes of derived classes lie.
class BoxTree : public SurfaceInDomain {
 public:
  BoxTree() : input_(box(width, width, width)), tree_(make_mesh(input_.tets)) {
    for (const auto& p : input_.points) points_.emplace_back(p);
  }
  const MultiMesh& tree() const override { return tree_; }
  NodeId surface() const override { return surface_; }
  Embedding embedding() override {
    Embedding e(tree_);
    e.set(LegalityOptions{.contact = true});
    auto& positions = e.add<VertexAttribute<Vec3>>(NodeId::root, points_);
    e.keep_orientation(e.add_coordinates(positions, Embedding::Kind::space));
    return e;
  }
  Vec3 place(Dart v) const override { return place_in(surface_, v); }
  std::string fault() const override {
    const Mesh& tets = root();
    if (const auto fault = inverted_tet(tets, [&](Index v) { return points_[v]; }); !fault.empty())
      return fault;
    double volume = 0;
    std::array<Index, 4> v{};
    for (Index t = 0; t < tets.capacity(3); ++t) {
      if (!tets.is_live(3, t)) continue;
      tets.facet_vertices(t, v.data());
      const Vec3& p = points_[v[0]];
      volume += std::abs(dot(cross(points_[v[1]] - p, points_[v[2]] - p), points_[v[3]] - p)) / 6;
    }
    return std::abs(volume - double(width * width * width)) < 1e-9 ? "" : "the box has another volume";
  }

 protected:
  const Mesh& root() const { return tree_.mesh(NodeId::root); }
  Vec3 place_in(NodeId n, Dart v) const { return points_[root().vertex(tree_.to_root(n, v))]; }
  /// Those of the corners of a simplex in common.
  unsigned planes(int k, Index s) const {
    std::array<Index, 4> v{};
    root().vertices(root().dart_of(k, s), v.data());
    unsigned common = ~0U;
    for (int i = 0; i <= k; ++i) common &= planes_of(points_[v[static_cast<std::size_t>(i)]]);
    return common;
  }
  NodeId add_boundary() { return add_child_from_boundary(tree_, NodeId::root, make_mesh); }
  /// Lines in which planes meet; they end where three do.
  void add_lines() {
    const auto several = [](unsigned planes) { return (planes & (planes - 1)) != 0; };
    const CutOptions ends{[&](Index v) {
      const unsigned p = planes_of(points_[v]);
      return several(p & (p - 1));
    }};
    add_child_from_tags(
        tree_, NodeId::root, 1, [&](Index e) { return several(planes(1, e)); }, make_mesh, ends);
  }

  TaggedTetrahedra input_;
  MultiMesh tree_;
  std::vector<Vec3> points_;
  NodeId surface_ = NodeId::root;
};

class Interface final : public BoxTree {
 public:
  Interface() {
    (void)add_boundary();
    surface_ = add_child_from_tags(
        tree_, NodeId::root, 2, [&](Index f) { return (planes(2, f) & 64) != 0; }, make_mesh);
    add_lines();
  }
  std::string fault() const override {
    const Mesh& mesh = tree_.mesh(surface_);
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart &&
          std::abs(place(mesh.dart_of(0, v))[0] - double(width) / 2) > 1e-9)
        return "the interface is not where it was";
    return BoxTree::fault();
  }
};

/// A chart per side of the box.
class Texture final : public BoxTree {
 public:
  Texture() {
    surface_ = add_boundary();
    const Mesh& mesh = tree_.mesh(surface_);
    FacetList charts{2, 0, {}}, over{2, mesh.capacity(0), {}};
    std::vector<Index> facets;
    std::map<std::pair<unsigned, Index>, Index> numbers;
    for (Index f = 0; f < mesh.capacity(2); ++f) {
      std::array<Index, 4> v{};
      mesh.facet_vertices(f, v.data());
      unsigned side = ~0U;
      for (std::size_t i = 0; i < 3; ++i) side &= planes_of(place(mesh.dart_of(0, v[i])));
      side &= 63;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [found, is_new] = numbers.try_emplace({side, v[i]}, static_cast<Index>(uv_.size()));
        if (is_new) uv_.push_back(map(side, place(mesh.dart_of(0, v[i]))));
        charts.corners.push_back(found->second);
        over.corners.push_back(v[i]);
      }
      facets.push_back(f);
    }
    charts.vertices = static_cast<Index>(uv_.size());
    texture_ = add_child_by_facets(tree_, surface_, std::move(charts), std::move(over), facets, make_mesh);
  }
  Embedding embedding() override {
    Embedding e = BoxTree::embedding();
    e.add_coordinates(e.add<VertexAttribute<Vec2>>(texture_, uv_), Embedding::Kind::chart);
    return e;
  }
  std::string fault() const override {
    const Mesh& mesh = tree_.mesh(texture_);
    for (Index f = 0; f < mesh.capacity(2); ++f)
      if (mesh.is_live(2, f) && !fits_a_side(mesh.dart_of(2, f))) return "a triangle of the texture is off";
    return BoxTree::fault();
  }

 private:
  static Vec2 map(unsigned side, const Vec3& p) {
    const double shift = 10.0 * side;
    if ((side & 9U) != 0) return {shift + p[1], p[2]};
    if ((side & 18U) != 0) return {shift + p[2], 2 * p[0]};
    return {shift + p[0] + p[1], p[1]};
  }
  bool fits_a_side(Dart d) const {
    const Mesh& mesh = tree_.mesh(texture_);
    for (unsigned side = 1; side < 64; side *= 2) {
      double off = 0;
      for (const Permutation p : {Permutation{}, exchange_ends, permutation(2, 0, 1)}) {
        const Dart v = mesh.reorder(d, p);
        off = std::max(off, (map(side, place_in(texture_, v)) - uv_[mesh.vertex(v)]).norm());
      }
      if (off < 1e-9) return true;
    }
    return false;
  }

  NodeId texture_ = NodeId::root;
  std::vector<Vec2> uv_;
};

}  // namespace

std::unique_ptr<SurfaceInDomain> interface_in_tetrahedra() {
  return std::make_unique<Interface>();
}

std::unique_ptr<SurfaceInDomain> texture_over_tetrahedra() {
  return std::make_unique<Texture>();
}

}  // namespace multimesh::test
