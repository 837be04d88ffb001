// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/tet_domain.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>

#include "multimesh/algorithms/tet_domain_data.hpp"

namespace multimesh {

namespace {

void check_list(const FacetList& list, int dimension, std::size_t tags, std::size_t points,
                const char* what) {
  if (list.dimension != dimension)
    throw InputError(std::string("the list of ") + what + " has dimension " + std::to_string(list.dimension));
  if (tags != 0 && tags != list.size())
    throw InputError(std::to_string(list.size()) + " " + what + ", but " + std::to_string(tags) + " tags");
  for (std::size_t i = 0; i < list.corners.size(); ++i)
    if (list.corners[i] >= points)
      throw InputError(std::string(what) + ": number " + std::to_string(i / list.corners_per_facet()) +
                       " names point " + std::to_string(list.corners[i]) + " of " + std::to_string(points));
}

void check(const TaggedTetrahedra& input) {
  const std::size_t n = input.points.size();
  check_list(input.tets, 3, input.regions.size(), n, "tetrahedra");
  check_list(input.triangles, 2, input.patches.size(), n, "triangles");
  check_list(input.edges, 1, input.edge_tags.size(), n, "edges");
  if (input.tets.size() == 0) throw InputError("there is no tetrahedron");
  for (const Index v : input.fixed)
    if (v >= n) throw InputError("fixed point " + std::to_string(v) + " of " + std::to_string(n));
}

}  // namespace

TetDomain::TetDomain(const TaggedTetrahedra& input, const TetDomainOptions& options)
    : data_(std::make_unique<Data>()) {
  if (!(options.feature_angle > 0)) throw InputError("the feature angle must be above 0");
  check(input);
  const JoinedMesh joined = add_tetrahedra(input, *data_);
  add_surface(input, options, joined, *data_);
  add_curves(input, options, joined, *data_);
}

TetDomain::~TetDomain() = default;
TetDomain::TetDomain(TetDomain&&) noexcept = default;

MultiMesh& TetDomain::tree() {
  return *data_->tree;
}
const MultiMesh& TetDomain::tree() const {
  return *data_->tree;
}
tet::TetMesh& TetDomain::mesh() {
  return *data_->mesh;
}
const tet::TetMesh& TetDomain::mesh() const {
  return *data_->mesh;
}
std::optional<NodeId> TetDomain::surface() const {
  return data_->surface;
}
std::optional<NodeId> TetDomain::curves() const {
  return data_->curves;
}
const TetDomainReport& TetDomain::report() const {
  return data_->report;
}
tet::Property<TetDomain::Point>& TetDomain::points() {
  return *data_->points;
}
const tet::Property<TetDomain::Point>& TetDomain::points() const {
  return *data_->points;
}
tet::Property<TetDomain::Tag>& TetDomain::regions() {
  return *data_->regions;
}
const tet::Property<TetDomain::Tag>& TetDomain::regions() const {
  return *data_->regions;
}
bool TetDomain::is_copy(Index vertex) const {
  return (*data_->copy_of)[vertex] != 0;
}
// Points of copies are numbered from the top downwards, vertices from 0 upwards.
Index TetDomain::joined_point(Index vertex) const {
  const Index source = (*data_->copy_of)[vertex];
  return source == 0 ? vertex : no_index - 1 - source;
}
bool TetDomain::is_copied_edge(Dart edge) const {
  return data_->mesh->value(*data_->copied_edges, edge) != nullptr;
}
bool TetDomain::is_parted_face(Dart face) const {
  return data_->mesh->value(*data_->parted_faces, face) != nullptr;
}
TetDomain::Tag TetDomain::patch(Index triangle) const {
  return (*data_->patches)[triangle];
}
TetDomain::Tag TetDomain::curve_tag(Index edge) const {
  return (*data_->curve_tags)[edge];
}

namespace {

/// Points of the output: one per vertex, but copies of one input point at the same place are one, unless a
/// tetrahedron has come to join two of them: it could not be written.
class OutputPoints {
 public:
  OutputPoints(const tet::TetMesh& mesh, const tet::Property<TetDomain::Point>& points,
               const tet::Property<Index>& copy_of, std::vector<std::array<double, 3>>& out)
      : number_(mesh.capacity(0), no_index), points_(points), copy_of_(copy_of), out_(out) {
    for (Index t = 0; t < mesh.capacity(3); ++t)
      for (int i = 0; i < 4 && mesh.is_live(3, t); ++i)
        for (int j = 0; j < i; ++j) {
          const Index source = copy_of[mesh.corners(t)[i]];
          if (source != 0 && source == copy_of[mesh.corners(t)[j]]) apart_.insert(source);
        }
  }

  Index operator()(Index v) {
    if (number_[v] == no_index) number_[v] = number(v);
    return number_[v];
  }

 private:
  Index number(Index v) {
    const TetDomain::Point& p = points_[v];
    const Index source = apart_.contains(copy_of_[v]) ? 0 : copy_of_[v];
    for (const auto& [other, n] : copies_)
      if (source != 0 && copy_of_[other] == source && points_[other] == p) return n;
    const auto n = static_cast<Index>(out_.size());
    out_.push_back({p[0], p[1], p[2]});
    if (source != 0) copies_.emplace_back(v, n);
    return n;
  }

  std::vector<Index> number_;
  std::set<Index> apart_;                        // input points
  std::vector<std::pair<Index, Index>> copies_;  // vertex, output point
  const tet::Property<TetDomain::Point>& points_;
  const tet::Property<Index>& copy_of_;
  std::vector<std::array<double, 3>>& out_;
};

/// Whether this simplex is new, by its points: copies are written once.
class OncePerPlace {
 public:
  bool operator()(std::initializer_list<Index> points) {
    std::vector<Index> key(points);
    std::sort(key.begin(), key.end());
    return seen_.insert(key).second;
  }

 private:
  std::set<std::vector<Index>> seen_;
};

}  // namespace

TaggedTetrahedra TetDomain::tagged() const {
  const Data& d = *data_;
  const tet::TetMesh& root = *d.mesh;
  TaggedTetrahedra out;
  OutputPoints point(root, *d.points, *d.copy_of, out.points);
  for (Index t = 0; t < root.capacity(3); ++t) {
    if (!root.is_live(3, t)) continue;
    for (int i = 0; i < 4; ++i) out.tets.corners.push_back(point(root.corners(t)[i]));
    out.regions.push_back((*d.regions)[t]);
  }
  OncePerPlace once;
  Index v[4];
  if (d.surface) {
    const Mesh& mesh = d.tree->mesh(*d.surface);
    for (Index f = 0; f < mesh.capacity(2); ++f) {
      if (!mesh.is_live(2, f) || ((*d.implied)[f] && (*d.patches)[f] == 0)) continue;
      // Of boundary triangles, the normal points outwards: away from the fourth vertex.
      const Dart image = d.tree->to_parent(*d.surface, mesh.dart_of(2, f));
      root.vertices(image, v);
      if (root.is_boundary(image, 2) && is_even(root.order(tet::TetMesh::dart(root.tet(image)), image)))
        std::swap(v[0], v[1]);
      if (is_parted_face(image) && !once({point(v[0]), point(v[1]), point(v[2])})) continue;
      for (int i = 0; i < 3; ++i) out.triangles.corners.push_back(point(v[i]));
      out.patches.push_back((*d.patches)[f]);
    }
  }
  if (d.curves) {
    const Mesh& mesh = d.tree->mesh(*d.curves);
    for (Index e = 0; e < mesh.capacity(1); ++e) {
      if (!mesh.is_live(1, e)) continue;
      const Dart image = d.tree->to_parent(*d.curves, mesh.dart_of(1, e));
      root.vertices(image, v);
      if (is_copied_edge(image) && !once({point(v[0]), point(v[1])})) continue;
      for (int i = 0; i < 2; ++i) out.edges.corners.push_back(point(v[i]));
      out.edge_tags.push_back((*d.curve_tags)[e]);
    }
  }
  for (Index i = 0; i < root.capacity(0); ++i)
    if (root.is_live(0, i) && root.is_locked(i) && !(*d.locked_by_cut)[i] && root.dart_of(0, i) != no_dart &&
        once({point(i)}))
      out.fixed.push_back(point(i));
  out.tets.vertices = out.triangles.vertices = out.edges.vertices = static_cast<Index>(out.points.size());
  return out;
}

}  // namespace multimesh
