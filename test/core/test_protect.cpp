// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/support/solids.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

/// A value that none of our journals covers.
struct Label {
  std::string text;
  std::vector<int> numbers;
};

using Labels = std::vector<Label>;

class ProtectedProperties : public testing::Test {
 protected:
  ProtectedProperties() : tree(grid(4, 4)) {
    auto& om = dynamic_cast<openmesh::Connectivity&>(tree.tree->mesh(NodeId::root)).openmesh();
    om.add_property(of_vertices, "label");
    om.add_property(of_faces, "label");
    om.add_property(of_edges, "label");
    om.add_property(of_halfedges, "label");
    fill(om.property(of_vertices).data_vector(), "v");
    fill(om.property(of_faces).data_vector(), "f");
    fill(om.property(of_edges).data_vector(), "e");
    fill(om.property(of_halfedges).data_vector(), "h");
    this->om = &om;
  }
  static void fill(Labels& labels, const char* kind) {
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = {kind + std::to_string(i), {int(i)}};
  }
  /// All labels, in one text.
  std::string labels() const {
    std::string all;
    for (const Labels* list :
         {&om->property(of_vertices).data_vector(), &om->property(of_faces).data_vector(),
          &om->property(of_edges).data_vector(), &om->property(of_halfedges).data_vector()})
      for (const Label& l : *list)
        all += l.text + ":" + std::to_string(l.numbers.empty() ? -1 : l.numbers[0]) + " ";
    return all;
  }
  /// Overwrites every label around a vertex: what a user's rule might do.
  void scribble(const Event& event) {
    const Mesh& mesh = event.tree.mesh(NodeId::root);
    DartBuffer star;
    mesh.star(event.copies[0].dart, 0, star);
    for (const Dart d : star) {
      om->property(of_vertices).data_vector()[mesh.vertex(d)].text = "changed";
      om->property(of_faces).data_vector()[mesh.facet(d)] = {"changed", {}};
      om->property(of_edges).data_vector()[mesh.simplex(d, 1)].numbers.clear();
      om->property(of_halfedges).data_vector()[2 * mesh.simplex(d, 1)].text = "changed";
    }
  }

  Tree tree;
  OpenMesh::PolyConnectivity* om = nullptr;
  OpenMesh::VPropHandleT<Label> of_vertices;
  OpenMesh::FPropHandleT<Label> of_faces;
  OpenMesh::EPropHandleT<Label> of_edges;
  OpenMesh::HPropHandleT<Label> of_halfedges;
};

TEST_F(ProtectedProperties, AreRestoredWhenAnInvariantFailsAfterTheyWereWritten) {
  FunctionInvariant scribbling("scribbling", {}, [&](const Event& e) { return scribble(e), false; });
  tree.operations->add(scribbling).protect_properties(true);
  const std::string before = labels();
  const Mesh& mesh = tree.tree->mesh(NodeId::root);
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    ASSERT_FALSE(tree.operations->collapse(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "collapse of edge " << e;
    ASSERT_FALSE(tree.operations->split(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "split of edge " << e;
    ASSERT_FALSE(tree.operations->swap(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "swap of edge " << e;
  }
}

TEST_F(ProtectedProperties, AreRestoredThroughNestedTransactions) {
  FunctionInvariant scribbling("scribbling", {}, [&](const Event& e) { return scribble(e), true; });
  tree.operations->add(scribbling).protect_properties(true);
  const std::string before = labels();
  const Mesh& mesh = tree.tree->mesh(NodeId::root);
  const Index edges = mesh.capacity(1), faces = mesh.capacity(2);
  {
    const Transaction outer(*tree.tree, {});
    for (Index e = 0; e < edges; e += 3) {
      if (mesh.is_live(1, e)) (void)tree.operations->split(NodeId::root, mesh.dart_of(1, e));
      if (mesh.is_live(1, e + 1)) (void)tree.operations->collapse(NodeId::root, mesh.dart_of(1, e + 1));
    }
    EXPECT_NE(labels(), before);
    EXPECT_EQ(validate(*tree.tree), std::vector<std::string>());
  }
  EXPECT_EQ(labels(), before);
  EXPECT_EQ(mesh.capacity(1), edges);
  EXPECT_EQ(mesh.capacity(2), faces);
}

TEST_F(ProtectedProperties, CostNoElementsOnceCommitted) {
  tree.operations->protect_properties(true);
  const Mesh& mesh = tree.tree->mesh(NodeId::root);
  const Index vertices = mesh.capacity(0), edges = mesh.capacity(1), faces = mesh.capacity(2);
  ASSERT_TRUE(tree.operations->collapse(NodeId::root, mesh.dart_of(1, edges / 2)));
  EXPECT_EQ(mesh.capacity(0), vertices);
  EXPECT_EQ(mesh.capacity(1), edges);
  EXPECT_EQ(mesh.capacity(2), faces);
  EXPECT_EQ(validate(*tree.tree), std::vector<std::string>());
}

/// The same on a tetrahedral mesh: on vertices and tetrahedra, and on edges, where values are always
/// journaled.
class ProtectedTetProperties : public testing::Test {
 protected:
  ProtectedTetProperties()
      : tree(box(2, 2, 2)),
        mesh(dynamic_cast<tet::TetMesh&>(tree.tree->mesh(NodeId::root))),
        of_vertices(mesh.add_vertex_property<Label>("label")),
        of_tets(mesh.add_tet_property<Label>("label")),
        of_edges(mesh.add_simplex_property<std::string>(1, "label")) {
    for (std::size_t i = 0; i < of_vertices.values.size(); ++i)
      of_vertices.values[i] = {"v" + std::to_string(i), {int(i)}};
    for (std::size_t i = 0; i < of_tets.values.size(); ++i)
      of_tets.values[i] = {"t" + std::to_string(i), {int(i)}};
    for (Index e = 0; e < mesh.capacity(1); e += 2)
      if (mesh.is_live(1, e)) mesh.set_value(of_edges, mesh.dart_of(1, e), "e" + std::to_string(e));
    mesh.forget();
    tree.operations->protect_properties(true);
  }
  /// All labels of what is alive, in one text.
  std::string labels() const {
    std::string all;
    const auto put = [&](const Label& l) {
      all += l.text + ":" + std::to_string(l.numbers.empty() ? -1 : l.numbers[0]) + " ";
    };
    for (Index v = 0; v < mesh.capacity(0); ++v)
      if (mesh.is_live(0, v)) put(of_vertices[v]);
    for (Index t = 0; t < mesh.capacity(3); ++t)
      if (mesh.is_live(3, t)) put(of_tets[t]);
    for (Index e = 0; e < mesh.capacity(1); ++e)
      if (mesh.is_live(1, e)) {
        const std::string* value = mesh.value(of_edges, mesh.dart_of(1, e));
        all += value ? *value + " " : "- ";
      }
    return all;
  }
  void scribble(const Event& event) {
    DartBuffer star;
    mesh.star(event.copies[0].dart, 0, star);
    for (const Dart d : star) {
      of_vertices[mesh.vertex(d)].text = "changed";
      of_tets[mesh.facet(d)] = {"changed", {}};
      mesh.set_value(of_edges, d, std::string("changed"));
    }
  }

  Tree tree;
  tet::TetMesh& mesh;
  tet::Property<Label>& of_vertices;
  tet::Property<Label>& of_tets;
  tet::SimplexProperty<std::string>& of_edges;
};

TEST_F(ProtectedTetProperties, AreRestoredWhenAnInvariantFailsAfterTheyWereWritten) {
  std::size_t written = 0;
  FunctionInvariant scribbling("scribbling", {}, [&](const Event& e) { return scribble(e), ++written == 0; });
  tree.operations->add(scribbling);
  const std::string before = labels();
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    if (!mesh.is_live(1, e)) continue;
    ASSERT_FALSE(tree.operations->collapse(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "collapse of edge " << e;
    ASSERT_FALSE(tree.operations->split(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "split of edge " << e;
    ASSERT_FALSE(tree.operations->swap(NodeId::root, mesh.dart_of(1, e)));
    ASSERT_EQ(labels(), before) << "swap of edge " << e;
  }
  EXPECT_GT(written, 100U);
}

TEST_F(ProtectedTetProperties, AreRestoredThroughNestedTransactions) {
  FunctionInvariant scribbling("scribbling", {}, [&](const Event& e) { return scribble(e), true; });
  tree.operations->add(scribbling);
  const std::string before = labels();
  const Index vertices = mesh.capacity(0), tets = mesh.capacity(3);
  {
    const Transaction outer(*tree.tree, {});
    for (Index e = 0; e < 6 * tets; e += 3) {
      if (mesh.is_live(1, e)) (void)tree.operations->split(NodeId::root, mesh.dart_of(1, e));
      if (mesh.is_live(1, e + 1)) (void)tree.operations->collapse(NodeId::root, mesh.dart_of(1, e + 1));
      if (mesh.is_live(2, e / 2)) (void)tree.operations->swap_face(NodeId::root, mesh.dart_of(2, e / 2));
    }
    EXPECT_NE(labels(), before);
    EXPECT_EQ(validate(*tree.tree), std::vector<std::string>());
  }
  EXPECT_EQ(labels(), before);
  EXPECT_EQ(mesh.capacity(0), vertices);
  EXPECT_EQ(mesh.capacity(3), tets);
}

}  // namespace
}  // namespace multimesh::test
