// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "multimesh/mesh.hpp"

namespace multimesh::test {

/// A user's type that the library cannot know.
struct Custom {
  int id = -1;
  std::vector<std::string> names;
  friend bool operator==(const Custom&, const Custom&) = default;
};

/// Properties of a user's mesh, of types that own memory, with another value on every element. Of a
/// tetrahedral mesh: on vertices, some edges, no halfedges, tetrahedra ("faces"); values of dead elements do
/// not count, for their slots are used again.
class UserValues {
 public:
  explicit UserValues(Mesh& mesh);

  using All = std::tuple<std::vector<std::string>, std::vector<std::vector<int>>, std::vector<Custom>,
                         std::vector<std::string>>;
  All all() const;
  const std::string& vertex(Index v) const { return vertices_->at(v); }
  const std::string& face(Index f) const { return faces_->at(f); }
  const Custom& halfedge(Index h) const { return halfedges_->at(h); }
  /// Of the edge at a dart; empty if it has none.
  std::vector<int> edge(Dart d) const;

 private:
  const Mesh* mesh_;
  const std::vector<std::string>* vertices_ = nullptr;
  const std::vector<std::string>* faces_ = nullptr;
  const std::vector<Custom>* halfedges_ = nullptr;
  const std::vector<std::vector<int>>* edges_ = nullptr;  // null in a tetrahedral mesh
};

}  // namespace multimesh::test
