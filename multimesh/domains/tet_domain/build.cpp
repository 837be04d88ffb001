// SPDX-License-Identifier: BSD-3-Clause
// Which faces of the tetrahedra are the surface, which edges are curves, and which points are fixed.
#include "multimesh/build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/domains/oriented_parts.hpp"
#include "multimesh/domains/tet_domain/data.hpp"
#include "multimesh/faces.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/geometry/tet_shape.hpp"
#include "multimesh/tet/simplex_map.hpp"

namespace multimesh {

using Point = TetDomain::Point;
using Tag = TetDomain::Tag;
using tet::simplex_key;
using tet::SimplexMap;

namespace {

Point point(const TaggedTetrahedra& input, Index i) {
  return input.points[i];
}

/// Turns round the parts of the mesh whose volume is negative as a whole. \return how many tetrahedra are
/// inverted after that
std::size_t make_positive(const TaggedTetrahedra& input, Cut& cut) {
  std::vector<double> volumes(cut.facets.size());
  for (std::size_t t = 0; t < cut.facets.size(); ++t) {
    const auto v = cut.facets.facet(t);
    volumes[t] = six_volume(point(input, cut.source[v[0]]), point(input, cut.source[v[1]]),
                            point(input, cut.source[v[2]]), point(input, cut.source[v[3]]));
  }
  const std::vector<bool> negative = in_negative_part(parts_of(cut.facets), volumes);
  std::size_t inverted = 0;
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    if (negative[t]) {
      std::swap(cut.facets.corners[4 * t], cut.facets.corners[4 * t + 1]);
      cut.reversed[t] = !cut.reversed[t];
    }
    const auto v = cut.facets.facet(t);
    const auto at = [&](std::size_t i) { return input.points[cut.source[v[i]]].data(); };
    inverted += orient3d(at(0), at(1), at(2), at(3)) <= 0;
  }
  return inverted;
}

/// Per point of the input, its place in the list of fixed points: the first one, or no_index.
std::vector<Index> places_of_fixed(const TaggedTetrahedra& input) {
  std::vector<Index> place(input.points.size(), no_index);
  for (std::size_t i = input.fixed.size(); i-- > 0;) place[input.fixed[i]] = static_cast<Index>(i);
  return place;
}

void add_point_values(const TaggedTetrahedra& input, const std::vector<Index>& source, TetDomain::Data& out) {
  out.point_tags = &out.mesh->add_vertex_property<Tag>("tag");
  std::vector<bool> used(input.points.size(), false);
  for (Index v = 0; v < source.size(); ++v) {
    used[source[v]] = true;
    if (!input.point_tags.empty()) out.point_tags->values[v] = input.point_tags[source[v]];
  }
  const std::vector<Index> place = places_of_fixed(input);
  for (Index s = 0; s < used.size(); ++s) {
    out.report.unused_points += !used[s];
    out.report.missing_points += !used[s] && place[s] != no_index;
  }
}

}  // namespace

JoinedMesh add_tetrahedra(const TaggedTetrahedra& input, TetDomain::Data& out) {
  Cut pieces = cut({3, static_cast<Index>(input.points.size()), input.tets.corners});
  out.report.inverted_tets = make_positive(input, pieces);
  out.report.reversed_tets =
      static_cast<std::size_t>(std::count(pieces.reversed.begin(), pieces.reversed.end(), true));
  auto mesh = std::make_unique<tet::TetMesh>(pieces.facets);
  out.mesh = mesh.get();
  out.points = &mesh->add_vertex_property<Point>("points");
  out.regions = &mesh->add_tet_property<Tag>("region");
  out.copy_of = &mesh->add_vertex_property<Index>("copy of");
  std::vector<Index> copies(input.points.size(), 0);
  for (const Index s : pieces.source) out.report.copied_vertices += copies[s]++ > 0;
  for (Index v = 0; v < pieces.source.size(); ++v) {
    const Index s = pieces.source[v];
    out.points->values[v] = point(input, s);
    if (copies[s] < 2) continue;
    out.copy_of->values[v] = s + 1;
    mesh->set_locked(v, true);
  }
  add_point_values(input, pieces.source, out);
  if (!input.regions.empty()) out.regions->values = input.regions;
  out.tet_flags = &mesh->add_tet_property<std::uint8_t>("flags");
  if (!input.tet_flags.empty()) out.tet_flags->values = input.tet_flags;
  out.tree = std::make_unique<MultiMesh>(std::move(mesh));
  JoinedMesh joined{std::move(pieces.source), {}};
  find_copies(out, joined);
  return joined;
}

namespace {

/// The tetrahedron on the other side of the face of a dart with these vertices, also where the cut parted
/// them; no_index at the boundary.
Index tet_beyond(const tet::TetMesh& root, const JoinedMesh& joined, Dart face, const Index* v) {
  const Dart beyond = root.switch_dart(face, 3);
  return beyond != no_dart ? tet::TetMesh::tet(beyond) : joined.beyond.find(simplex_key(v, 2));
}

}  // namespace

void add_surface(const TaggedTetrahedra& input, const TetDomainOptions& options, const JoinedMesh& joined,
                 TetDomain::Data& out) {
  SimplexMap given;
  for (Index i = 0; i < input.triangles.size(); ++i)
    given.set(simplex_key(input.triangles.facet(i).data(), 2), i);
  std::vector<bool> found(input.triangles.size(), false);
  struct Face {
    Tag patch;
    bool implied;
    std::uint8_t flags;
  };
  const tet::TetMesh& root = *out.mesh;
  std::vector<Face> faces;
  const auto belongs = [&](Index s) {
    const Dart d = root.dart_of(2, s);
    Index v[4];
    root.vertices(d, v);
    const Index beyond = tet_beyond(root, joined, d, v);
    for (int i = 0; i < 3; ++i) v[i] = joined.source[v[i]];
    const bool interface =
        options.interfaces && beyond != no_index && (*out.regions)[root.tet(d)] != (*out.regions)[beyond];
    const Index i = given.find(simplex_key(v, 2));
    if (i != no_index) found[i] = true;
    if (i == no_index && !interface && !(options.boundary && beyond == no_index)) return false;
    faces.push_back({i == no_index || input.patches.empty() ? 0 : input.patches[i],
                     i == no_index && !interface, flags_of(input.triangle_flags, i)});
    return true;
  };
  // The child's facets are in the order in which the faces are asked for.
  std::vector<bool> tagged(root.capacity(2), false);
  bool any = false;
  for (Index s = 0; s < tagged.size(); ++s)
    if (root.is_live(2, s)) any |= tagged[s] = belongs(s);
  out.report.missing_triangles = static_cast<std::size_t>(std::count(found.begin(), found.end(), false));
  if (!any) return;
  out.surface = add_child_from_tags(
      *out.tree, NodeId::root, 2, [&](Index s) { return tagged[s]; }, make_mesh);
  Mesh& surface = out.tree->mesh(*out.surface);
  out.patches = &surface.add_values<Tag>(2, "patch");
  out.triangle_flags = &surface.add_values<std::uint8_t>(2, "flags");
  out.implied = &surface.add_values<char>(2, "implied");
  for (std::size_t f = 0; f < faces.size(); ++f) {
    (*out.patches)[f] = faces[f].patch;
    (*out.implied)[f] = faces[f].implied;
    (*out.triangle_flags)[f] = faces[f].flags;
  }
}

namespace {

/// An edge of the root that the surface or a tag touches.
struct CurveEdge {
  std::array<Index, 2> ends{};  ///< input points
  int sheets = 0;               ///< faces of the surface around it
  /// Of two of them: the patch, and whether they are there only as boundary.
  std::pair<Tag, bool> patches[2]{};
  Point normals[2]{};  ///< theirs, of length 1, or 0
  bool has_tag = false;
  Tag tag = 0;
  std::uint8_t flags = unlisted_simplex;

  bool is_sharp(double angle) const {
    if (angle > std::numbers::pi) return false;
    const double cosine = dot(normals[0], normals[1]), sine = cross(normals[0], normals[1]).norm();
    return normals[0] != Point{} && normals[1] != Point{} && std::atan2(sine, cosine) >= angle;
  }
  bool is_curve(double angle) const {
    return has_tag || (sheets > 0 && (sheets != 2 || patches[0] != patches[1] || is_sharp(angle)));
  }
  /// Curves end where this changes.
  auto kind() const {
    auto sides = std::pair<std::pair<Tag, bool>, std::pair<Tag, bool>>();
    if (sheets == 2) sides = std::minmax({patches[0], patches[1]});
    return std::tuple(sheets, sides, has_tag, tag);
  }
};

/// By input points: copies of an edge are one, and all faces of the surface around them count.
class Curves {
 public:
  explicit Curves(const std::vector<Index>& source) : source_(source) {}

  CurveEdge& at(const Index* ends) {
    const tet::SimplexKey key = key_of(ends);
    Index i = numbers_.find(key);
    if (i == no_index) {
      i = static_cast<Index>(edges.size());
      numbers_.set(key, i);
      edges.emplace_back().ends = {key[0], key[1]};
    }
    return edges[i];
  }
  const CurveEdge* find(const Index* ends) const {
    const Index i = numbers_.find(key_of(ends));
    return i == no_index ? nullptr : &edges[i];
  }

  std::vector<CurveEdge> edges;

 private:
  tet::SimplexKey key_of(const Index* ends) const {
    const Index points[2] = {source_[ends[0]], source_[ends[1]]};
    return simplex_key(points, 1);
  }

  const std::vector<Index>& source_;
  SimplexMap numbers_;
};

/// Every edge of every triangle of the surface. The normals of two triangles are compared as if both ran
/// along the edge in opposite directions.
void add_edges_of_surface(const TetDomain::Data& domain, const JoinedMesh& joined, Curves& out) {
  const Mesh& surface = domain.tree->mesh(*domain.surface);
  const auto& points = *domain.points;
  for (Index f = 0; f < surface.capacity(2); ++f) {
    const Dart d = domain.tree->to_parent(*domain.surface, surface.dart_of(2, f));
    Index v[4];
    domain.mesh->vertices(d, v);
    const Index beyond = joined.beyond.find(simplex_key(v, 2));
    if (beyond != no_index && beyond < domain.mesh->tet(d)) continue;  // its other copy has been counted
    const Point normal = cross(points[v[1]] - points[v[0]], points[v[2]] - points[v[0]]).unit_or_zero();
    for (int i = 0; i < 3; ++i) {
      const Index ends[2] = {v[i], v[(i + 1) % 3]};
      CurveEdge& e = out.at(ends);
      if (e.sheets < 2) {
        e.patches[e.sheets] = {(*domain.patches)[f], (*domain.implied)[f] != 0};
        const bool ascends = joined.source[ends[0]] < joined.source[ends[1]];
        e.normals[e.sheets] = ascends == (e.sheets == 0) ? normal : -normal;
      }
      ++e.sheets;
    }
  }
}

/// All edges of the tetrahedra that have these input points as ends.
std::size_t add_tagged_edges(const TaggedTetrahedra& input, const std::vector<Index>& source,
                             const TetDomain::Data& domain, Curves& out) {
  if (input.edges.size() == 0) return 0;
  SimplexMap given;
  for (Index i = 0; i < input.edges.size(); ++i) given.set(simplex_key(input.edges.facet(i).data(), 1), i);
  std::vector<bool> found(input.edges.size(), false);
  const tet::TetMesh& root = *domain.mesh;
  for (Index t = 0; t < root.capacity(3); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        const Index ends[2] = {root.corners(t)[j], root.corners(t)[i]};
        const Index named[2] = {source[ends[0]], source[ends[1]]};
        const Index n = given.find(simplex_key(named, 1));
        if (n == no_index) continue;
        found[n] = true;
        CurveEdge& e = out.at(ends);
        e.has_tag = true;
        e.tag = input.edge_tags.empty() ? 0 : input.edge_tags[n];
        e.flags = flags_of(input.edge_flags, n);
      }
  return static_cast<std::size_t>(std::count(found.begin(), found.end(), false));
}

/// Vertices that only a point can hold: where sheets touch and no curve goes through, and where a curve that
/// does not run on the surface touches it.
std::vector<bool> touching_points(const TetDomain::Data& domain, const std::vector<Index>& source,
                                  const Curves& curves, double angle) {
  std::vector<bool> touching(source.size(), false);
  if (!domain.surface || source.empty()) return touching;
  const Mesh& surface = domain.tree->mesh(*domain.surface);
  std::vector<Index> fans(*std::max_element(source.begin(), source.end()) + std::size_t{1}, 0);
  for (Index v = 0; v < surface.capacity(0); ++v)
    if (const Dart d = surface.dart_of(0, v); d != no_dart)
      ++fans[source[domain.mesh->vertex(domain.tree->to_parent(*domain.surface, d))]];
  std::vector<bool> on_curve(fans.size(), false), on_free_curve(fans.size(), false);
  for (const CurveEdge& e : curves.edges)
    if (e.is_curve(angle))
      for (const Index p : e.ends) {
        on_curve[p] = true;
        if (e.sheets == 0) on_free_curve[p] = true;
      }
  for (Index v = 0; v < source.size(); ++v) {
    const Index p = source[v];
    touching[v] = (fans[p] > 1 && !on_curve[p]) || (fans[p] > 0 && on_free_curve[p]);
  }
  return touching;
}

}  // namespace

std::vector<bool> add_curves(const TaggedTetrahedra& input, const TetDomainOptions& options,
                             const JoinedMesh& joined, TetDomain::Data& out) {
  const std::vector<Index>& source = joined.source;
  Curves curves(source);
  if (out.surface) add_edges_of_surface(out, joined, curves);
  out.report.missing_edges = add_tagged_edges(input, source, out, curves);
  std::vector<bool> touching = touching_points(out, source, curves, options.feature_angle);

  tet::TetMesh& root = *out.mesh;
  std::vector<std::set<decltype(CurveEdge().kind())>> kinds(input.points.size());
  for (const CurveEdge& e : curves.edges)
    if (e.is_curve(options.feature_angle))
      for (const Index p : e.ends) kinds[p].insert(e.kind());
  std::vector<Tag> tags;
  std::vector<std::uint8_t> flags;
  std::vector<bool> tagged(root.capacity(1), false);
  for (Index s = 0; s < tagged.size(); ++s) {
    Index ends[4];
    root.vertices(root.dart_of(1, s), ends);
    const CurveEdge* e = curves.find(ends);
    if (!e || !e->is_curve(options.feature_angle) || !root.is_live(1, s)) continue;
    tagged[s] = true;
    tags.push_back(e->tag);
    flags.push_back(e->flags);
  }
  if (tags.empty()) return touching;
  const CutOptions ends{[&](Index v) { return kinds[source[v]].size() > 1; }};
  out.curves = add_child_from_tags(
      *out.tree, NodeId::root, 1, [&](Index s) { return tagged[s]; }, make_mesh, ends);
  Mesh& lines = out.tree->mesh(*out.curves);
  out.curve_tags = &lines.add_values<Tag>(1, "tag");
  std::copy(tags.begin(), tags.end(), out.curve_tags->begin());
  out.curve_flags = &lines.add_values<std::uint8_t>(1, "flags");
  std::copy(flags.begin(), flags.end(), out.curve_flags->begin());
  return touching;
}

void add_fixed_points(const TaggedTetrahedra& input, const JoinedMesh& joined,
                      const std::vector<bool>& touching, TetDomain::Data& out) {
  const std::vector<Index> place = places_of_fixed(input);
  std::vector<Tag> tags;
  std::vector<std::uint8_t> flags;
  std::vector<bool> fixed(joined.source.size(), false);
  for (Index v = 0; v < fixed.size(); ++v) {
    const Index listed = place[joined.source[v]];
    fixed[v] = listed != no_index || touching[v] || (*out.copy_of)[v] != 0;
    if (!fixed[v]) continue;
    tags.push_back(listed == no_index || input.fixed_tags.empty() ? 0 : input.fixed_tags[listed]);
    flags.push_back(flags_of(input.fixed_flags, listed));
  }
  if (tags.empty()) return;
  out.fixed_points = add_child_from_tags(
      *out.tree, NodeId::root, 0, [&](Index v) { return fixed[v]; }, make_mesh);
  Mesh& points = out.tree->mesh(*out.fixed_points);
  out.fixed_tags = &points.add_values<Tag>(0, "tag");
  *out.fixed_tags = std::move(tags);
  out.fixed_flags = &points.add_values<std::uint8_t>(0, "flags");
  *out.fixed_flags = std::move(flags);
}

}  // namespace multimesh
