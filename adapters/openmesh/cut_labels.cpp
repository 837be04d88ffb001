// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/openmesh/cut_labels.hpp"

#include <algorithm>
#include <array>

namespace multimesh::openmesh {

const std::vector<CutLabel>* cut_labels(const OpenMesh::PolyConnectivity& mesh) {
  OpenMesh::VPropHandleT<CutLabel> labels;
  return mesh.get_property_handle(labels, cut_label_name) ? &mesh.property(labels).data_vector() : nullptr;
}

namespace {

/// A dart at each neighbour of a vertex, once.
void collect_neighbours(const Mesh& mesh, Dart vertex, DartBuffer& star, DartBuffer& out) {
  out.clear();
  mesh.star(vertex, 0, star);
  for (const Dart t : star)
    for (const Permutation to : {exchange_ends, permutation(2, 0, 1)}) {
      const Dart n = mesh.reorder(t, to);
      const auto same = [&](Dart d) { return mesh.vertex(d) == mesh.vertex(n); };
      if (std::none_of(out.begin(), out.end(), same)) out.push_back(n);
    }
}

}  // namespace

bool CopiesCanBeJoined::before(const Event& event) {
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  for (const Copy& c : event.copies.of(NodeId::root)) {
    if (event.operation == Operation::split && !allows_split(mesh, c.dart)) return false;
    if (event.operation == Operation::flip && !allows_swap(mesh, c.dart)) return false;
    if (event.operation == Operation::collapse && !allows_collapse(mesh, c.dart)) return false;
  }
  return true;
}

// The new vertex has an edge with each vertex of the triangles at the old edge.
bool CopiesCanBeJoined::allows_split(const Mesh& mesh, Dart edge) {
  std::array<CutLabel, 4> labels{label(mesh, edge), label(mesh, mesh.reorder(edge, exchange_ends))};
  mesh.star(edge, 1, star_);
  for (std::size_t i = 0; i < std::min<std::size_t>(2, star_.size()); ++i)
    labels[2 + i] = label(mesh, mesh.reorder(star_[i], permutation(2, 0, 1)));
  std::sort(labels.begin(), labels.end());
  for (std::size_t i = 1; i < labels.size(); ++i)
    if (labels[i] != 0 && labels[i] == labels[i - 1]) return false;
  return true;
}

bool CopiesCanBeJoined::allows_swap(const Mesh& mesh, Dart edge) {
  mesh.star(edge, 1, star_);
  if (star_.size() != 2) return true;
  const Dart l = mesh.reorder(star_[0], permutation(2, 0, 1)),
             r = mesh.reorder(star_[1], permutation(2, 0, 1));
  const CutLabel of_l = label(mesh, l), of_r = label(mesh, r);
  if (of_l != 0 && of_r != 0) return false;
  return (of_l == 0 || !has_neighbour_like(mesh, r, of_l, no_index)) &&
         (of_r == 0 || !has_neighbour_like(mesh, l, of_r, no_index));
}

// The end with a label is locked, so it stays.
bool CopiesCanBeJoined::allows_collapse(const Mesh& mesh, Dart edge) {
  Dart stays = edge, goes = mesh.reorder(edge, exchange_ends);
  if (label(mesh, stays) == 0) std::swap(stays, goes);
  collect_neighbours(mesh, stays, star_, kept_);
  collect_neighbours(mesh, goes, star_, gained_);
  const auto is_known = [&](Dart d) {
    const Index v = mesh.vertex(d);
    return v == mesh.vertex(stays) ||
           std::any_of(kept_.begin(), kept_.end(), [&](Dart k) { return mesh.vertex(k) == v; });
  };
  std::erase_if(gained_, is_known);
  const CutLabel merged = label(mesh, stays);
  return std::all_of(gained_.begin(), gained_.end(), [&](Dart g) {
    const CutLabel gained = label(mesh, g);
    if (merged != 0) return gained == 0 && !has_neighbour_like(mesh, g, merged, mesh.vertex(goes));
    if (gained == 0) return true;
    const auto is_like = [&](Dart d) { return mesh.vertex(d) != mesh.vertex(g) && label(mesh, d) == gained; };
    return std::none_of(kept_.begin(), kept_.end(), is_like) &&
           std::none_of(gained_.begin(), gained_.end(), is_like);
  });
}

bool CopiesCanBeJoined::has_neighbour_like(const Mesh& mesh, Dart vertex, CutLabel wanted, Index but) {
  collect_neighbours(mesh, vertex, star_, around_);
  return std::any_of(around_.begin(), around_.end(),
                     [&](Dart d) { return mesh.vertex(d) != but && label(mesh, d) == wanted; });
}

}  // namespace multimesh::openmesh
