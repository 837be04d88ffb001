// SPDX-License-Identifier: BSD-3-Clause
#include "test/pairs/domains.hpp"

#include <cmath>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/made_surface.hpp"
#include "test/domain/box.hpp"
#include "test/openmesh_tools/textured_torus.hpp"
#include "test/oracle/big_integer.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {

namespace {

/// Calls visit(vertex dart) once per live vertex.
template <class Visit>
void for_each_vertex(const Mesh& mesh, const Visit& visit) {
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart) visit(mesh.dart_of(0, v));
}

/// Two charts, each an affine image of its half of a plane.
class Textured final : public SurfaceInDomain {
 public:
  Textured() : made_(two_charts()), surface_(made_.input) {}
  const MultiMesh& tree() const override { return surface_.tree(); }
  NodeId surface() const override { return NodeId::root; }
  Embedding embedding() override { return surface_.embedding(); }
  Vec3 place(Dart v) const override { return surface_.positions()[tree().mesh(surface()).vertex(v)]; }
  std::string fault() const override {
    const NodeId texture = *surface_.texture();
    const Mesh& mesh = tree().mesh(texture);
    double farthest = 0;
    for_each_vertex(mesh, [&](Dart v) {
      const Vec3 p = place(tree().to_parent(texture, v));
      const Vec2 uv = surface_.texcoords()[mesh.vertex(v)];
      double nearest = HUGE_VAL;  // a vertex of the seam belongs to either
      for (const AffineMap& map : made_.maps) nearest = std::min(nearest, (map(p) - uv).norm());
      farthest = std::max(farthest, nearest);
    });
    return farthest < 1e-6 ? "" : "texture coordinates off by " + std::to_string(farthest);
  }

 private:
  MadeSurface made_;
  TexturedSurface surface_;
};

/// A user's mesh in the plane: texture coordinates of corners, and a curve across it.
class AttachedMesh final : public SurfaceInDomain {
 public:
  AttachedMesh() {
    make_torus(mesh_, 16, 12, 2, true);
    for (const auto v : mesh_.vertices()) mesh_.set_point(v, {double(v.idx() / 13), double(v.idx() % 13), 0});
    for (const auto h : mesh_.halfedges())
      mesh_.set_texcoord2D(h, uv(mesh_.point(mesh_.to_vertex_handle(h))));
    attached_ = std::make_unique<openmesh::Attached<DoubleMesh>>(mesh_);
    (void)attached_->add_texture();
    (void)attached_->add_edges([&](OpenMesh::EdgeHandle e) {
      const auto h = mesh_.halfedge_handle(e, 0);
      return mesh_.from_vertex_handle(h).idx() % 13 == 5 && mesh_.to_vertex_handle(h).idx() % 13 == 5;
    });
  }
  const MultiMesh& tree() const override { return attached_->tree(); }
  NodeId surface() const override { return NodeId::root; }
  Embedding embedding() override { return multimesh::embedding(*attached_); }
  Vec3 place(Dart v) const override {
    const auto& p = mesh_.point(OpenMesh::VertexHandle(static_cast<int>(tree().mesh(surface()).vertex(v))));
    return {p[0], p[1], p[2]};
  }
  std::string fault() const override {
    double farthest = 0;
    for (const auto f : mesh_.faces())
      for (const auto h : mesh_.fh_range(f))
        farthest =
            std::max(farthest, (mesh_.texcoord2D(h) - uv(mesh_.point(mesh_.to_vertex_handle(h)))).norm());
    if (farthest > 1e-6) return "texture coordinates of corners off by " + std::to_string(farthest);
    for (const auto f : mesh_.faces()) {
      const auto h = mesh_.halfedge_handle(f);
      const auto p = mesh_.point(mesh_.from_vertex_handle(h)), q = mesh_.point(mesh_.to_vertex_handle(h)),
                 r = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)));
      if (!(((q - p) % (r - p))[2] > 0)) return "a triangle is turned over";
    }
    return "";
  }

 private:
  static OpenMesh::Vec2d uv(const DoubleMesh::Point& p) { return {2 * p[0] + p[1], p[1] - 3}; }

  DoubleMesh mesh_;
  std::unique_ptr<openmesh::Attached<DoubleMesh>> attached_;
};

/// The exact orientation of (p0, p1, p2, p3), by arithmetic that is not the library's.
bool is_positive(const Mesh& mesh, Index tet, const std::function<Vec3(Index)>& at) {
  std::array<Index, 4> v{};
  mesh.vertices(mesh.dart_of(3, tet), v.data());
  std::array<std::array<double, 3>, 4> p{};
  for (std::size_t i = 0; i < 4; ++i) p[i] = at(v[i]);
  return oracle::exact_orientation(p, false) > 0;
}

/// A box of two materials: its boundary and the interface between them.
class Tetrahedra final : public SurfaceInDomain {
 public:
  Tetrahedra() : domain_(box(4, 4, 4, [](Index x, Index, Index) { return x < 2 ? 1 : 2; }), sharp()) {}
  const MultiMesh& tree() const override { return domain_.tree(); }
  NodeId surface() const override { return *domain_.surface(); }
  Embedding embedding() override { return domain_.embedding(); }
  Vec3 place(Dart v) const override {
    return at(tree().mesh(NodeId::root).vertex(tree().to_root(surface(), v)));
  }
  std::string fault() const override {
    return inverted_tet(domain_.mesh(), [&](Index v) { return at(v); });
  }

 private:
  static TetDomainOptions sharp() {
    TetDomainOptions o;
    o.feature_angle = 0.5;
    return o;
  }
  Vec3 at(Index v) const {
    const auto& p = domain_.points()[v];
    return {p[0], p[1], p[2]};
  }
  TetDomain domain_;
};

/// A tile of triangles; or one of tetrahedra, for its surface.
class GluedBox final : public SurfaceInDomain {
 public:
  GluedBox(const PeriodicTile& tile, const PeriodicOptions& options) : domain_(tile, options) {
    surface_ = tile.facets.dimension == 3 ? *domain_.add_surface() : domain_.tile();
  }
  const MultiMesh& tree() const override { return domain_.tree(); }
  NodeId surface() const override { return surface_; }
  Embedding embedding() override { return domain_.embedding(); }
  Vec3 place(Dart v) const override { return domain_.place(surface_, v); }
  std::string fault() const override {
    if (!copies_fit(domain_)) return "copies are not lattice vectors apart";
    if (std::abs(size(domain_) - 1) > 1e-12) return "the box has another size";
    const PeriodicTile now = domain_.tile_lists();
    for (const PeriodicSide& side : domain_.sides()) {
      const std::size_t axis = side.shift[0] != 0 ? 0 : 1;
      for (std::size_t i = 0; i < side.master.corners.size(); ++i)
        if (now.points[side.master.corners[i]][axis] != 0 || now.points[side.slave.corners[i]][axis] != 1)
          return "a side is not flat any more";
    }
    const Mesh& mesh = tree().mesh(domain_.tile());
    if (mesh.dimension() == 3) return inverted_tet(mesh, [&](Index v) { return domain_.positions()[v]; });
    return inverted(domain_) == 0 ? "" : "a triangle is turned over";
  }

 private:
  PeriodicDomain domain_;
  NodeId surface_ = NodeId::root;
};

}  // namespace

std::string inverted_tet(const Mesh& mesh, const std::function<Vec3(Index)>& at) {
  for (Index t = 0; t < mesh.capacity(3); ++t)
    if (mesh.is_live(3, t) && !is_positive(mesh, t, at))
      return "tetrahedron " + std::to_string(t) + " is turned over";
  return "";
}

std::vector<DomainCase> domain_cases() {
  using Pointer = std::unique_ptr<SurfaceInDomain>;
  return {
      {"TexturedSurface", []() -> Pointer { return std::make_unique<Textured>(); }, false, true},
      {"AttachedMesh", []() -> Pointer { return std::make_unique<AttachedMesh>(); }, false, true},
      {"SurfaceOfTetrahedra", []() -> Pointer { return std::make_unique<Tetrahedra>(); }, true, false},
      {"InterfaceInTetrahedra", interface_in_tetrahedra, true, false},
      {"TextureOverTetrahedra", texture_over_tetrahedra, true, false},
      {"PeriodicTile",
       []() -> Pointer { return std::make_unique<GluedBox>(square_tile(12, 10), along(true, true, false)); },
       false, false},
      {"SurfaceInPeriodicTile",
       []() -> Pointer { return std::make_unique<GluedBox>(cube_tile(5), along(true, true, false)); }, true,
       false},
  };
}

double SurfaceInDomain::area() const {
  const Mesh& mesh = tree().mesh(surface());
  double sum = 0;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    const Dart d = mesh.dart_of(2, f);
    const Vec3 p = place(d), q = place(mesh.reorder(d, exchange_ends)),
               r = place(mesh.reorder(d, permutation(2, 0, 1)));
    sum += cross(q - p, r - p).norm() / 2;
  }
  return sum;
}

TreeFacts facts_of(const MultiMesh& tree) {
  TreeFacts facts;
  for (const NodeId n : tree.nodes()) {
    const Mesh& mesh = tree.mesh(n);
    facts.betti.push_back(betti(mesh));
    facts.boundaries.push_back(mesh.dimension() == 3 ? 0 : report(mesh).boundary);
  }
  return facts;
}

std::string fault_of(SurfaceInDomain& domain, const TreeFacts& before) {
  if (const auto problems = validate(domain.tree()); !problems.empty()) return problems.front();
  if (!(facts_of(domain.tree()) == before)) return "the topology of a mesh has changed";
  // The domain must store what an algorithm sees next.
  const Embedding embedding = domain.embedding();
  const EmbeddedMesh surface(embedding, domain.surface());
  std::string fault = domain.fault();
  for_each_vertex(surface.mesh(), [&](Dart v) {
    if (surface.positions().at(surface.mesh().vertex(v)) != domain.place(v))
      fault = "a vertex is in two places";
  });
  return fault;
}

std::size_t live_facets(const Mesh& mesh) {
  std::size_t n = 0;
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f) n += mesh.is_live(mesh.dimension(), f);
  return n;
}

}  // namespace multimesh::test
