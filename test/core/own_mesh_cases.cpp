// SPDX-License-Identifier: BSD-3-Clause
// The conformance suite over the mesh type of examples/09_own_mesh.cpp, as a user would run it on a type of
// their own.
#include "examples/own_mesh.hpp"
#include "test/core/mesh_cases.hpp"

namespace multimesh::test {

namespace {

using Edges = std::vector<std::array<Index, 2>>;

std::unique_ptr<Mesh> shaken(Edges edges, unsigned seed) {
  auto mesh = std::make_unique<OwnMesh>(std::move(edges));
  shake(*mesh, seed, 40);
  return mesh;
}

}  // namespace

const std::vector<MeshCase>& mesh_cases() {
  static const Edges chain{{0, 1}, {1, 2}, {2, 3}}, loop{{0, 1}, {2, 1}, {2, 3}, {3, 0}};
  static const Edges both{{0, 1}, {2, 1}, {3, 4}, {4, 5}, {5, 3}};
  static const std::vector<MeshCase> cases{
      {"OwnEdge",
       [] {
         return std::make_unique<OwnMesh>(Edges{{0, 1}});
       }},
      {"OwnChain", [] { return std::make_unique<OwnMesh>(chain); }},
      {"OwnLoop", [] { return std::make_unique<OwnMesh>(loop); }},
      {"OwnChainAndLoop", [] { return std::make_unique<OwnMesh>(both); }},
      {"OwnShakenChain", [] { return shaken(chain, 1); }},
      {"OwnShakenBoth", [] { return shaken(both, 2); }}};
  return cases;
}

}  // namespace multimesh::test
