// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "adapters/openmesh/root_surface.hpp"
#include "adapters/openmesh/temporary_property.hpp"
#include "multimesh/algorithms/remeshing/remesher.hpp"
#include "multimesh/algorithms/surface_invariants.hpp"
#include "multimesh/algorithms/vertex_locks.hpp"

namespace multimesh {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;

namespace {

void check(const RemeshOptions& o) {
  if (!(o.length > 0) || !std::isfinite(o.length))
    throw InputError("remesh: the edge length must be above 0 and finite");
  if (o.iterations < 1) throw InputError("remesh: at least one iteration is needed");
}

template <class At>
double faces_with(const Mesh& root, const At& at, double length) {
  double area = 0, rim = 0;
  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!root.is_live(2, f)) continue;
    std::array<Index, 4> v{};
    root.vertices(root.dart_of(2, f), v.data());
    area += cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0])).norm() / 2;
  }
  for (Index e = 0; e < root.capacity(1); ++e) {
    if (!root.is_live(1, e)) continue;
    const Dart d = root.dart_of(1, e);
    if (root.is_boundary(d, 1)) rim += (at(root.vertex(d)) - at(root.vertex(root.switch_dart(d, 0)))).norm();
  }
  return area / length / length / (std::sqrt(3.0) / 4) + rim / length;
}

void check_faces(const Mesh& root, const Coordinates& positions, const RemeshOptions& o) {
  const double faces = expected_faces(root, positions, o.length);
  if (!(faces > static_cast<double>(o.max_faces))) return;
  std::ostringstream text;
  text << "remesh: edges of length " << o.length << " make about " << faces << " faces, more than the "
       << o.max_faces << " that are allowed; a greater length or a higher maximum is needed";
  throw InputError(text.str());
}

RemeshResult run(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
                 const RemeshOptions& options, remeshing::Hooks hooks) {
  check(options);
  OpenMesh::PolyConnectivity& om = openmesh::root_surface(operations, "remesh");
  check_faces(operations.tree().mesh(NodeId::root), positions, options);
  openmesh::TemporaryProperty<OpenMesh::FPropHandleT<Index>> patch(om, "mm:patch");
  openmesh::TemporaryProperty<OpenMesh::EPropHandleT<Index>> line(om, "mm:line");
  return remeshing::Remesher(operations, positions, below, options, patch.values(), line.values(),
                             std::move(hooks))
      .run();
}

/// What a textured surface has, as attributes of operations on it.
class SurfaceFields {
 public:
  explicit SurfaceFields(TexturedSurface& s)
      : operations(s.tree()), positions_(NodeId::root, s.positions()), positions(positions_) {
    operations.add(positions_).set(LegalityOptions{.contact = true});
    for (std::size_t k = 0; k < s.textures().size(); ++k) {
      auto& values =
          texcoords_.emplace_back(std::make_unique<VertexAttribute<Vec2d>>(s.textures()[k], s.texcoords(k)));
      places_.push_back(std::make_unique<CoordinatesOf<Vec2d>>(*values));
      below.push_back(places_.back().get());
      invariants_.push_back(std::make_unique<SeamsStayOpen>(*values));
      operations.add(*values);
    }
    if (!s.colors().empty()) {
      colors_ = std::make_unique<VertexAttribute<Vec3d>>(NodeId::root, s.colors());
      operations.add(*colors_);
    }
    if (s.cut_report().copied_vertices > 0)
      invariants_.push_back(
          std::make_unique<CopiesStayApart>(s.tree().mesh(NodeId::root), s.source_positions()));
    for (const auto& i : invariants_) operations.add(*i);
  }

  Propagation operations;

 private:
  VertexAttribute<Vec3d> positions_;
  std::vector<std::unique_ptr<VertexAttribute<Vec2d>>> texcoords_;
  std::unique_ptr<VertexAttribute<Vec3d>> colors_;
  std::vector<std::unique_ptr<Coordinates>> places_;
  std::vector<std::unique_ptr<Invariant>> invariants_;

 public:
  CoordinatesOf<Vec3d> positions;
  std::vector<Coordinates*> below;
};

/// Where the texture of any set is cut open or ends.
CurveKinds texture_edges(const TexturedSurface& s) {
  CurveKinds kinds = no_curve;
  for (std::size_t k = 0; k < s.textures().size(); ++k) kinds |= seam_of(k) | texture_border_of(k);
  return kinds;
}

}  // namespace

double expected_faces(const Mesh& root, const Coordinates& positions, double length) {
  return faces_with(
      root, [&](Index v) { return positions.at(v); }, length);
}

double expected_faces(const TexturedSurface& surface, double length) {
  return faces_with(
      surface.tree().mesh(NodeId::root), [&](Index v) { return surface.positions()[v]; }, length);
}

bool length_reached(const RemeshResult& r, double length) {
  return static_cast<double>(r.edges_in_range) >= 0.9 * static_cast<double>(r.edges) &&
         r.longest <= 2 * length && r.shortest >= length / 4;
}

RemeshResult remesh(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
                    const RemeshOptions& options) {
  return run(operations, positions, below, options, {});
}

RemeshResult remesh(TexturedSurface& surface, const SurfaceRemeshOptions& options) {
  check(options);
  const VertexLocks locks(surface, options.lock_boundary,
                          options.lock_seams ? texture_edges(surface) : CurveKinds{no_curve});
  SurfaceFields fields(surface);
  remeshing::Hooks hooks;
  if (surface.has_normals()) {
    const Mesh& root = surface.tree().mesh(NodeId::root);
    hooks.keeps_edge = [&](Index e) { return surface.hard(e); };
    hooks.collapsing = [&](Dart e) -> std::function<void()> {
      return [&surface, merging = MergingEdges(root, e)] { merging.keep_hardness(surface); };
    };
  }
  return run(fields.operations, fields.positions, fields.below, options, std::move(hooks));
}

}  // namespace multimesh
