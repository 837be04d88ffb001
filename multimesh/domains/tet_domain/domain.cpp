// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/tet_domain/data.hpp"

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

void check_values(std::size_t values, std::size_t simplices, const char* what) {
  if (values != 0 && values != simplices)
    throw InputError(std::to_string(simplices) + " " + what + ", but " + std::to_string(values) +
                     " tags or flags");
}

void check(const TaggedTetrahedra& input) {
  const std::size_t n = input.points.size();
  check_values(input.tet_flags.size(), input.tets.size(), "tetrahedra");
  check_values(input.triangle_flags.size(), input.triangles.size(), "triangles");
  check_values(input.edge_flags.size(), input.edges.size(), "edges");
  check_values(input.fixed_tags.size(), input.fixed.size(), "fixed points");
  check_values(input.fixed_flags.size(), input.fixed.size(), "fixed points");
  check_values(input.point_tags.size(), n, "points");
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
  const std::vector<bool> touching = add_curves(input, options, joined, *data_);
  add_fixed_points(input, joined, touching, *data_);
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
std::optional<NodeId> TetDomain::fixed_points() const {
  return data_->fixed_points;
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
TetDomain::Tag TetDomain::fixed_tag(Index point) const {
  return (*data_->fixed_tags)[point];
}
std::uint8_t TetDomain::flags(int dimension, Index simplex) const {
  if (dimension == 3) return (*data_->tet_flags)[simplex];
  return (dimension == 2   ? *data_->triangle_flags
          : dimension == 1 ? *data_->curve_flags
                           : *data_->fixed_flags)[simplex];
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

/// What a domain is written as, list by list.
class Writer {
 public:
  Writer(const TetDomain& domain, const TetDomain::Data& data, TaggedTetrahedra& out)
      : domain_(domain),
        data_(data),
        root_(*data.mesh),
        out_(out),
        point_(root_, *data.points, *data.copy_of, out.points) {}

  void tetrahedra() {
    for (Index t = 0; t < root_.capacity(3); ++t) {
      if (!root_.is_live(3, t)) continue;
      for (int i = 0; i < 4; ++i) out_.tets.corners.push_back(point_(root_.corners(t)[i]));
      out_.regions.push_back((*data_.regions)[t]);
      out_.tet_flags.push_back((*data_.tet_flags)[t]);
    }
  }

  void surface() {
    const Mesh& mesh = data_.tree->mesh(*data_.surface);
    for (Index f = 0; f < mesh.capacity(2); ++f) {
      if (!mesh.is_live(2, f) || ((*data_.implied)[f] && (*data_.patches)[f] == 0)) continue;
      // Of boundary triangles, the normal points outwards: away from the fourth vertex.
      Index v[4];
      const Dart image = data_.tree->to_parent(*data_.surface, mesh.dart_of(2, f));
      root_.vertices(image, v);
      if (root_.is_boundary(image, 2) && is_even(root_.order(tet::TetMesh::dart(root_.tet(image)), image)))
        std::swap(v[0], v[1]);
      if (domain_.is_parted_face(image) && !once_({point_(v[0]), point_(v[1]), point_(v[2])})) continue;
      for (int i = 0; i < 3; ++i) out_.triangles.corners.push_back(point_(v[i]));
      out_.patches.push_back((*data_.patches)[f]);
      out_.triangle_flags.push_back((*data_.triangle_flags)[f]);
    }
  }

  void curves() {
    const Mesh& mesh = data_.tree->mesh(*data_.curves);
    for (Index e = 0; e < mesh.capacity(1); ++e) {
      if (!mesh.is_live(1, e)) continue;
      Index v[4];
      const Dart image = data_.tree->to_parent(*data_.curves, mesh.dart_of(1, e));
      root_.vertices(image, v);
      if (domain_.is_copied_edge(image) && !once_({point_(v[0]), point_(v[1])})) continue;
      for (int i = 0; i < 2; ++i) out_.edges.corners.push_back(point_(v[i]));
      out_.edge_tags.push_back((*data_.curve_tags)[e]);
      out_.edge_flags.push_back((*data_.curve_flags)[e]);
    }
  }

  void fixed_points() {
    const Mesh& mesh = data_.tree->mesh(*data_.fixed_points);
    for (Index p = 0; p < mesh.capacity(0); ++p) {
      if (!mesh.is_live(0, p)) continue;
      const Index v = root_.vertex(data_.tree->to_parent(*data_.fixed_points, mesh.dart_of(0, p)));
      if (!once_({point_(v)})) continue;
      out_.fixed.push_back(point_(v));
      out_.fixed_tags.push_back((*data_.fixed_tags)[p]);
      out_.fixed_flags.push_back((*data_.fixed_flags)[p]);
    }
  }

  void point_tags() {
    out_.point_tags.resize(out_.points.size());
    for (Index v = 0; v < root_.capacity(0); ++v)
      if (root_.is_live(0, v) && (*data_.point_tags)[v] != 0)
        out_.point_tags[point_(v)] = (*data_.point_tags)[v];
  }

 private:
  const TetDomain& domain_;
  const TetDomain::Data& data_;
  const tet::TetMesh& root_;
  TaggedTetrahedra& out_;
  OutputPoints point_;
  OncePerPlace once_;
};

}  // namespace

TaggedTetrahedra TetDomain::tagged() const {
  TaggedTetrahedra out;
  Writer write(*this, *data_, out);
  write.tetrahedra();
  if (data_->surface) write.surface();
  if (data_->curves) write.curves();
  if (data_->fixed_points) write.fixed_points();
  write.point_tags();
  out.tets.vertices = out.triangles.vertices = out.edges.vertices = static_cast<Index>(out.points.size());
  return out;
}

}  // namespace multimesh
