// SPDX-License-Identifier: BSD-3-Clause
#include "test/benchmark/decimation.hpp"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>

#include "multimesh/scheduler.hpp"
#include "multimesh/work_queue.hpp"

namespace multimesh::bench {

namespace {

double checksum(const std::vector<OpenMesh::Vec3d>& points, const auto& is_live) {
  double sum = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_live(v)) sum += points[v][0] + 2 * points[v][1] + 3 * points[v][2];
  return sum;
}

double checksum(SurfaceMesh& mesh) {
  return checksum(mesh.property(mesh.points_pph()).data_vector(), [&](std::size_t v) {
    return !mesh.status(OpenMesh::VertexHandle(static_cast<int>(v))).deleted();
  });
}

}  // namespace

Decimation decimate_bare(SurfaceMesh& mesh, std::size_t faces) {
  Decimation done{0, mesh.n_faces(), 0};
  const auto cost = [&](OpenMesh::EdgeHandle e) {
    const auto h = mesh.halfedge_handle(e, 0);
    return (mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h))).sqrnorm();
  };
  WorkQueue queue;
  queue.reserve(mesh.n_edges());
  for (const auto e : mesh.edges()) queue.push(static_cast<Index>(e.idx()), cost(e));
  WorkQueue::Entry next;
  while (queue.pop(next)) {
    const OpenMesh::EdgeHandle e(static_cast<int>(next.simplex));
    if (mesh.status(e).deleted()) continue;
    if (done.faces <= faces) break;
    const auto h = mesh.halfedge_handle(e, 0);
    if (!mesh.is_collapse_ok(h)) continue;
    const auto v = mesh.to_vertex_handle(h);
    const OpenMesh::Vec3d middle = (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(v)) * 0.5;
    done.faces -= mesh.is_boundary(e) ? 1 : 2;
    mesh.collapse(h);
    mesh.point(v) = middle;
    ++done.collapses;
    for (auto it = mesh.cve_iter(v); it.is_valid(); ++it)
      queue.push(static_cast<Index>(it->idx()), cost(*it));
  }
  done.checksum = checksum(mesh);
  return done;
}

namespace {

/// The same as a policy of the scheduler.
class ShortestEdge {
 public:
  ShortestEdge(SurfaceTree& tree, std::size_t faces, Decimation& done)
      : tree_(tree), root_(tree.root()), points_(tree.positions()), faces_(faces), done_(done) {}

  std::optional<double> cost(Dart e) const {
    const Index a = root_.vertex(e), b = root_.vertex(root_.reorder(e, exchange_ends));
    return (points_[b] - points_[a]).sqrnorm();
  }
  Outcome apply(Dart e, double) {
    const std::size_t removed = root_.is_boundary(e, 1) ? 1 : 2;
    const Outcome outcome = tree_.operations().collapse(NodeId::root, e, Placement::at(0.5));
    if (outcome) done_.faces -= removed, ++done_.collapses;
    return outcome;
  }
  bool finished(double) const { return done_.faces <= faces_; }

 private:
  SurfaceTree& tree_;
  const Mesh& root_;
  const std::vector<OpenMesh::Vec3d>& points_;
  std::size_t faces_;
  Decimation& done_;
};

}  // namespace

Decimation decimate_tree(SurfaceTree& tree, std::size_t faces) {
  Decimation done{0, tree.root().capacity(2), 0};
  ShortestEdge policy(tree, faces, done);
  PriorityScheduler(tree.operations()).run(policy);
  done.checksum = checksum(tree.positions(),
                           [&](std::size_t v) { return tree.root().is_live(0, static_cast<Index>(v)); });
  return done;
}

Decimation decimate_by_decimater(SurfaceMesh& mesh, std::size_t faces) {
  OpenMesh::Decimater::DecimaterT<SurfaceMesh> decimater(mesh);
  OpenMesh::Decimater::ModEdgeLengthT<SurfaceMesh>::Handle edge_length;
  decimater.add(edge_length);
  decimater.module(edge_length).set_binary(false);
  decimater.initialize();
  const std::size_t before = mesh.n_faces();
  const std::size_t collapses = decimater.decimate_to_faces(0, faces);
  return {collapses, before - 2 * collapses, checksum(mesh)};
}

}  // namespace multimesh::bench
