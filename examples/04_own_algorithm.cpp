// SPDX-License-Identifier: BSD-3-Clause
// An algorithm of your own: short edges are collapsed, shortest first, until all are long enough. It is
// written for one mesh; half of the surface is a mesh of its own, below it, and follows.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <iostream>
#include <numeric>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/scheduler.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;
using OpenMesh::Vec3d;
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

constexpr int most_merged = 12;

class Coarsening {
 public:
  Coarsening(MultiMesh& tree, UserMesh& mesh, OpenMesh::VPropHandleT<int> merged, double shortest)
      : root_(tree.mesh(NodeId::root)),
        shortest_(shortest),
        position_(NodeId::root, mesh.property(mesh.points_property_handle()).data_vector()),
        // An attribute with a rule: how many vertices of the input a vertex represents.
        merged_(NodeId::root, mesh.property(merged).data_vector(),
                [this](Operation, const VertexChange& c) { return merged_[c.a] + merged_[c.b]; }),
        // An invariant, evaluated before: nothing has to be undone if it fails.
        few_merged_("few merged",
                    [this](const Event& e) {
                      const Dart a = e.copies[0].dart, b = root_.switch_dart(a, 0);
                      return merged_[root_.vertex(a)] + merged_[root_.vertex(b)] <= most_merged;
                    }),
        propagation_(tree) {
    propagation_.add(position_).add(merged_).add(few_merged_);
  }

  // The scheduler's policy: cost, operation, end.
  std::optional<double> cost(Dart e) const {
    return (position_[root_.vertex(e)] - position_[root_.vertex(root_.switch_dart(e, 0))]).norm();
  }
  Outcome apply(Dart e, double) { return propagation_.collapse(NodeId::root, e, Placement::at(0.5)); }
  bool finished(double next_cost) const { return next_cost >= shortest_; }

  void run() { PriorityScheduler(propagation_).run(*this); }
  const Statistics& statistics() const { return propagation_.statistics(); }

 private:
  const Mesh& root_;
  double shortest_;
  VertexAttribute<Vec3d> position_;
  VertexAttribute<int> merged_;
  FunctionInvariant few_merged_;
  Propagation propagation_;
};

bool expect(bool fact, const char* what) {
  if (!fact) std::cerr << "wrong: " << what << '\n';
  return fact;
}

int main(int argc, char** argv) {
  UserMesh mesh;
  if (argc != 2 || !OpenMesh::IO::read_mesh(mesh, argv[1])) return 2;
  OpenMesh::VPropHandleT<int> merged;
  mesh.add_property(merged, "merged");
  for (const auto v : mesh.vertices()) mesh.property(merged, v) = 1;

  MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(mesh));
  const auto left = [&](Index f) { return mesh.calc_face_centroid(mesh.face_handle(f))[0] < 0; };
  const NodeId half = add_child_from_tags(tree, NodeId::root, 2, left, openmesh::make_mesh);
  const MeshReport before = report(tree.mesh(NodeId::root)), half_before = report(tree.mesh(half));

  Coarsening coarsening(tree, mesh, merged, 0.05);
  coarsening.run();
  tree.compact();  // now mesh.vertices() are the remaining ones
  const MeshReport after = report(tree.mesh(NodeId::root)), half_after = report(tree.mesh(half));
  const auto same_type = [](const MeshReport& x, const MeshReport& y) {
    return x.genus == y.genus && x.boundary == y.boundary && x.components == y.components;
  };
  bool ok = expect(validate(tree).empty() && after.faces < before.faces / 2, "it coarsens");
  ok &= expect(same_type(after, before) && same_type(half_after, half_before), "both keep their topology");
  int sum = 0;
  for (const auto v : mesh.vertices()) {
    sum += mesh.property(merged, v);
    ok &= expect(mesh.property(merged, v) <= most_merged, "the invariant holds");
  }
  const Statistics& s = coarsening.statistics();
  const auto refused = std::accumulate(s.refused.begin(), s.refused.end(), std::size_t{0});
  ok &= expect(sum == static_cast<int>(before.vertices) && s.done + mesh.n_vertices() == before.vertices,
               "no vertex is lost");
  ok &= expect(s.tried == s.done + refused && s.refused_by(Check::invariant) > 0, "every try is counted");
  std::cout << before.faces << " faces -> " << after.faces << "; refused " << refused << " of " << s.tried
            << '\n';
  return ok ? 0 : 1;
}
