// SPDX-License-Identifier: BSD-3-Clause
// validate() is tested by breaking one word at a time: each mutation must be reported.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/solids.hpp"

namespace multimesh::test {
namespace {

using OpenMesh::EdgeHandle, OpenMesh::FaceHandle, OpenMesh::HalfedgeHandle, OpenMesh::VertexHandle;

/// A fan of six triangles; below it a patch of five and its boundary; a curve; points on the fan and on the
/// boundary. Some elements are dead.
Tree make_tree() {
  Tree t = drawn({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
  const NodeId patch =
      add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}}),
                {0, 1, 2, 3, 4, 5, 6});
  const NodeId rim = t.add_boundary(patch);
  (void)add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}}), {1, 0, 4});
  (void)t.add_tagged(rim, 0, [](Index v) { return v % 2 == 0; });
  (void)t.add_tagged(NodeId::root, 0, [](Index v) { return v == 0 || v == 3; });
  EXPECT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 2)));
  EXPECT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 2, 3)));
  EXPECT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 3, 8), Placement::keep_a()));
  return t;
}

/// Six tetrahedra around 2-3; below them the faces around 2 and a curve on those; three tetrahedra, and their
/// boundary; a curve; points. Some elements are dead.
Tree make_solid_tree() {
  Tree t(six_cycle());
  const NodeId fan =
      add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}}), {2, 1, 0, 4, 5, 7});
  (void)add_drawn(t, fan, segments({{0, 1}, {1, 2}}), {3, 0, 1});
  (void)t.add_boundary(t.add_tagged(NodeId::root, 3, [](Index tet) { return tet < 3; }));
  (void)add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}}), {6, 3, 5});
  (void)t.add_tagged(fan, 0, [](Index v) { return v == 0 || v == 4; });
  (void)t.add_tagged(NodeId::root, 0, [](Index v) { return v == 2 || v == 6; });
  EXPECT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 2, 3)));
  EXPECT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 2)));
  EXPECT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 2, 8), Placement::keep_a()));
  return t;
}

class Mutation : public testing::Test {
 protected:
  explicit Mutation(Tree tree = make_tree()) : t_(std::move(tree)), tree_(*t_.tree) {
    EXPECT_EQ(validate(tree_), std::vector<std::string>{});
  }

  /// Calls change(), expects a report, then calls restore().
  template <class Change, class Restore>
  void expect_reported(const std::string& what, const Change& change, const Restore& restore) {
    change();
    EXPECT_FALSE(validate(tree_).empty()) << "not seen: " << what;
    restore();
    ASSERT_TRUE(validate(tree_).empty()) << "the test did not put it back: " << what;
  }
  void with_anchor(NodeId n, Index f, Anchor broken, const std::string& what) {
    Mesh& mesh = tree_.mesh(n);
    const Anchor old = mesh.anchor(f);
    expect_reported(
        what + ", mesh " + std::to_string(index(n)) + ", facet " + std::to_string(f),
        [&] { mesh.set_anchor(f, broken); }, [&] { mesh.set_anchor(f, old); });
  }
  /// test(node, live facet) for all children.
  template <class Test>
  void on_anchors(const Test& test) {
    for (const NodeId n : tree_.nodes().subspan(1))
      for (const Dart d : simplices_of(tree_.mesh(n), tree_.mesh(n).dimension()))
        test(n, tree_.mesh(n).facet(d));
  }
  template <class Test>
  void on_meshes(const Test& test) {
    for (const NodeId n : tree_.nodes()) {
      Mesh& mesh = tree_.mesh(n);
      test(mesh, dynamic_cast<openmesh::Connectivity&>(mesh).openmesh(),
           "mesh " + std::to_string(index(n)) + ", element ");
    }
  }
  /// Link sets are numbered as the children were added.
  Mesh::LinkSet links_of(NodeId child) const {
    const auto all = tree_.children(tree_.parent(child));
    return static_cast<Mesh::LinkSet>(std::find(all.begin(), all.end(), child) - all.begin());
  }
  /// A facet all of whose sides are in the boundary shares no vertex with another one (vertices are
  /// manifold): turning its anchor gives another valid map.
  bool stands_alone(const Mesh& mesh, Index f) const {
    if (mesh.dimension() == 0) return false;  // has one dart, which cannot be turned
    const Dart d = mesh.dart_of(mesh.dimension(), f);
    for (std::uint8_t p = 0; p < number_of_orders(mesh.dimension()); ++p)
      if (!mesh.is_boundary(mesh.reorder(d, {p}), mesh.dimension() - 1)) return false;
    return true;
  }

  Tree t_;
  MultiMesh& tree_;
};

class MutationOfMaps : public Mutation, public testing::WithParamInterface<bool> {
 protected:
  MutationOfMaps() : Mutation(GetParam() ? make_solid_tree() : make_tree()) {}
};

INSTANTIATE_TEST_SUITE_P(Trees, MutationOfMaps, testing::Bool(),
                         [](const auto& solid) { return solid.param ? "Solid" : "Surface"; });

TEST_P(MutationOfMaps, OfAnAnchorsOwnDartIsReported) {
  on_anchors([&](NodeId n, Index f) {
    const Mesh& mesh = tree_.mesh(n);
    Anchor a = mesh.anchor(f);
    a.own = no_dart;
    with_anchor(n, f, a, "no own dart");
    for (const Dart other : simplices_of(mesh, mesh.dimension()))
      if (mesh.facet(other) != f) {
        a.own = other;
        with_anchor(n, f, a, "own dart of another facet");
      }
  });
}

TEST_P(MutationOfMaps, OfAnAnchorsParentDartIsReported) {
  on_anchors([&](NodeId n, Index f) {
    const Mesh &mesh = tree_.mesh(n), &above = tree_.mesh(tree_.parent(n));
    const Anchor old = mesh.anchor(f);
    with_anchor(n, f, {old.own, no_dart}, "no parent dart");
    for (const Dart other : all_darts(above)) {
      // Excluded: other names of the same dart of the same simplex (it lies in several parent facets).
      Index v[4], w[4];
      above.vertices(other, v), above.vertices(old.parent, w);
      if (std::equal(v, v + mesh.dimension() + 1, w)) continue;
      if (stands_alone(mesh, f) &&
          above.simplex(other, mesh.dimension()) == above.simplex(old.parent, mesh.dimension()))
        continue;
      with_anchor(n, f, {old.own, other}, "parent dart " + std::to_string(code(other)));
    }
  });
}

TEST_P(MutationOfMaps, ThatTurnsAnAnchorIsReported) {
  on_anchors([&](NodeId n, Index f) {
    const Mesh& mesh = tree_.mesh(n);
    if (stands_alone(mesh, f)) return;
    const Anchor old = mesh.anchor(f);
    for (std::uint8_t p = 1; p < number_of_orders(mesh.dimension()); ++p)
      with_anchor(n, f, {mesh.reorder(old.own, {p}), old.parent}, "turned anchor");
  });
}

TEST_P(MutationOfMaps, ThatSwapsTwoAnchorsIsReported) {
  on_anchors([&](NodeId n, Index f) {
    Mesh& mesh = tree_.mesh(n);
    for (Index g = 0; g < f; ++g) {
      if (!mesh.is_live(mesh.dimension(), g)) continue;
      const Anchor x = mesh.anchor(f), y = mesh.anchor(g);
      expect_reported(
          "swapped anchors", [&] { mesh.set_anchor(f, y), mesh.set_anchor(g, x); },
          [&] { mesh.set_anchor(f, x), mesh.set_anchor(g, y); });
      expect_reported(
          "swapped parents",
          [&] {
            mesh.set_anchor(f, {x.own, y.parent}), mesh.set_anchor(g, {y.own, x.parent});
          },
          [&] { mesh.set_anchor(f, x), mesh.set_anchor(g, y); });
    }
  });
}

TEST_P(MutationOfMaps, OfALinkIsReported) {
  for (const NodeId n : tree_.nodes().subspan(1)) {
    const Mesh& mesh = tree_.mesh(n);
    Mesh& above = tree_.mesh(tree_.parent(n));
    const Mesh::LinkSet links = links_of(n);
    // Links of dead simplices cannot be observed: they are excluded.
    for (const Dart s : simplices_of(above, mesh.dimension())) {
      const Index old = above.link(links, s);
      std::vector<Index> others{no_index, mesh.capacity(mesh.dimension()) + 5};
      for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f) others.push_back(f);  // dead ones too
      for (const Index f : others)
        if (f != old)
          expect_reported(
              "link " + std::to_string(old) + " -> " + std::to_string(f),
              [&] { above.set_link(links, s, f); }, [&] { above.set_link(links, s, old); });
    }
  }
}

TEST_F(Mutation, OfLivenessIsReported) {
  on_meshes([&](Mesh& mesh, OpenMesh::PolyConnectivity& om, const std::string& where) {
    const auto toggle = [&](auto handle, int k) {
      const bool dead = om.status(handle).deleted();
      // A dead vertex has no halfedge any more: alive, it would be an isolated vertex, which is allowed.
      if (k == 0 && dead) return;
      expect_reported(
          where + std::to_string(handle.idx()) + " of dimension " + std::to_string(k) +
              (dead ? " revived" : " killed"),
          [&] { om.status(handle).set_deleted(!dead); }, [&] { om.status(handle).set_deleted(dead); });
    };
    for (const auto v : om.all_vertices()) toggle(VertexHandle(v), 0);
    for (const auto e : om.all_edges()) toggle(EdgeHandle(e), 1);
    if (mesh.dimension() == 2)
      for (const auto f : om.all_faces()) toggle(FaceHandle(f), 2);
  });
}

/// Live halfedges of all meshes.
template <class Test>
void on_halfedges(OpenMesh::PolyConnectivity& om, const Test& test) {
  for (int h = 0; h < static_cast<int>(om.n_halfedges()); ++h)
    if (!om.status(EdgeHandle(h / 2)).deleted()) test(HalfedgeHandle(h));
}

TEST_F(Mutation, OfNextIsReported) {
  on_meshes([&](Mesh&, OpenMesh::PolyConnectivity& om, const std::string& where) {
    on_halfedges(om, [&](HalfedgeHandle h) {
      const auto next = om.next_halfedge_handle(h);
      on_halfedges(om, [&](HalfedgeHandle other) {
        if (other == next) return;
        const auto prev = om.prev_halfedge_handle(other);
        expect_reported(
            where + std::to_string(h.idx()) + ", next", [&] { om.set_next_halfedge_handle(h, other); },
            [&] { om.set_next_halfedge_handle(h, next), om.set_next_halfedge_handle(prev, other); });
      });
    });
  });
}

TEST_F(Mutation, OfToVertexIsReported) {
  on_meshes([&](Mesh&, OpenMesh::PolyConnectivity& om, const std::string& where) {
    on_halfedges(om, [&](HalfedgeHandle h) {
      const auto old = om.to_vertex_handle(h);
      for (const auto v : om.all_vertices())
        if (VertexHandle(v) != old)
          expect_reported(
              where + std::to_string(h.idx()) + ", to-vertex", [&] { om.set_vertex_handle(h, v); },
              [&] { om.set_vertex_handle(h, old); });
    });
  });
}

TEST_F(Mutation, OfFaceIsReported) {
  on_meshes([&](Mesh& mesh, OpenMesh::PolyConnectivity& om, const std::string& where) {
    on_halfedges(om, [&](HalfedgeHandle h) {
      const auto old = om.face_handle(h);
      std::vector<FaceHandle> others{FaceHandle(-1)};
      if (mesh.dimension() == 2)
        for (const auto f : om.all_faces()) others.push_back(f);
      for (const FaceHandle f : others)
        if (f != old)
          expect_reported(
              where + std::to_string(h.idx()) + ", face", [&] { om.set_face_handle(h, f); },
              [&] { om.set_face_handle(h, old); });
    });
  });
}

TEST_F(Mutation, OfAVertexOrFacesHalfedgeIsReported) {
  on_meshes([&](Mesh& mesh, OpenMesh::PolyConnectivity& om, const std::string& where) {
    on_halfedges(om, [&](HalfedgeHandle h) {
      for (const auto v : om.all_vertices()) {
        // Another outgoing halfedge does as well, if OpenMesh's rule (a boundary one if any) is kept.
        if (om.status(v).deleted()) continue;
        const bool rule = mesh.dimension() == 1 || !om.is_boundary(v) || om.is_boundary(h);
        if (om.from_vertex_handle(h) == v && rule) continue;
        const auto old = om.halfedge_handle(v);
        expect_reported(
            where + std::to_string(v.idx()) + ", vertex", [&] { om.set_halfedge_handle(v, h); },
            [&] { om.set_halfedge_handle(v, old); });
      }
      for (const auto f : om.all_faces()) {
        if (om.status(f).deleted() || om.face_handle(h) == f) continue;
        const auto old = om.halfedge_handle(f);
        expect_reported(
            where + std::to_string(f.idx()) + ", face", [&] { om.set_halfedge_handle(f, h); },
            [&] { om.set_halfedge_handle(f, old); });
      }
    });
    for (const auto v : om.all_vertices()) {
      if (om.status(v).deleted() || !om.halfedge_handle(v).is_valid()) continue;
      const auto old = om.halfedge_handle(v);
      expect_reported(
          where + std::to_string(v.idx()) + ", vertex without halfedge",
          [&] { om.set_halfedge_handle(v, HalfedgeHandle()); }, [&] { om.set_halfedge_handle(v, old); });
    }
  });
}

class MutationOfSolids : public Mutation {
 protected:
  MutationOfSolids() : Mutation(make_solid_tree()) {}
  /// test(mesh, live tetrahedron, its words): four corners, then the neighbours beyond the faces opposite.
  template <class Test>
  void on_tetrahedra(const Test& test) {
    for (const NodeId n : tree_.nodes()) {
      auto* mesh = dynamic_cast<tet::TetMesh*>(&tree_.mesh(n));
      if (!mesh) continue;
      for (Index t = 0; t < mesh->capacity(3); ++t)
        if (mesh->is_live(3, t)) test(*mesh, t, const_cast<Index*>(mesh->corners(t)));
    }
  }
  void with_word(Index& word, Index broken, const std::string& what) {
    const Index old = word;
    if (broken == old) return;
    expect_reported(
        what + " " + std::to_string(old) + " -> " + std::to_string(broken), [&] { word = broken; },
        [&] { word = old; });
  }
};

TEST_F(MutationOfSolids, OfACornerIsReported) {
  on_tetrahedra([&](const tet::TetMesh& mesh, Index, Index* words) {
    for (int i = 0; i < 4; ++i)
      for (Index v = 0; v < mesh.capacity(0); ++v) with_word(words[i], v, "corner");
  });
}

TEST_F(MutationOfSolids, OfANeighbourIsReported) {
  on_tetrahedra([&](const tet::TetMesh& mesh, Index, Index* words) {
    for (int i = 4; i < 8; ++i) {
      with_word(words[i], no_index, "no neighbour");
      for (Index t = 0; t < mesh.capacity(3); ++t)
        for (Index p = 0; p < 24; ++p) with_word(words[i], t << 5 | p, "neighbour");
    }
  });
}

TEST_F(MutationOfSolids, OfTwoCornersIsReported) {
  on_tetrahedra([&](const tet::TetMesh&, Index, Index* words) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        expect_reported(
            "corners exchanged", [&] { std::swap(words[i], words[j]); },
            [&] { std::swap(words[i], words[j]); });
  });
}

//      2          A flip of 0-3 where 1-2 is an edge already makes it double.
//     /|\         .
//    / 0 \        (0,1,3), (0,3,2), (0,2,1): an open tetrahedron
//   1-----3
TEST(Validate, ReportsADoubleEdge) {
  Tree t = drawn({{0, 1, 3}, {0, 3, 2}, {0, 2, 1}});
  Mesh& mesh = t.tree->mesh(NodeId::root);
  const Dart e = edge(t, NodeId::root, 0, 3);
  ASSERT_FALSE(mesh.can_flip(e));
  mesh.flip_edge(e);
  EXPECT_FALSE(validate(*t.tree).empty());
}

TEST(Validate, ReportsAPinchedVertex) {
  Tree t = drawn({{0, 1, 2}, {3, 4, 5}, {0, 2, 6}, {3, 5, 7}});
  auto& om = dynamic_cast<openmesh::Connectivity&>(t.tree->mesh(NodeId::root)).openmesh();
  for (int h = 0; h < static_cast<int>(om.n_halfedges()); ++h)
    if (om.to_vertex_handle(HalfedgeHandle(h)).idx() == 3)
      om.set_vertex_handle(HalfedgeHandle(h), VertexHandle(0));
  om.status(VertexHandle(3)).set_deleted(true);
  EXPECT_FALSE(validate(*t.tree).empty());
}

TEST(Validate, NamesTheMeshAndTheElement) {
  Tree t = make_tree();
  Mesh& mesh = t.tree->mesh(NodeId{1});
  const Index f = mesh.facet(simplices_of(mesh, 2).back());
  mesh.set_anchor(f, {mesh.anchor(f).own, no_dart});
  const auto problems = validate(*t.tree);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("mesh 1"), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find("facet " + std::to_string(f)), std::string::npos) << problems[0];
}

}  // namespace
}  // namespace multimesh::test
