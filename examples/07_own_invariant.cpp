// SPDX-License-Identifier: BSD-3-Clause
// An invariant of your own: a solid may not change its volume by more than a share. It predicts the effect of
// a collapse and is evaluated before, so nothing has to be undone. Refusals name it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "multimesh/openmesh/attach.hpp"
using namespace multimesh;
using OpenMesh::Vec3d;
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// An octahedron, subdivided: 8 * 4^5 triangles.
UserMesh ball() {
  UserMesh mesh;
  const int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < 6; ++i) mesh.add_vertex(Vec3d(i == 0, i == 2, i == 4) - Vec3d(i == 1, i == 3, i == 5));
  for (const auto& [a, b, c] : faces)
    mesh.add_face(OpenMesh::VertexHandle(a), OpenMesh::VertexHandle(b), OpenMesh::VertexHandle(c));
  OpenMesh::Subdivider::Uniform::LoopT<UserMesh> loop;
  loop.attach(mesh), loop(5), loop.detach();
  return mesh;
}

const auto volume = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) { return a | cross(b, c); };

class KeepsVolume final : public Invariant {
 public:
  KeepsVolume(const VertexAttribute<Vec3d>& points, double most)
      : Invariant("keeps the volume"), points_(points), most_(most) {}

  bool before(const Event& event) override {
    if (event.operation != Operation::collapse) return true;
    const double change = change_by(event);
    if (std::abs(sum_ + change) > most_) return false;
    asked_ = change;
    return true;
  }
  bool after(const Event& event) override {
    return sum_ += event.operation == Operation::collapse ? asked_ : 0, true;
  }
  double sum() const { return sum_; }

 private:
  // All triangles around both ends get the merged vertex in place of their end; those with both vanish.
  double change_by(const Event& event) {
    const Mesh& mesh = event.tree.mesh(NodeId::root);
    const VertexChange c = event.collapse_of(0);
    const Vec3d merged = points_.result(event.operation, c);
    const Dart e = event.copies[0].dart;
    double change = 0;
    for (const Dart end : {e, mesh.reorder(e, exchange_ends)}) {
      mesh.star(end, 0, star_);
      for (const Dart t : star_) {
        Index v[4];
        mesh.vertices(t, v);
        const bool dies = std::count(v, v + 3, c.a) + std::count(v, v + 3, c.b) == 2;
        if (!dies) change += volume(merged, points_[v[1]], points_[v[2]]);
        if (!dies || end == e) change -= volume(points_[v[0]], points_[v[1]], points_[v[2]]);
      }
    }
    return change;
  }
  const VertexAttribute<Vec3d>& points_;
  double most_, sum_ = 0, asked_ = 0;
  DartBuffer star_;
};

int main() {
  UserMesh mesh = ball();
  const auto total = [&] {
    return mesh.faces().sum([&](const OpenMesh::SmartFaceHandle& f) {
      const auto v = f.vertices().to_array<3>();
      return volume(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
    });
  };
  const double before = total();
  openmesh::Attached attached(mesh);
  KeepsVolume invariant(attached.points(), 0.02 * before);
  attached.operations().add(invariant);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 10 * mesh.n_halfedges(); ++i) {
    const OpenMesh::HalfedgeHandle h(static_cast<int>(i % mesh.n_halfedges()));
    if (mesh.status(mesh.edge_handle(h)).deleted()) continue;
    const Outcome o = attached.collapse(h, Placement::at(0.5));
    refused += o.refusal.check == Check::invariant && o.refusal.invariant == "keeps the volume";
  }
  attached.garbage_collection();
  const double change = total() - before;
  std::cout << mesh.n_faces() << " faces left, volume " << 100 * change / before << " %; refused " << refused
            << '\n';
  return std::abs(change - invariant.sum()) < 1e-9 * before && std::abs(change) <= 0.02 * before &&
                 refused > 0
             ? 0
             : 1;
}
