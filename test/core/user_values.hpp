// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "adapters/openmesh/connectivity.hpp"

namespace multimesh::test {

/// Something of the user's that the library cannot know.
struct Custom {
  int id = -1;
  std::vector<std::string> names;
  friend bool operator==(const Custom&, const Custom&) = default;
};

/// Properties of a user's mesh, of types that own memory, with another value on every element.
class UserValues {
 public:
  explicit UserValues(Mesh& mesh) : om_(dynamic_cast<openmesh::Connectivity&>(mesh).openmesh()) {
    om_.add_property(vertex_, "user:vertex");
    om_.add_property(edge_, "user:edge");
    om_.add_property(halfedge_, "user:halfedge");
    om_.add_property(face_, "user:face");
    for (const auto v : om_.all_vertices())
      om_.property(vertex_, v) = "a name too long to be kept in place " + std::to_string(v.idx());
    for (const auto e : om_.all_edges()) om_.property(edge_, e) = {e.idx(), 1, 2};
    for (const auto h : om_.all_halfedges())
      om_.property(halfedge_, h) = {h.idx(), {"h", std::to_string(h.idx())}};
    for (const auto f : om_.all_faces()) om_.property(face_, f) = "f" + std::to_string(f.idx());
  }

  using All = std::tuple<std::vector<std::string>, std::vector<std::vector<int>>, std::vector<Custom>,
                         std::vector<std::string>>;
  All all() const {
    return {om_.property(vertex_).data_vector(), om_.property(edge_).data_vector(),
            om_.property(halfedge_).data_vector(), om_.property(face_).data_vector()};
  }
  const std::string& vertex(Index v) const { return om_.property(vertex_).data_vector().at(v); }
  const std::vector<int>& edge(Index e) const { return om_.property(edge_).data_vector().at(e); }
  const Custom& halfedge(Index h) const { return om_.property(halfedge_).data_vector().at(h); }
  const std::string& face(Index f) const { return om_.property(face_).data_vector().at(f); }

 private:
  OpenMesh::PolyConnectivity& om_;
  OpenMesh::VPropHandleT<std::string> vertex_;
  OpenMesh::EPropHandleT<std::vector<int>> edge_;
  OpenMesh::HPropHandleT<Custom> halfedge_;
  OpenMesh::FPropHandleT<std::string> face_;
};

}  // namespace multimesh::test
