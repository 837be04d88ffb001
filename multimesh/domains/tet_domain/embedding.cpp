// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/embedding.hpp"

#include "multimesh/domains/joined_mesh.hpp"
#include "multimesh/domains/tet_domain.hpp"

namespace multimesh {

namespace {

bool has_required(const TetDomain& domain) {
  for (const NodeId n : domain.tree().nodes()) {
    const Mesh& mesh = domain.tree().mesh(n);
    for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
      if (mesh.is_live(mesh.dimension(), f) && (domain.flags(mesh.dimension(), f) & required_simplex))
        return true;
  }
  return false;
}

}  // namespace

Embedding TetDomain::embedding() {
  Embedding e(tree());
  e.set(LegalityOptions{.contact = true});
  auto& positions = e.add<VertexAttribute<Point>>(NodeId::root, points().values);
  e.keep_orientation(e.add_coordinates(positions, Embedding::Kind::space));
  e.add<KeepsJoinedMesh>(*this);
  if (report().copied_vertices > 0)
    e.tell_kept_edges(NodeId::root, [this](Dart edge) { return is_copied_edge(edge); });
  e.tell_parts(NodeId::root, regions().values);
  if (has_required(*this))
    e.keep("required simplices stay", [this](NodeId n, Index f) {
      return (flags(tree().mesh(n).dimension(), f) & required_simplex) != 0;
    });
  return e;
}

}  // namespace multimesh
