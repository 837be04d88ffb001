// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include "multimesh/algorithms/remeshing/remesher.hpp"

namespace multimesh {

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

RemeshResult remesh(const Embedding& embedding, NodeId node, const RemeshOptions& options) {
  check(options);
  if (embedding.tree().mesh(node).dimension() != 2) throw UsageError("remesh: the mesh must be a surface");
  EmbeddedMesh surface(embedding, node);
  check_faces(surface.mesh(), surface.positions(), options);
  return remeshing::Remesher(surface, options).run();
}

RemeshResult remesh(TexturedSurface& surface, const RemeshOptions& options) {
  return remesh(surface.embedding(), NodeId::root, options);
}

}  // namespace multimesh
