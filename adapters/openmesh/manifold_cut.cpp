// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/openmesh/manifold_cut.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "adapters/openmesh/cut_labels.hpp"
#include "multimesh/error.hpp"
#include "multimesh/openmesh/attachment.hpp"

namespace multimesh::openmesh {

using OpenMesh::HalfedgeHandle;
using OpenMesh::PolyConnectivity;
using OpenMesh::VertexHandle;

namespace {

/// The halfedges out of a vertex whose faces are connected there, counterclockwise. If the fan is open, the
/// first one's opposite and the last one itself are in the boundary.
struct Fan {
  std::vector<HalfedgeHandle> out;
  bool is_open = false;
};

bool is_dead(const PolyConnectivity& mesh, HalfedgeHandle h) {
  return mesh.has_edge_status() && mesh.status(mesh.edge_handle(h)).deleted();
}

/// The next halfedge out of the vertex; none after the last one of an open fan.
HalfedgeHandle next_in_fan(const PolyConnectivity& mesh, HalfedgeHandle h) {
  return mesh.is_boundary(h) ? HalfedgeHandle() : mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

bool begins_open_fan(const PolyConnectivity& mesh, HalfedgeHandle h) {
  return mesh.is_boundary(mesh.opposite_halfedge_handle(h)) && !mesh.is_boundary(h);
}

/// The fans of a vertex, by the halfedges out of it. Edges without faces are in no fan.
std::vector<Fan> fans_of(const PolyConnectivity& mesh, const std::vector<HalfedgeHandle>& out,
                         std::vector<bool>& seen) {
  std::vector<Fan> fans;
  const auto walk = [&](HalfedgeHandle first, bool is_open) {
    Fan& fan = fans.emplace_back();
    fan.is_open = is_open;
    for (HalfedgeHandle h = first; h.is_valid() && !seen[static_cast<std::size_t>(h.idx())];
         h = next_in_fan(mesh, h)) {
      seen[static_cast<std::size_t>(h.idx())] = true;
      fan.out.push_back(h);
    }
  };
  for (const HalfedgeHandle h : out)
    if (begins_open_fan(mesh, h)) walk(h, true);
  for (const HalfedgeHandle h : out)
    if (!mesh.is_boundary(h) && !seen[static_cast<std::size_t>(h.idx())]) walk(h, false);
  return fans;
}

/// Per vertex the live halfedges out of it, whatever the links say.
std::vector<std::vector<HalfedgeHandle>> outgoing(const PolyConnectivity& mesh) {
  std::vector<std::vector<HalfedgeHandle>> out(mesh.n_vertices());
  for (const auto h : mesh.all_halfedges())
    if (!is_dead(mesh, h)) out[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())].push_back(h);
  return out;
}

/// Makes a fan the only one at a vertex.
void give_fan(PolyConnectivity& mesh, const Fan& fan, VertexHandle v) {
  for (const HalfedgeHandle h : fan.out) mesh.set_vertex_handle(mesh.opposite_halfedge_handle(h), v);
  if (fan.is_open)
    mesh.set_next_halfedge_handle(mesh.opposite_halfedge_handle(fan.out.front()), fan.out.back());
  mesh.set_halfedge_handle(v, fan.out.back());
}

VertexHandle copy_of(PolyConnectivity& mesh, VertexHandle v) {
  const VertexHandle copy = mesh.add_vertex();
  for (auto p = mesh.vprops_begin(); p != mesh.vprops_end(); ++p)
    if (*p) (*p)->copy(static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(copy.idx()));
  return copy;
}

/// Per element the vertices of one kind of simplex, sorted; returns elements that repeat an earlier one.
template <std::size_t n>
std::vector<int> repeated(std::vector<std::pair<std::array<int, n>, int>>& all) {
  for (auto& [vertices, element] : all) std::sort(vertices.begin(), vertices.end());
  std::sort(all.begin(), all.end());
  std::vector<int> found;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].first == all[i - 1].first) found.push_back(all[i].second);
  return found;
}

/// Triangles that share all their vertices, or an edge's vertices by different edges, with other triangles.
std::vector<OpenMesh::FaceHandle> improper_faces(const PolyConnectivity& mesh) {
  std::vector<std::pair<std::array<int, 3>, int>> faces;
  for (const auto f : mesh.all_faces()) {
    if (mesh.has_face_status() && mesh.status(f).deleted()) continue;
    const auto h = mesh.halfedge_handle(f);
    const auto n = mesh.next_halfedge_handle(h);
    faces.push_back(
        {{mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx(), mesh.to_vertex_handle(n).idx()},
         f.idx()});
  }
  std::vector<int> found = repeated(faces);
  std::vector<std::pair<std::array<int, 2>, int>> edges;
  for (const auto e : mesh.all_edges()) {
    const auto h = mesh.halfedge_handle(e, 0);
    if (!is_dead(mesh, h))
      edges.push_back({{mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()}, e.idx()});
  }
  for (const int e : repeated(edges))
    for (const unsigned side : {0U, 1U}) {
      const auto f = mesh.face_handle(mesh.halfedge_handle(OpenMesh::EdgeHandle(e), side));
      if (f.is_valid()) found.push_back(f.idx());
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<OpenMesh::FaceHandle> handles;
  for (const int f : found) handles.emplace_back(f);
  return handles;
}

/// Gives a face an edge of its own in place of that of h, with all of its properties. give_fan() sets the
/// links of boundary halfedges.
void open_edge(PolyConnectivity& mesh, HalfedgeHandle h) {
  const auto face = mesh.face_handle(h);
  const HalfedgeHandle n = mesh.new_edge(mesh.from_vertex_handle(h), mesh.to_vertex_handle(h));
  const auto copy = [](auto begin, auto end, int from, int to) {
    for (auto p = begin; p != end; ++p)
      if (*p) (*p)->copy(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  };
  copy(mesh.eprops_begin(), mesh.eprops_end(), h.idx() >> 1, n.idx() >> 1);
  copy(mesh.hprops_begin(), mesh.hprops_end(), h.idx(), n.idx());
  copy(mesh.hprops_begin(), mesh.hprops_end(), h.idx() ^ 1, n.idx() ^ 1);
  mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(h), n);
  mesh.set_next_halfedge_handle(n, mesh.next_halfedge_handle(h));
  mesh.set_face_handle(n, face);
  mesh.set_halfedge_handle(face, n);
  mesh.set_boundary(h);
  mesh.set_boundary(mesh.opposite_halfedge_handle(n));
}

/// Does the cutting; labels are even, from `last_label` on.
class Cutter {
 public:
  Cutter(PolyConnectivity& mesh, OpenMesh::VPropHandleT<CutLabel> labels) : mesh_(mesh), labels_(labels) {
    for (const CutLabel l : mesh.property(labels).data_vector()) last_label_ = std::max(last_label_, l | 1);
    if (last_label_ == 0) last_label_ = 1;
  }

  /// Where separate vertices are not enough to distinguish two simplices, disconnects triangles.
  std::size_t run() {
    cut_fans();
    for (auto faces = improper_faces(mesh_); !faces.empty(); faces = improper_faces(mesh_)) {
      for (const auto f : faces) take_out(f);
      cut_fans();
    }
    return copies_;
  }

 private:
  void cut_fans() {
    opened_.resize(mesh_.n_vertices(), false);
    const auto out = outgoing(mesh_);
    std::vector<bool> seen(mesh_.n_halfedges(), false);
    for (std::size_t v = 0; v < out.size(); ++v)
      cut(VertexHandle(static_cast<int>(v)), fans_of(mesh_, out[v], seen));
    opened_.assign(mesh_.n_vertices(), false);
  }

  void take_out(OpenMesh::FaceHandle f) {
    const HalfedgeHandle a = mesh_.halfedge_handle(f), b = mesh_.next_halfedge_handle(a),
                         c = mesh_.next_halfedge_handle(b);
    for (const HalfedgeHandle h : {a, b, c}) {
      opened_[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())] = true;
      if (!mesh_.is_boundary(mesh_.opposite_halfedge_handle(h))) open_edge(mesh_, h);
    }
  }

  // The fan to which the vertex's own halfedge belongs keeps the vertex.
  void cut(VertexHandle v, std::vector<Fan> fans) {
    if (fans.size() < 2) {
      if (!fans.empty() && opened_[static_cast<std::size_t>(v.idx())]) give_fan(mesh_, fans[0], v);
      return;
    }
    const HalfedgeHandle known = mesh_.halfedge_handle(v);
    const auto first = std::find_if(fans.begin(), fans.end(), [&](const Fan& f) {
      return std::find(f.out.begin(), f.out.end(), known) != f.out.end();
    });
    if (first != fans.end()) std::iter_swap(fans.begin(), first);
    if (mesh_.property(labels_, v) == 0) {
      mesh_.property(labels_, v) = ++last_label_ + (mesh_.status(v).locked() ? 1 : 0);
      last_label_ |= 1;
    }
    mesh_.status(v).set_locked(true);
    give_fan(mesh_, fans[0], v);
    for (std::size_t i = 1; i < fans.size(); ++i, ++copies_) give_fan(mesh_, fans[i], copy_of(mesh_, v));
  }

  PolyConnectivity& mesh_;
  OpenMesh::VPropHandleT<CutLabel> labels_;
  CutLabel last_label_ = 0;
  std::size_t copies_ = 0;
  std::vector<bool> opened_;  // vertices at which edges were opened
};

/// Whether two vertices are neighbours, or have one in common.
bool have_neighbour_in_common(const PolyConnectivity& mesh, VertexHandle v, VertexHandle w) {
  std::vector<VertexHandle> around{v};
  for (const auto n : mesh.vv_range(v)) around.push_back(n);
  return std::any_of(mesh.cvv_begin(w), mesh.cvv_end(w), [&](VertexHandle n) {
    return std::find(around.begin(), around.end(), n) != around.end();
  });
}

/// Gives v everything at w. \pre both are open, without a common neighbour
void merge(PolyConnectivity& mesh, VertexHandle v, VertexHandle w) {
  const HalfedgeHandle from_v = mesh.halfedge_handle(v), from_w = mesh.halfedge_handle(w);
  const HalfedgeHandle to_v = mesh.prev_halfedge_handle(from_v), to_w = mesh.prev_halfedge_handle(from_w);
  std::vector<HalfedgeHandle> in;
  for (const auto h : mesh.vih_range(w)) in.push_back(h);
  for (const HalfedgeHandle h : in) mesh.set_vertex_handle(h, v);
  mesh.set_next_halfedge_handle(to_v, from_w);
  mesh.set_next_halfedge_handle(to_w, from_v);
  mesh.set_isolated(w);
  mesh.status(w).set_deleted(true);
}

OpenMesh::VPropHandleT<CutLabel> labels_of(PolyConnectivity& mesh) {
  OpenMesh::VPropHandleT<CutLabel> labels;
  if (!mesh.get_property_handle(labels, cut_label_name)) throw UsageError("the mesh is not cut any more");
  return labels;
}

}  // namespace

ManifoldCut::ManifoldCut(PolyConnectivity& mesh) : mesh_(mesh) {
  require_detached(mesh);
  OpenMesh::VPropHandleT<CutLabel> labels;
  if (!mesh.get_property_handle(labels, cut_label_name)) {  // else it is a copy of a mesh that was cut
    mesh.add_property(labels, cut_label_name);
    mesh.request_vertex_status();
  }
  copies_ = Cutter(mesh, labels).run();
}

ManifoldCut::~ManifoldCut() {
  if (is_cut_ && !is_attached(mesh_) && cut_labels(mesh_)) join();
}

ManifoldCut::Joined ManifoldCut::join() {
  Joined joined;
  if (!is_cut_) return joined;
  require_detached(mesh_);
  const auto labels = labels_of(mesh_);
  std::map<CutLabel, std::vector<VertexHandle>> joint;  // by label, those that are already joined
  std::vector<VertexHandle> apart;
  for (const auto v : mesh_.all_vertices()) {
    const CutLabel label = mesh_.property(labels, v);
    if (label == 0 || mesh_.status(v).deleted()) continue;
    auto& ones = joint[label];
    if (ones.empty()) {
      ones.push_back(v);
      continue;
    }
    const auto one = std::find_if(ones.begin(), ones.end(), [&](VertexHandle w) {
      return mesh_.is_boundary(v) && mesh_.is_boundary(w) && !mesh_.is_isolated(v) && !mesh_.is_isolated(w) &&
             !have_neighbour_in_common(mesh_, w, v);
    });
    if (one == ones.end()) {
      ones.push_back(v);
      ++joined.left;
    } else {
      merge(mesh_, *one, v);
      ++joined.copies;
    }
  }
  std::size_t n = mesh_.n_vertices();
  const auto is_merged = [&](std::size_t i) {
    const VertexHandle v(static_cast<int>(i));
    return mesh_.property(labels, v) != 0 && mesh_.status(v).deleted();
  };
  while (n > 0 && is_merged(n - 1)) --n;
  mesh_.resize(n, mesh_.n_edges(), mesh_.n_faces());
  keep();
  return joined;
}

void ManifoldCut::keep() {
  if (!is_cut_) return;
  require_detached(mesh_);
  auto labels = labels_of(mesh_);
  bool has_dead = false;
  for (const auto v : mesh_.all_vertices()) {
    if (const CutLabel label = mesh_.property(labels, v); label != 0)
      mesh_.status(v).set_locked((label & 1) != 0);
    has_dead = has_dead || mesh_.status(v).deleted();
  }
  mesh_.remove_property(labels);
  if (!has_dead) mesh_.release_vertex_status();
  is_cut_ = false;
}

}  // namespace multimesh::openmesh
