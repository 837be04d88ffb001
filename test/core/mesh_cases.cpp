// SPDX-License-Identifier: BSD-3-Clause
#include "test/core/mesh_cases.hpp"

#include <random>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "test/core/bridge.hpp"
#include "test/support/solids.hpp"

namespace multimesh::test {

namespace {

std::unique_ptr<Mesh> make(const FacetList& list) {
  return make_mesh(list);
}

std::unique_ptr<Mesh> shaken(const FacetList& list, unsigned seed, int operations = 60) {
  auto mesh = make(list);
  shake(*mesh, seed, operations);
  return mesh;
}

FacetList chain(Index n) {
  FacetList list{1, n + 1, {}};
  for (Index i = 0; i < n; ++i) {
    list.corners.push_back(i);
    list.corners.push_back(i + 1);
  }
  return list;
}

FacetList loop(Index n) {
  FacetList list = chain(n);
  list.corners.back() = 0;
  list.vertices = n;
  return list;
}

//  0-->1<--2-->3    4<--5   and the triangle 6-7-8, every edge drawn in another direction
FacetList mixed_curves() {
  return {1, 9, {0, 1, 2, 1, 2, 3, 5, 4, 6, 7, 8, 7, 8, 6}};
}

FacetList joined(FacetList list, const FacetList& more) {
  for (const Index v : more.corners) list.corners.push_back(v + list.vertices);
  list.vertices += more.vertices;
  return list;
}

FacetList two_components() {
  return joined(grid(2, 1).facets, sphere(0).facets);
}

FacetList two_solids() {
  return joined(cone(sphere(0)).facets, three_cycle().facets);
}

/// The boundary of a 4-simplex: closed.
FacetList sphere3() {
  return tetrahedra({{1, 2, 3, 4}, {0, 2, 3, 4}, {0, 1, 3, 4}, {0, 1, 2, 4}, {0, 1, 2, 3}}).facets;
}

}  // namespace

/// Points, the second of three is dead.
std::unique_ptr<Mesh> points_with_a_dead_one() {
  auto mesh = make({0, 3, {0, 1, 2}});
  auto& om = dynamic_cast<openmesh::Connectivity&>(*mesh).openmesh();
  om.status(OpenMesh::VertexHandle(1)).set_deleted(true);
  return mesh;
}

const std::vector<MeshCase>& mesh_cases() {
  static const std::vector<MeshCase> cases{
      {"OnePoint",
       [] {
         return make({0, 1, {0}});
       }},
      {"Points",
       [] {
         return make({0, 4, {0, 1, 2, 3}});
       }},
      {"PointsWithADeadOne", points_with_a_dead_one},
      {"OneTriangle",
       [] {
         return make({2, 3, {0, 1, 2}});
       }},
      {"Tetrahedron",
       [] {
         return make({2, 4, {1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1}});
       }},
      {"Grid", [] { return make(grid(3, 4).facets); }},
      {"Annulus", [] { return make(annulus(5, 2).facets); }},
      {"Torus", [] { return make(torus(4, 5).facets); }},
      {"Sphere", [] { return make(sphere(1).facets); }},
      {"Disk", [] { return make(disk(7).facets); }},
      {"TwoComponents", [] { return make(two_components()); }},
      {"ShakenGrid", [] { return shaken(grid(3, 3).facets, 1); }},
      {"ShakenAnnulus", [] { return shaken(annulus(4, 2).facets, 2); }},
      {"ShakenTorus", [] { return shaken(torus(4, 4).facets, 3); }},
      {"ShakenTwoComponents", [] { return shaken(two_components(), 4); }},
      {"OneEdge",
       [] {
         return make({1, 2, {1, 0}});
       }},
      {"Chain", [] { return make(chain(6)); }},
      {"Loop", [] { return make(loop(5)); }},
      {"SmallestLoop", [] { return make(loop(3)); }},
      {"MixedCurves", [] { return make(mixed_curves()); }},
      {"ShakenChain", [] { return shaken(chain(6), 5); }},
      {"ShakenLoop", [] { return shaken(loop(6), 6); }},
      {"ShakenMixedCurves", [] { return shaken(mixed_curves(), 7); }},
      {"OneTetrahedron", [] { return make(single_tet().facets); }},
      {"OneEar", [] { return make(one_ear().facets); }},
      {"TwoEars", [] { return make(two_ears().facets); }},
      {"ThreeIncidentTets", [] { return make(three_incident_tets().facets); }},
      {"ThreeCycle", [] { return make(three_cycle().facets); }},
      {"FourCycle", [] { return make(four_cycle().facets); }},
      {"SixCycle", [] { return make(six_cycle().facets); }},
      {"Box", [] { return make(box(1, 2, 1).facets); }},
      {"Ball", [] { return make(cone(sphere(0)).facets); }},
      {"SolidTorus", [] { return make(layers(annulus(3, 1), 1).facets); }},
      {"Shell", [] { return make(layers(sphere(0), 1).facets); }},
      {"Sphere3", [] { return make(sphere3()); }},
      {"Torus3", [] { return make(torus3(3).facets); }},
      {"TwoSolids", [] { return make(two_solids()); }},
      {"ShakenTetrahedron", [] { return shaken(single_tet().facets, 8, 30); }},
      {"ShakenBox", [] { return shaken(box(1, 1, 1).facets, 9, 30); }},
      {"ShakenShell", [] { return shaken(layers(sphere(0), 1).facets, 10, 20); }},
      {"ShakenSphere3", [] { return shaken(sphere3(), 11, 30); }},
      {"ShakenTwoSolids", [] { return shaken(two_solids(), 12, 30); }}};
  return cases;
}

}  // namespace multimesh::test
