// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/open_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "multimesh/error.hpp"
#include "multimesh/geometry/closest_point.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

/// How near two faces that face each other must be to be taken for two sides, relative to their altitudes.
constexpr double nearly = 0.15;

/// A face of a facet: the one opposite to corner `opposite`.
struct Face {
  std::size_t facet;
  std::size_t opposite;
};

/// The vertices of a face modulo the lattice: classes, and offsets from that of the first one. Copies of a
/// face have the same.
struct FaceKey {
  std::array<Index, 3> classes{};
  std::array<LatticeVector, 3> offsets{};
  friend auto operator<=>(const FaceKey&, const FaceKey&) = default;
};

FaceKey key_of(const LabelledTile& tile, const Face& face) {
  const auto corners = tile.facets.facet(face.facet);
  std::array<std::pair<Index, LatticeVector>, 3> v;
  v.fill({no_index, {}});
  std::size_t n = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (i != face.opposite) v[n++] = {tile.vertex_class[corners[i]], tile.offset[corners[i]]};
  std::sort(v.begin(), v.end());
  FaceKey key;
  for (std::size_t i = 0; i < n; ++i) key.classes[i] = v[i].first, key.offsets[i] = v[i].second - v[0].second;
  return key;
}

/// Tells which facets reach to where a lattice vector leads from another part of the tile, by boxes.
class Reach {
 public:
  Reach(const LabelledTile& tile, const Lattice& lattice, std::span<const LatticeVector> vectors,
        double tolerance)
      : tile_(tile), whole_(box_of(tile.facets.corners)) {
    whole_.min().array() -= tolerance, whole_.max().array() += tolerance;
    for (const LatticeVector& v : vectors) shifts_.emplace_back(lattice.shift(v).data());
  }
  bool operator()(std::size_t f) const {
    Box box = box_of(tile_.facets.facet(f));
    const double more = nearly * box.sizes().maxCoeff();
    box.min().array() -= more, box.max().array() += more;
    return std::any_of(shifts_.begin(), shifts_.end(), [&](const Eigen::Vector3d& shift) {
      return whole_.intersects(Box(box.min() + shift, box.max() + shift)) ||
             whole_.intersects(Box(box.min() - shift, box.max() - shift));
    });
  }

 private:
  using Box = Eigen::AlignedBox3d;
  Box box_of(std::span<const Index> vertices) const {
    Box box;
    for (const Index v : vertices) box.extend(Eigen::Vector3d(tile_.point[v].data()));
    return box;
  }

  const LabelledTile& tile_;
  Box whole_;
  std::vector<Eigen::Vector3d> shifts_;
};

/// The faces that no other facet has, not even a lattice vector away. Of facets within reach.
std::vector<Face> free_faces(const LabelledTile& tile, const Reach& reaches) {
  std::vector<std::pair<FaceKey, Face>> all;
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    if (!reaches(f)) continue;
    for (std::size_t i = 0; i < tile.facets.corners_per_facet(); ++i)
      all.emplace_back(key_of(tile, {f, i}), Face{f, i});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.facet < b.second.facet;
  });
  std::vector<Face> free;
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    while (end < all.size() && all[end].first == all[i].first) ++end;
    if (end == i + 1) free.push_back(all[i].second);
  }
  return free;
}

/// A free face in space. That of a triangle, an edge, is a triangle without area.
struct FreeFace {
  spatial::Triangle corners{};
  Vec3 middle, outward;  // unit, or 0
  double altitude = 0;   // the least one
  double near = 0;       // a face closer than this lies on another one, if they face each other

  FreeFace(const LabelledTile& tile, const Face& face, double tolerance) {
    const auto v = tile.facets.facet(face.facet);
    std::array<Vec3, 3> p{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      if (i != face.opposite) p[n++] = tile.point[v[i]];
    if (n == 2) p[2] = (p[0] + p[1]) / 2;
    corners = p;
    middle = (p[0] + p[1] + p[2]) / 3;
    outward = middle - tile.point[v[face.opposite]];
    const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]), edge = p[1] - p[0];
    if (n == 3) {
      outward = dot(normal, outward) < 0 ? -normal : normal;
      const double longest = std::max({edge.norm(), (p[2] - p[0]).norm(), (p[2] - p[1]).norm()});
      altitude = longest > 0 ? normal.norm() / longest : 0;
    } else {
      altitude = edge.norm();
      if (altitude > 0) outward -= edge * (dot(edge, outward) / edge.squared_norm());
    }
    outward = outward.unit_or_zero();
    near = std::max(tolerance, nearly * altitude);
  }
  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : corners) box.extend(Eigen::Vector3d(p.data()));
    return {box.min().array() - near, box.max().array() + near};
  }
};

/// Faces in cells of about their size. Those that are much larger are in a list of their own.
class FaceGrid {
 public:
  FaceGrid(const LabelledTile& tile, const std::vector<Face>& faces, double tolerance)
      : tolerance_(tolerance) {
    double sum = 0;
    for (const Face& face : faces) sum += faces_.emplace_back(tile, face, tolerance).box().sizes().maxCoeff();
    size_ = 2 * sum / static_cast<double>(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) insert(i);
  }

  /// The face on which `face` comes to lie when it is shifted, or nothing.
  std::optional<std::size_t> meets(std::size_t face, const Vec3& shift) const {
    const Vec3 p = faces_[face].middle + shift;
    const auto is_met = [&](std::size_t i) { return i != face && lies_on(faces_[face], p, faces_[i]); };
    if (const auto cell = cells_.find(key(p)); cell != cells_.end())
      for (const std::size_t i : cell->second)
        if (is_met(i)) return i;
    for (const std::size_t i : large_)
      if (is_met(i)) return i;
    return std::nullopt;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;

  bool lies_on(const FreeFace& face, const Vec3& p, const FreeFace& other) const {
    const auto nearest = spatial::closest_point(p, other.corners);
    if (nearest.squared_distance <= tolerance_ * tolerance_) return true;
    const double near = std::min(face.near, other.near);
    return nearest.squared_distance <= near * near && dot(face.outward, other.outward) < -0.7;
  }
  std::int64_t cell_along(double x) const { return static_cast<std::int64_t>(std::floor(x / size_)); }
  Key key(const Vec3& p) const {
    return {static_cast<std::uint64_t>(cell_along(p[0])), static_cast<std::uint64_t>(cell_along(p[1])),
            static_cast<std::uint64_t>(cell_along(p[2]))};
  }

  void insert(std::size_t i) {
    const Eigen::AlignedBox3d box = faces_[i].box();
    if ((box.sizes().array() > 8 * size_).any()) return large_.push_back(i);
    std::array<std::int64_t, 3> first{}, last{};
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = cell_along(box.min()[static_cast<Eigen::Index>(k)]);
      last[k] = cell_along(box.max()[static_cast<Eigen::Index>(k)]);
    }
    for (auto x = first[0]; x <= last[0]; ++x)
      for (auto y = first[1]; y <= last[1]; ++y)
        for (auto z = first[2]; z <= last[2]; ++z)
          cells_[{static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y),
                  static_cast<std::uint64_t>(z)}]
              .push_back(i);
  }

  double tolerance_, size_ = 0;
  std::vector<FreeFace> faces_;
  std::vector<std::size_t> large_;
  std::unordered_map<Key, std::vector<std::size_t>, ArrayHash> cells_;
};

}  // namespace

void require_no_open_sides(const LabelledTile& tile, const Lattice& lattice,
                           std::span<const LatticeVector> vectors, double tolerance) {
  if (vectors.empty()) return;
  const std::vector<Face> faces = free_faces(tile, Reach(tile, lattice, vectors, tolerance));
  if (faces.empty()) return;
  const FaceGrid grid(tile, faces, tolerance);
  for (const LatticeVector& v : vectors)
    for (const int sign : {1, -1})
      for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto j = grid.meets(i, double(sign) * lattice.shift(v));
        if (!j) continue;
        throw InputError("the sides of the tile do not match facet by facet: facets " +
                         std::to_string(tile.input_facet[faces[i].facet]) + " and " +
                         std::to_string(tile.input_facet[faces[*j].facet]) + " meet after gluing along " +
                         name_of(v) +
                         ", but have no face in common; mesh both sides alike, or give the pairs");
      }
}

}  // namespace multimesh
