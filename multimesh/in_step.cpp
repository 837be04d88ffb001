// SPDX-License-Identifier: BSD-3-Clause
// Edits of a tree's meshes by other code: detected before an operation changes anything, and followed on
// request.
#include <array>
#include <string>

#include "multimesh/error.hpp"
#include "multimesh/multi_mesh.hpp"
#include "multimesh/validate.hpp"

namespace multimesh {

namespace {

constexpr const char* remedy =
    "; call resync(), and edit it by the operations of the tree, so that its maps are kept";

[[noreturn]] void out_of_step(NodeId n, const std::string& what) {
  throw OutOfStepError("mesh " + std::to_string(index(n)) + " was edited from outside of the tree: " + what +
                       remedy);
}

std::string around(Index vertex) {
  return "the edges and faces around vertex " + std::to_string(vertex) + " are not as they were left";
}

}  // namespace

void MultiMesh::require_same_counts() const {
  if (!lost_.empty())
    throw OutOfStepError("the edits from outside of the tree cannot be followed: " + lost_ +
                         "; detach the children and make them anew");
  for (const NodeId n : top_down_) {
    const Mesh& mesh = *nodes_[index(n)].mesh;
    if (mesh.is_watched() && !mesh.same_counts())
      out_of_step(n, "vertices, edges or faces were added or removed");
  }
}

void MultiMesh::require_star_in_step(NodeId n, Dart d, int k) const {
  const Mesh& mesh = *nodes_[index(n)].mesh;
  if (!mesh.is_watched()) return;
  if (!mesh.is_dart(d)) out_of_step(n, "a face to which an anchor points was deleted");
  std::array<Index, 4> v{};
  mesh.vertices(d, v.data());
  for (std::size_t i = 0; i <= static_cast<std::size_t>(k); ++i)
    if (!mesh.star_in_step(v[i])) out_of_step(n, around(v[i]));
}

void MultiMesh::require_in_step() const {
  require_same_counts();
  for (const NodeId n : top_down_)
    if (const auto v = mesh(n).first_out_of_step()) out_of_step(n, around(*v));
}

// Elements are followed by their names. Whether the maps are still maps can only be decided by checking them:
// removed or added elements cannot be seen from the remaining ones.
std::vector<Compaction> MultiMesh::resync() {
  require_closed("resync");
  std::vector<Compaction> moved(nodes_.size());
  for (const NodeId n : top_down_)
    if (auto of_mesh = mesh(n).renumbering()) moved[index(n)] = std::move(*of_mesh);
  follow(moved);
  for (const NodeId n : top_down_) mesh(n).accept_edits();
  const auto problems = validate(*this);
  lost_ = problems.empty() ? std::string() : problems.front();
  require_same_counts();
  return moved;
}

}  // namespace multimesh
