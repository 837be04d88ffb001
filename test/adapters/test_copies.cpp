// SPDX-License-Identifier: BSD-3-Clause
// Copies of attached meshes are ordinary meshes: they can be attached, whatever happens to their originals.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <optional>
#include <random>

#include "adapters/openmesh/root_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Normal);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
};
struct TraitsWithStatus : Traits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::TexCoord2D);
};

/// Everything that a user can see of a mesh: corners of live faces, points, and a property of the user's.
template <class UserMesh>
std::vector<double> seen(const UserMesh& mesh) {
  std::vector<double> all;
  OpenMesh::FPropHandleT<int> tag;
  const bool tagged = mesh.get_property_handle(tag, "tag");
  for (const auto f : mesh.all_faces()) {
    if (mesh.has_face_status() && mesh.status(f).deleted()) continue;
    if (tagged) all.push_back(mesh.property(tag, f));
    for (const auto v : mesh.fv_range(f))
      for (int i = 0; i < 3; ++i) all.push_back(double(mesh.point(v)[i]));
  }
  return all;
}

template <class UserMesh>
std::size_t our_properties(UserMesh& mesh) {
  std::size_t n = 0;
  const auto count = [&](auto begin, auto end) {
    for (auto p = begin; p != end; ++p) n += *p && (*p)->name().rfind("mm:", 0) == 0;
  };
  count(mesh.vprops_begin(), mesh.vprops_end());
  count(mesh.eprops_begin(), mesh.eprops_end());
  count(mesh.hprops_begin(), mesh.hprops_end());
  count(mesh.fprops_begin(), mesh.fprops_end());
  count(mesh.mprops_begin(), mesh.mprops_end());
  return n;
}

template <class UserMesh>
class CopiedMesh : public testing::Test {
 protected:
  CopiedMesh() {
    const Shape s = grid(5, 5);
    mesh_.add_property(tag_, "tag");
    for (const auto& p : s.points) mesh_.add_vertex({p[0], p[1], p[2]});
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
      std::vector<OpenMesh::VertexHandle> corners;
      for (const Index v : s.facets.facet(f)) corners.emplace_back(static_cast<int>(v));
      mesh_.property(tag_, mesh_.add_face(corners)) = static_cast<int>(f);
    }
    for (const auto h : mesh_.halfedges()) {
      const auto p = mesh_.point(mesh_.to_vertex_handle(h));
      mesh_.set_texcoord2D(h, {float(p[0]), float(p[1])});
    }
  }
  /// Attaches a mesh, with children, and does some operations of each kind.
  void work_on(UserMesh& mesh) {
    openmesh::Attached<UserMesh> attached(mesh);
    work_on(attached);
  }
  void work_on(openmesh::Attached<UserMesh>& attached) {
    (void)attached.add_texture();
    (void)attached.add_boundary();
    operate(attached);
  }
  void operate(openmesh::Attached<UserMesh>& attached) {
    int done = 0;
    for (int tries = 0; tries < 400 && done < 20; ++tries) {
      const OpenMesh::EdgeHandle e(static_cast<int>(random_() % attached.mesh().n_edges()));
      if (attached.mesh().status(e).deleted()) continue;
      const auto h = attached.mesh().halfedge_handle(e, 0);
      done += tries % 3 == 0   ? bool(attached.split(e))
              : tries % 3 == 1 ? bool(attached.collapse(h))
                               : bool(attached.swap(e));
    }
    EXPECT_EQ(done, 20);
    EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
    attached.tree().require_in_step();
  }

  UserMesh mesh_;
  OpenMesh::FPropHandleT<int> tag_;
  std::mt19937 random_{3};
};

using Meshes = testing::Types<OpenMesh::TriMesh_ArrayKernelT<Traits>, OpenMesh::PolyMesh_ArrayKernelT<Traits>,
                              OpenMesh::TriMesh_ArrayKernelT<TraitsWithStatus>>;
TYPED_TEST_SUITE(CopiedMesh, Meshes);

TYPED_TEST(CopiedMesh, AttachesWhileItsOriginalIsAttached) {
  openmesh::Attached<TypeParam> attached(this->mesh_);
  (void)attached.add_texture();
  TypeParam backup = this->mesh_;
  const auto before = seen(this->mesh_);
  EXPECT_EQ(seen(backup), before);
  this->work_on(backup);
  EXPECT_EQ(our_properties(backup), 0U);
  EXPECT_NE(seen(backup), before);
  EXPECT_EQ(seen(this->mesh_), before);
  EXPECT_EQ(validate(attached.tree()), std::vector<std::string>{});
  EXPECT_THROW(openmesh::Attached<TypeParam>{this->mesh_}, UsageError);  // the original is still attached
  this->operate(attached);
}

TYPED_TEST(CopiedMesh, AttachesWhenItsOriginalIsDetached) {
  TypeParam assigned, of_copy;
  {
    openmesh::Attached<TypeParam> attached(this->mesh_);
    this->work_on(attached);
    assigned = this->mesh_;
    of_copy = assigned;
  }
  EXPECT_EQ(our_properties(this->mesh_), 0U);
  const auto before = seen(assigned);
  for (TypeParam* mesh : {&assigned, &of_copy, &this->mesh_}) {
    EXPECT_EQ(seen(*mesh), before);
    this->work_on(*mesh);
    EXPECT_EQ(our_properties(*mesh), 0U);
  }
}

TYPED_TEST(CopiedMesh, BringsTheOriginalBack) {
  const auto before = seen(this->mesh_);
  TypeParam backup;
  {
    openmesh::Attached<TypeParam> attached(this->mesh_);
    backup = this->mesh_;
    this->work_on(attached);
  }
  this->mesh_ = backup;  // at the address that the mark names
  EXPECT_EQ(seen(this->mesh_), before);
  this->work_on(this->mesh_);
  EXPECT_EQ(our_properties(this->mesh_), 0U);
}

TYPED_TEST(CopiedMesh, AttachesWhenItsOriginalIsGone) {
  std::optional<TypeParam> copy, moved;
  {
    auto original = std::make_unique<TypeParam>(this->mesh_);
    openmesh::Attached<TypeParam> attached(*original);
    this->work_on(attached);
    copy = *original;
  }
  moved = std::move(*copy);
  this->work_on(*moved);
  EXPECT_EQ(our_properties(*moved), 0U);
}

TYPED_TEST(CopiedMesh, AttachesAgainAndAgain) {
  for (int i = 0; i < 3; ++i) {
    this->work_on(this->mesh_);
    EXPECT_EQ(our_properties(this->mesh_), 0U);
    openmesh::Attached<TypeParam> attached(this->mesh_);
    this->operate(attached);
    const TypeParam snapshot = this->mesh_;
    TypeParam again = snapshot;
    this->work_on(again);
  }
}

TYPED_TEST(CopiedMesh, HasTheStatusThatTheUserRequested) {
  const bool requested = this->mesh_.has_vertex_status();
  TypeParam copy;
  {
    openmesh::Attached<TypeParam> attached(this->mesh_);
    copy = this->mesh_;
  }
  { openmesh::Attached<TypeParam> attached(copy); }
  EXPECT_EQ(copy.has_vertex_status(), requested);
  EXPECT_EQ(copy.has_edge_status(), requested);
  EXPECT_EQ(copy.has_face_status(), requested);
}

TEST(CopiedRootMesh, DrivesNoTree) {
  using Mesh = openmesh::RootMesh<OpenMesh::TriMesh_ArrayKernelT<Traits>>;
  Mesh mesh;
  const Shape s = grid(3, 3);
  for (const auto& p : s.points) mesh.add_vertex({p[0], p[1], p[2]});
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    const auto v = s.facets.facet(f);
    mesh.add_face(OpenMesh::VertexHandle(int(v[0])), OpenMesh::VertexHandle(int(v[1])),
                  OpenMesh::VertexHandle(int(v[2])));
  }
  openmesh::Attached attached(mesh);
  mesh.drive(attached);
  Mesh copy = mesh, assigned;
  assigned = mesh;
  const auto before = seen(mesh);
  for (Mesh* other : {&copy, &assigned}) {
    for (const auto e : other->edges())
      if (other->is_flip_ok(e)) {
        other->flip(e);
        break;
      }
    EXPECT_NE(seen(*other), before);
    EXPECT_EQ(seen(mesh), before);
    attached.tree().require_in_step();
  }
}

}  // namespace
}  // namespace multimesh::test
