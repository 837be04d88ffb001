// SPDX-License-Identifier: BSD-3-Clause
#include "test/core/user_values.hpp"

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::test {

namespace {

using Texts = std::vector<std::string>;

void name_all(Texts& texts, const std::string& kind) {
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = kind + std::to_string(i);
}

constexpr const char* long_name = "a name too long to be kept in place ";

template <class Handle>
auto& added(OpenMesh::PolyConnectivity& om, Handle handle, const char* name) {
  om.add_property(handle, name);
  return om.property(handle).data_vector();
}

}  // namespace

UserValues::UserValues(Mesh& mesh) : mesh_(&mesh) {
  if (auto* tets = dynamic_cast<tet::TetMesh*>(&mesh)) {
    Texts& vertices = tets->add_vertex_property<std::string>("user:vertex").values;
    Texts& facets = tets->add_tet_property<std::string>("user:tet").values;
    name_all(vertices, long_name), name_all(facets, "t");
    vertices_ = &vertices, faces_ = &facets;
    auto& edges = tets->add_simplex_property<std::vector<int>>(1, "user:edge");
    for (Index e = 0; e < tets->capacity(1); e += 3)
      if (tets->is_live(1, e)) tets->set_value(edges, tets->dart_of(1, e), {static_cast<int>(e), 1, 2});
    tets->forget();
    return;
  }
  auto& om = dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
  Texts& vertices = added(om, OpenMesh::VPropHandleT<std::string>(), "user:vertex");
  Texts& faces = added(om, OpenMesh::FPropHandleT<std::string>(), "user:face");
  auto& edges = added(om, OpenMesh::EPropHandleT<std::vector<int>>(), "user:edge");
  auto& halfedges = added(om, OpenMesh::HPropHandleT<Custom>(), "user:halfedge");
  name_all(vertices, long_name), name_all(faces, "f");
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e] = {static_cast<int>(e), 1, 2};
  for (std::size_t h = 0; h < halfedges.size(); ++h)
    halfedges[h] = {static_cast<int>(h), {"h", std::to_string(h)}};
  vertices_ = &vertices, faces_ = &faces, edges_ = &edges, halfedges_ = &halfedges;
}

std::vector<int> UserValues::edge(Dart d) const {
  if (edges_) return edges_->at(mesh_->simplex(d, 1));
  const auto& tets = dynamic_cast<const tet::TetMesh&>(*mesh_);
  const auto* value = tets.value(*tets.simplex_property<std::vector<int>>("user:edge"), d);
  return value ? *value : std::vector<int>{};
}

UserValues::All UserValues::all() const {
  if (edges_) return {*vertices_, *edges_, *halfedges_, *faces_};
  All all;
  for (Index v = 0; v < mesh_->capacity(0); ++v)
    std::get<0>(all).push_back(mesh_->is_live(0, v) ? vertex(v) : std::string());
  for (Index e = 0; e < mesh_->capacity(1); ++e)
    if (mesh_->is_live(1, e)) std::get<1>(all).push_back(edge(mesh_->dart_of(1, e)));
  for (Index t = 0; t < mesh_->capacity(3); ++t)
    std::get<3>(all).push_back(mesh_->is_live(3, t) ? face(t) : std::string());
  return all;
}

}  // namespace multimesh::test
