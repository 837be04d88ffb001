// SPDX-License-Identifier: BSD-3-Clause
// The curves of a textured surface: which edges, of which kinds, and where they end.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "multimesh/build.hpp"
#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/domains/textured_surface/data.hpp"

namespace multimesh {

namespace {

class CurveBuilder {
 public:
  CurveBuilder(const TexturedTriangles& input, const TexturedSurfaceOptions& options,
               TexturedSurface::Data& out)
      : input_(input),
        options_(options),
        out_(out),
        root_(out.tree->mesh(NodeId::root)),
        kinds_(root_.capacity(1), no_curve) {}

  void run();

 private:
  void find_texture_borders(std::size_t set);
  void find_other_borders();
  void find_sharp_edges();
  template <class Test>
  void mark_where(CurveKind kind, const Test& differ);
  void collect_ends();
  bool ends_at(Index vertex) const;
  void add();

  struct AtVertex {
    int degree = 0;
    CurveKinds kinds = no_curve;
    bool same_kinds = true;
  };

  const TexturedTriangles& input_;
  const TexturedSurfaceOptions& options_;
  TexturedSurface::Data& out_;
  const Mesh& root_;
  std::vector<CurveKinds> kinds_;  // per edge of the surface
  std::vector<AtVertex> at_;       // per vertex of the surface
};

void CurveBuilder::run() {
  for (std::size_t set = 0; set < out_.textures.size(); ++set) find_texture_borders(set);
  find_other_borders();
  find_sharp_edges();
  if (std::all_of(kinds_.begin(), kinds_.end(), [](CurveKinds k) { return k == no_curve; })) return;
  collect_ends();
  add();
}

// An edge inside the surface with two copies in the texture's boundary is a seam, with one its border.
void CurveBuilder::find_texture_borders(std::size_t set) {
  const NodeId node = out_.textures[set];
  const Mesh& texture = out_.tree->mesh(node);
  std::vector<std::uint8_t> copies(kinds_.size(), 0);
  for (Index t = 0; t < texture.capacity(1); ++t) {
    const Dart d = texture.dart_of(1, t);
    if (texture.is_boundary(d, 1)) ++copies[root_.simplex(out_.tree->to_parent(node, d), 1)];
  }
  for (Index e = 0; e < kinds_.size(); ++e)
    if (copies[e] > 0 && !root_.is_boundary(root_.dart_of(1, e), 1))
      kinds_[e] |= copies[e] == 2 ? seam_of(set) : texture_border_of(set);
}

/// Marks the edges inside the surface whose two triangles differ.
template <class Test>
void CurveBuilder::mark_where(CurveKind kind, const Test& differ) {
  for (Index e = 0; e < kinds_.size(); ++e) {
    const Dart d = root_.dart_of(1, e), across = root_.switch_dart(d, 2);
    if (across != no_dart && differ(root_.facet(d), root_.facet(across))) kinds_[e] |= kind;
  }
}

void CurveBuilder::find_other_borders() {
  const auto& reversed = *out_.reversed;
  if (out_.report.reversed_triangles > 0)
    mark_where(reversed_border_curve, [&](Index f, Index g) { return reversed[f] != reversed[g]; });
  const auto& labels = input_.labels;
  if (!labels.empty() && options_.keep_label_borders)
    mark_where(label_border_curve, [&](Index f, Index g) { return labels[f] != labels[g]; });
}

void CurveBuilder::find_sharp_edges() {
  if (!(options_.feature_angle > 0)) throw InputError("the feature angle is not above 0 radians");
  if (options_.feature_angle > std::numbers::pi) return;
  std::vector<Vec3> normals(root_.capacity(2));  // of any length
  for (Index f = 0; f < normals.size(); ++f) {
    std::array<Index, 4> v{};
    root_.vertices(root_.dart_of(2, f), v.data());
    const Vec3 &p = (*out_.positions)[v[0]], &q = (*out_.positions)[v[1]], &r = (*out_.positions)[v[2]];
    normals[f] = cross(q - p, r - p);
  }
  // An angle that is equal but for roundings counts: those of a box, for instance.
  const double least = options_.feature_angle - 1e-9;
  mark_where(sharp_curve, [&](Index f, Index g) {
    const Vec3 &m = normals[f], &n = normals[g];
    const bool have_area = m.squared_norm() > 0 && n.squared_norm() > 0;
    return have_area && std::atan2(cross(m, n).norm(), dot(m, n)) >= least;
  });
}

void CurveBuilder::collect_ends() {
  at_.resize(root_.capacity(0));
  for (Index e = 0; e < kinds_.size(); ++e) {
    if (kinds_[e] == no_curve) continue;
    const Dart d = root_.dart_of(1, e);
    for (const Dart end : {d, root_.switch_dart(d, 0)}) {
      AtVertex& v = at_[root_.vertex(end)];
      v.same_kinds &= v.degree++ == 0 || v.kinds == kinds_[e];
      v.kinds = kinds_[e];
    }
  }
}

// A curve goes on through a vertex only if nothing but that one curve passes there.
bool CurveBuilder::ends_at(Index vertex) const {
  const AtVertex& here = at_[vertex];
  if (here.degree != 2 || !here.same_kinds) return true;
  const Dart d = root_.dart_of(0, vertex);
  if (root_.is_boundary(d, 0)) return true;
  for (std::size_t set = 0; set < out_.textures.size(); ++set) {
    DartBuffer copies;
    out_.tree->to_child(out_.textures[set], d, 0, copies);
    if (copies.size() > ((here.kinds & seam_of(set)) != 0 ? 2U : 1U)) return true;
  }
  return false;
}

void CurveBuilder::add() {
  const NodeId node =
      add_child_from_tags(*out_.tree, NodeId::root, 1, [&](Index e) { return kinds_[e] != no_curve; },
                          make_mesh, {[&](Index v) { return ends_at(v); }});
  out_.curves = node;
  out_.curve_kinds = out_.add_values<CurveKinds>(node, 1, "curve kinds");
  const Mesh& curves = out_.tree->mesh(node);
  for (Index c = 0; c < curves.capacity(1); ++c)
    (*out_.curve_kinds)[c] = kinds_[root_.simplex(out_.tree->to_parent(node, curves.dart_of(1, c)), 1)];
}

}  // namespace

void add_curves(const TexturedTriangles& input, const TexturedSurfaceOptions& options,
                TexturedSurface::Data& out) {
  CurveBuilder(input, options, out).run();
}

}  // namespace multimesh
