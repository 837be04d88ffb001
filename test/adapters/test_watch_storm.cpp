// SPDX-License-Identifier: BSD-3-Clause
// Random operations on an attached mesh, in nested transactions, half of them undone, with our garbage
// collections and the user's in between: the watch must always agree with the mesh.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

template <class Mesh>
class WatchStorm : public testing::Test {
 protected:
  using Tree = openmesh::Attached<Mesh>;

  OpenMesh::EdgeHandle edge() { return OpenMesh::EdgeHandle(static_cast<int>(random_() % mesh_.n_edges())); }
  void operate(Tree& tree) {
    const auto e = edge();
    if (mesh_.status(e).deleted()) return;
    const auto what = random_() % 8;
    const Outcome o = what < 2 && mesh_.n_faces() < 4000 ? tree.split(e, 0.25)
                      : what < 5 ? tree.collapse(mesh_.halfedge_handle(e, 0), Placement::at(0.5))
                                 : tree.swap(e);
    done_ += bool(o);
  }
  void nest(Tree& tree, int depth, int count) {
    Transaction scope = tree.operations().transaction();
    for (int i = 0; i < count; ++i) {
      operate(tree);
      if (depth < 3 && random_() % 10 == 0) nest(tree, depth + 1, 5);
    }
    if (random_() % 2) scope.commit();
  }

  Mesh mesh_;
  std::mt19937 random_;
  std::size_t done_ = 0;
};
using Meshes = testing::Types<DoubleMesh, FloatMesh>;
TYPED_TEST_SUITE(WatchStorm, Meshes);

TYPED_TEST(WatchStorm, KeepsInStep) {
  make_torus(this->mesh_, 20, 14, 2, true);
  openmesh::Attached attached(this->mesh_);
  (void)attached.add_texture();
  attached.forbid_flips();
  for (int round = 0; round < 150; ++round) {
    attached.operations().protect_properties(round % 3 == 0);
    this->nest(attached, 0, 30);
    ASSERT_NO_THROW(attached.tree().require_in_step()) << round;
    if (round % 10 == 5) attached.garbage_collection();
    if (round % 10 == 9) {
      this->mesh_.garbage_collection();
      attached.resync();
    }
    if (round % 5 == 4) {
      ASSERT_EQ(validate(attached.tree()), std::vector<std::string>{}) << round;
    }
  }
  EXPECT_GT(this->done_, 1000U);
}

}  // namespace
}  // namespace multimesh::test
