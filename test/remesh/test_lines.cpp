// SPDX-License-Identifier: BSD-3-Clause
// The numbers of lines, which operations hand on from edge to edge, say at the end what the maps say.
#include <gtest/gtest.h>

#include "multimesh/algorithms/remeshing/remesher.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

TEST(LineNumbers, StayWithTheirLines) {
  for (const double length : {0.12, 0.3, 0.6, 1.2}) {
    DoubleMesh mesh;
    make_torus(mesh, 40, 24, 3, true);
    openmesh::Attached attached(mesh);
    (void)attached.add_texture();
    RemeshOptions options;
    options.length = length;
    options.iterations = 4;
    const Embedding all = embedding(attached);
    EmbeddedMesh surface(all, NodeId::root);
    remeshing::Remesher remesher(surface, options);
    const auto result = remesher.run();
    EXPECT_GT(result.moves, 0U);
    Strata strata(attached.tree());
    const Mesh& root = attached.tree().mesh(NodeId::root);
    std::size_t wrong = 0, lines = 0;
    for (Index e = 0; e < root.capacity(1); ++e) {
      if (!root.is_live(1, e)) continue;
      lines += remesher.lines()[e] != 0;
      wrong += (remesher.lines()[e] == 0) != strata.is_plain(root.dart_of(1, e));
    }
    EXPECT_GT(lines, 10U);
    EXPECT_EQ(wrong, 0U) << "length " << length;
  }
}

}  // namespace
}  // namespace multimesh::test
