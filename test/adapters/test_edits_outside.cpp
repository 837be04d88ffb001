// SPDX-License-Identifier: BSD-3-Clause
// Edits behind the tree's back: with OpenMesh's own operations, on an attached mesh.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <functional>
#include <random>

#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using OpenMesh::VertexHandle;

class EditsOutside : public testing::Test {
 protected:
  static constexpr int n = 12;

  EditsOutside() : mesh_(make()), attached_(std::make_unique<openmesh::Attached<UserMesh>>(mesh_)) {
    // A curve along j = 6, from i = 2 to 9.
    curve_ = attached_->add_edges([&](OpenMesh::EdgeHandle e) {
      const auto h = mesh_.halfedge_handle(e, 0);
      const auto on_curve = [](VertexHandle v) {
        return v.idx() % (n + 1) == 6 && v.idx() / (n + 1) >= 2 && v.idx() / (n + 1) <= 9;
      };
      return on_curve(mesh_.from_vertex_handle(h)) && on_curve(mesh_.to_vertex_handle(h));
    });
  }
  static UserMesh make() {
    UserMesh mesh;
    mesh.request_vertex_status(), mesh.request_edge_status(), mesh.request_face_status();
    const Shape s = grid(n, n);
    for (const auto& p : s.points) mesh.add_vertex({p[0], p[1], p[2]});
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
      const auto v = s.facets.facet(f);
      mesh.add_face(mesh.vertex_handle(v[0]), mesh.vertex_handle(v[1]), mesh.vertex_handle(v[2]));
    }
    return mesh;
  }
  static VertexHandle at(int i, int j) { return VertexHandle(i * (n + 1) + j); }
  OpenMesh::HalfedgeHandle halfedge(int i, int j, int k, int l) {
    return mesh_.find_halfedge(at(i, j), at(k, l));
  }
  std::vector<int> words() const {
    std::vector<int> words;
    for (const auto h : mesh_.all_halfedges())
      for (const int i : {mesh_.to_vertex_handle(h).idx(), mesh_.next_halfedge_handle(h).idx(),
                          mesh_.face_handle(h).idx(), int(mesh_.status(mesh_.edge_handle(h)).bits())})
        words.push_back(i);
    return words;
  }
  bool is_refused(OpenMesh::HalfedgeHandle h) {
    bool refused = false;
    const auto expect_unchanged = [&](const std::function<void()>& call) {
      const auto before = words();
      try {
        call();
      } catch (const OutOfStepError&) {
        refused = true;
        EXPECT_EQ(words(), before);
      }
    };
    expect_unchanged([&] { (void)attached_->split(mesh_.edge_handle(h)); });
    return refused;
  }

  UserMesh mesh_;
  std::unique_ptr<openmesh::Attached<UserMesh>> attached_;
  NodeId curve_;
};

TEST_F(EditsOutside, AreNoticedBeforeAnythingIsTouched) {
  const auto h = halfedge(4, 3, 5, 3);
  mesh_.collapse(h);  // (4,3) -> (5,3), away from the curve
  for (const auto& near : {halfedge(5, 3, 6, 3), halfedge(5, 3, 5, 4), halfedge(3, 3, 5, 3)}) {
    ASSERT_TRUE(near.is_valid());
    EXPECT_TRUE(is_refused(near));
    EXPECT_THROW((void)attached_->operations().judge(NodeId::root, attached_->dart(near)), OutOfStepError);
    EXPECT_THROW((void)attached_->collapse(near), OutOfStepError);
    EXPECT_THROW((void)attached_->swap(mesh_.edge_handle(near)), OutOfStepError);
  }
  EXPECT_THROW((void)attached_->relocate(at(5, 3), {0, 0, 0}), OutOfStepError);
  EXPECT_THROW(attached_->tree().require_in_step(), OutOfStepError);
  EXPECT_THROW(attached_->garbage_collection(), OutOfStepError);
}

TEST_F(EditsOutside, AreNoticedFromAChild) {
  mesh_.collapse(halfedge(5, 6, 6, 6));  // on the curve itself
  const Mesh& curve = attached_->tree().mesh(curve_);
  std::size_t refused = 0;
  for (Index e = 0; e < curve.capacity(1); ++e) try {
      (void)attached_->operations().judge(curve_, curve.dart_of(1, e));
    } catch (const OutOfStepError&) {
      ++refused;
    }
  EXPECT_EQ(refused, 4U);  // with an end at (4,6), (5,6) or (6,6)
  EXPECT_THROW((void)attached_->operations().collapse(curve_, curve.dart_of(1, 3)), OutOfStepError);
}

TEST_F(EditsOutside, AreNoticedAnywhereIfElementsCameOrWent) {
  mesh_.add_vertex({0, 0, 0});
  EXPECT_TRUE(is_refused(halfedge(9, 9, 9, 10)));
  attached_->resync();  // harms no map
  EXPECT_FALSE(is_refused(halfedge(9, 9, 9, 10)));
}

TEST_F(EditsOutside, OfEveryKindAreNoticed) {
  struct Edit {
    const char* name;
    std::function<void(UserMesh&)> apply;
  };
  const auto find = [](UserMesh& m, int i, int j, int k, int l) {
    return m.find_halfedge(at(i, j), at(k, l));
  };
  const Edit edits[] = {
      {"flip", [&](UserMesh& m) { m.flip(m.edge_handle(find(m, 4, 3, 5, 3))); }},
      {"split",
       [&](UserMesh& m) {
         m.split(m.edge_handle(find(m, 4, 3, 5, 3)), m.add_vertex({0, 0, 0}));
       }},
      {"face",
       [&](UserMesh& m) {
         m.split(m.face_handle(find(m, 4, 3, 5, 3)), m.add_vertex({0, 0, 0}));
       }},
      {"delete", [&](UserMesh& m) { m.delete_face(m.face_handle(find(m, 4, 3, 5, 3)), false); }},
      {"vertex", [&](UserMesh& m) { m.delete_vertex(at(4, 3), false); }},
  };
  for (const Edit& edit : edits) {
    UserMesh mesh = make();
    openmesh::Attached attached(mesh);
    edit.apply(mesh);
    EXPECT_THROW(attached.tree().require_in_step(), OutOfStepError) << edit.name;
    const auto near = mesh.find_halfedge(at(5, 3), at(5, 2));
    EXPECT_THROW((void)attached.collapse(near), OutOfStepError) << edit.name;
  }
}

TEST_F(EditsOutside, ThatOnlyMoveThingsAreNone) {
  mesh_.set_point(at(3, 3), {9, 9, 9});
  mesh_.status(at(3, 3)).set_selected(true);
  mesh_.status(mesh_.edge_handle(halfedge(3, 3, 3, 4))).set_feature(true);
  mesh_.request_vertex_normals();
  EXPECT_FALSE(is_refused(halfedge(3, 3, 3, 4)));
  attached_->tree().require_in_step();
}

// The user collects the garbage of our operations.
TEST_F(EditsOutside, GarbageCollectionIsFollowed) {
  ASSERT_TRUE(attached_->collapse(halfedge(4, 3, 5, 3)));
  ASSERT_TRUE(attached_->collapse(halfedge(5, 6, 6, 6)));
  ASSERT_TRUE(attached_->split(mesh_.edge_handle(halfedge(7, 6, 8, 6)), 0.25));
  mesh_.garbage_collection();
  const auto any = *mesh_.halfedges_begin();
  EXPECT_THROW((void)attached_->split(mesh_.edge_handle(any)), OutOfStepError);
  VertexHandle last(n * (n + 1) + n);
  attached_->resync({{&last}, {}, {}, {}});
  EXPECT_EQ(validate(attached_->tree()), std::vector<std::string>{});
  EXPECT_FALSE(last.is_valid() && static_cast<std::size_t>(last.idx()) >= mesh_.n_vertices());
  EXPECT_EQ(mesh_.point(last), UserMesh::Point(n, n, 0));
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const OpenMesh::EdgeHandle e(static_cast<int>(random() % mesh_.n_edges()));
    if (mesh_.status(e).deleted()) continue;
    (void)(i % 2 ? attached_->split(e) : attached_->collapse(mesh_.halfedge_handle(e, 0)));
  }
  EXPECT_EQ(validate(attached_->tree()), std::vector<std::string>{});
  attached_->tree().require_in_step();
}

TEST_F(EditsOutside, AreFollowedWhereNoMapIsHarmed) {
  mesh_.collapse(halfedge(2, 2, 3, 2));
  mesh_.garbage_collection();
  attached_->resync();
  EXPECT_EQ(validate(attached_->tree()), std::vector<std::string>{});
  const Mesh& curve = attached_->tree().mesh(curve_);
  // The curve still lies where it was.
  for (Index e = 0; e < curve.capacity(1); ++e) {
    const auto h = attached_->halfedge(attached_->tree().to_root(curve_, curve.dart_of(1, e)));
    for (const auto v : {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)})
      EXPECT_EQ(mesh_.point(v)[1], 6) << v.idx();
  }
  EXPECT_FALSE(is_refused(mesh_.halfedge_handle(OpenMesh::EdgeHandle(0), 0)));
}

TEST_F(EditsOutside, AreRefusedForGoodWhereAMapIsLost) {
  mesh_.delete_vertex(at(5, 6), false);  // of the curve
  EXPECT_THROW(attached_->resync(), OutOfStepError);
  EXPECT_THROW((void)attached_->split(mesh_.edge_handle(halfedge(9, 9, 9, 10))), OutOfStepError);  // anywhere
  EXPECT_THROW(attached_->resync(), OutOfStepError);
  (void)attached_->tree().detach(curve_);
  attached_->resync();
  EXPECT_TRUE(attached_->split(mesh_.edge_handle(halfedge(9, 9, 9, 10))));
  EXPECT_EQ(validate(attached_->tree()), std::vector<std::string>{});
}

// The remaining vertices do not show what is missing: only the maps do.
TEST_F(EditsOutside, AreRefusedWhereAWholeComponentHasGone) {
  for (const bool collected : {false, true}) {
    UserMesh mesh = make();
    const auto a = mesh.add_vertex({20, 0, 0}), b = mesh.add_vertex({21, 0, 0}),
               c = mesh.add_vertex({20, 1, 0});
    const auto f = mesh.add_face(a, b, c);
    openmesh::Attached attached(mesh);
    const NodeId part = attached.add_faces([&](OpenMesh::FaceHandle x) { return x == f; });
    mesh.delete_face(f, true);
    if (collected) mesh.garbage_collection();
    EXPECT_THROW(attached.tree().require_in_step(), OutOfStepError);
    EXPECT_THROW(attached.resync(), OutOfStepError) << collected;
    (void)attached.tree().detach(part);
    attached.resync();
    EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
  }
}

TEST_F(EditsOutside, AreRefusedIfTheyAddWhatIsNoTriangle) {
  std::vector<VertexHandle> v;
  for (const auto& [x, y] : {std::pair{20, 0}, {21, 0}, {21, 1}, {20, 1}})
    v.push_back(mesh_.add_vertex({double(x), double(y), 0}));
  static_cast<OpenMesh::PolyConnectivity&>(mesh_).add_face(v);
  EXPECT_THROW(attached_->resync(), OutOfStepError);
}

TEST_F(EditsOutside, OurOwnOperationsAndTheirUndoingAreNone) {
  std::mt19937 random(5);
  for (int round = 0; round < 40; ++round) {
    Transaction scope = attached_->operations().transaction();
    for (int i = 0; i < 25; ++i) {
      const OpenMesh::EdgeHandle e(static_cast<int>(random() % mesh_.n_edges()));
      if (mesh_.status(e).deleted()) continue;
      const auto what = random() % 3;
      (void)(what == 0   ? attached_->split(e)
             : what == 1 ? attached_->collapse(mesh_.halfedge_handle(e, 0))
                         : attached_->swap(e));
    }
    ASSERT_NO_THROW(attached_->tree().require_in_step()) << round;
    if (round % 2) scope.commit();
  }
  ASSERT_NO_THROW(attached_->tree().require_in_step());
  attached_->garbage_collection();
  ASSERT_NO_THROW(attached_->tree().require_in_step());
}

TEST_F(EditsOutside, AreNotLookedForIfThereAreNone) {
  UserMesh mesh = make();
  openmesh::Attached attached(mesh, openmesh::Watching::off);
  EXPECT_FALSE(attached.tree().mesh(NodeId::root).is_watched());
  EXPECT_TRUE(attached.split(mesh.edge_handle(mesh.find_halfedge(at(3, 3), at(3, 4)))));
  attached.tree().require_in_step();
  attached.garbage_collection();
  EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
}

TEST_F(EditsOutside, ProtectedPropertiesAreNone) {
  attached_->operations().protect_properties(true);
  FunctionInvariant never("never", {}, [](const Event&) { return false; });
  attached_->operations().add(never);
  for (const auto e : mesh_.edges()) {
    EXPECT_FALSE(attached_->split(e));
    EXPECT_FALSE(attached_->collapse(mesh_.halfedge_handle(e, 0)));
    ASSERT_NO_THROW(attached_->tree().require_in_step());
  }
}

}  // namespace
}  // namespace multimesh::test
