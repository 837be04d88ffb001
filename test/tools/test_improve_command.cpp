// SPDX-License-Identifier: BSD-3-Clause
// `improve`, end to end.
#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

#ifdef MULTIMESH_WITH_IMPROVE

class ImproveCommand : public ProgramTest {
 protected:
  static std::string data(const std::string& name) { return MULTIMESH_TEST_DATA "/" + name; }

  /// What no improvement may change, of the mesh in a file.
  Json kept(const std::string& name) const {
    Json kept = info(name)["meshes"]["tetrahedra"];
    for (const char* changes : {"vertices", "edges", "faces", "tetrahedra"}) kept.erase(changes);
    return kept;
  }
  void expect_kept(const std::string& in, const Arguments& more) const {
    Arguments arguments{"improve", in, "-o", "out.msh"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    ASSERT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(kept("out.msh"), kept(in)) << in;
  }
};

TEST_F(ImproveCommand, KeepsMeshesWhosePointsHaveAnnularLinksWhole) {
  expect_kept(data("mini22.msh"), {"--edge-length", "0.3"});
  expect_kept(data("mini_annulus.msh"), {"--target-amips", "4"});
  expect_kept(data("mini_annulus.msh"), {"--target-amips", "4", "--edge-length", "0.2"});
}

TEST_F(ImproveCommand, InfoDescribesTheMeshInTheFileNotTheCutOne) {
  const Json m = info(data("mini_annulus.msh"))["meshes"]["tetrahedra"];
  EXPECT_EQ(m["euler_characteristic"], 2);
  EXPECT_EQ(m["cavities"], 1);
  EXPECT_EQ(m["components"], 1);
}

#ifdef MULTIMESH_WITH_TETGEN
TEST_F(ImproveCommand, KeepsACavityThatTouchesTheOutside) {
  ASSERT_EQ(run({"tetrahedralize", data("cavity_touch.obj"), "-o", "in.msh"}).status, 0);
  expect_kept("in.msh", {});
  expect_kept("in.msh", {"--target-amips", "5", "--edge-length", "0.2"});
}
#endif

#endif

}  // namespace
}  // namespace multimesh::tools::test
