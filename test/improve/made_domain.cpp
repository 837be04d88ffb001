// SPDX-License-Identifier: BSD-3-Clause
#include "test/improve/made_domain.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/improvement/amips.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/validate.hpp"
#include "test/support/topology.hpp"

namespace multimesh::test {

namespace {

constexpr int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

class BoxMaker {
 public:
  explicit BoxMaker(const BoxOptions& o) : n_(o.n) {
    box_.options = o;
    make_points();
    make_tets();
    make_faces();
    if (o.curve)
      for (int k = 0; k < n_; ++k)
        add({vertex({1, 1, k}), vertex({1, 1, k + 1})}, box_.input.edges, 7, box_.input.edge_tags);
    squash();
    make_planes();
  }
  Box box_;

 private:
  using Cell = std::array<int, 3>;
  Index vertex(Cell c) const { return static_cast<Index>((c[2] * (n_ + 1) + c[1]) * (n_ + 1) + c[0]); }
  Vec3 mapped(const Vec3& p) const { return box_.options.map * p; }
  double part(int i) const { return static_cast<double>(i) / n_; }

  void make_points() {
    for (int k = 0; k <= n_; ++k)
      for (int j = 0; j <= n_; ++j)
        for (int i = 0; i <= n_; ++i) {
          const Vec3 p = mapped({part(i), part(j), part(k)});
          box_.input.points.push_back({p[0], p[1], p[2]});
        }
    const auto count = static_cast<Index>(box_.input.points.size());
    box_.input.tets.vertices = box_.input.triangles.vertices = box_.input.edges.vertices = count;
  }

  void make_tets() {
    for (int k = 0; k < n_; ++k)
      for (int j = 0; j < n_; ++j)
        for (int i = 0; i < n_; ++i)
          for (const auto& a : axes) {
            Cell c{i, j, k};
            std::array<Index, 4> v{vertex(c)};
            for (std::size_t s = 0; s < 3; ++s) {
              ++c[static_cast<std::size_t>(a[s])];
              v[s + 1] = vertex(c);
            }
            const bool odd = (a[1] - a[0] + 3) % 3 != 1;
            if (odd) std::swap(v[2], v[3]);
            box_.input.tets.corners.insert(box_.input.tets.corners.end(), v.begin(), v.end());
            box_.input.regions.push_back(box_.options.regions && 2 * i >= n_ ? 2 : 1);
          }
  }

  static void add(std::vector<Index> corners, FacetList& list, TetDomain::Tag tag,
                  std::vector<TetDomain::Tag>& tags) {
    list.corners.insert(list.corners.end(), corners.begin(), corners.end());
    tags.push_back(tag);
  }

  Cell cell(Index v) const {
    const int i = static_cast<int>(v), m = n_ + 1;
    return {i % m, i / m % m, i / m / m};
  }

  // The patch of a face of the mesh, 0 if it is in none.
  TetDomain::Tag patch(const std::array<Index, 3>& f) const {
    const Cell c[3] = {cell(f[0]), cell(f[1]), cell(f[2])};
    const auto all_at = [&](std::size_t axis, int value) {
      return c[0][axis] == value && c[1][axis] == value && c[2][axis] == value;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        if (all_at(axis, side * n_)) return static_cast<TetDomain::Tag>(11 + 2 * axis) + side;
    if (box_.options.regions && all_at(0, n_ / 2)) return 3;
    const auto in_region_2 = [&](const Cell& x) { return 2 * x[0] >= n_; };
    if (box_.options.sheet && all_at(2, n_ / 2) && std::all_of(c, c + 3, in_region_2)) return 5;
    return 0;
  }

  void make_faces() {
    std::set<std::array<Index, 3>> seen;
    for (std::size_t t = 0; t < box_.input.tets.size(); ++t)
      for (std::size_t skip = 0; skip < 4; ++skip) {
        std::array<Index, 3> f{};
        std::size_t n = 0;
        for (std::size_t i = 0; i < 4; ++i)
          if (i != skip) f[n++] = box_.input.tets.facet(t)[i];
        std::sort(f.begin(), f.end());
        const TetDomain::Tag tag = patch(f);
        if (tag == 0 || !seen.insert(f).second) continue;
        for (const Index v : f) held_.insert(v);
        add({f[0], f[1], f[2]}, box_.input.triangles, tag, box_.input.patches);
      }
    if (box_.options.curve)
      for (int k = 0; k <= n_; ++k) held_.insert(vertex({1, 1, k}));
  }

  double volume(std::size_t t) const {
    const auto v = box_.input.tets.facet(t);
    const auto p = [&](std::size_t i) { return Vec3(box_.input.points[v[i]].data()); };
    return (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0));
  }

  // Volumes are linear in the place of one vertex: the first tetrahedron that becomes flat is found at once.
  void squash() {
    std::vector<std::vector<std::size_t>> around(box_.input.points.size());
    for (std::size_t t = 0; t < box_.input.tets.size(); ++t)
      for (const Index v : box_.input.tets.facet(t)) around[v].push_back(t);
    std::mt19937 random(box_.options.seed);
    const auto uniform = [&] { return static_cast<double>(random()) / 0x1p31 - 1; };
    for (Index v = 0; v < box_.input.points.size(); ++v) {
      const Vec3 direction = mapped({uniform(), uniform(), uniform()});
      if (held_.contains(v)) continue;
      auto& p = box_.input.points[v];
      const auto old = p;
      double step = 1;
      for (const std::size_t t : around[v]) {
        const double before = volume(t);
        for (std::size_t i = 0; i < 3; ++i) p[i] = old[i] + direction[static_cast<int>(i)];
        const double after = volume(t);
        p = old;
        if (after < before) step = std::min(step, before / (before - after));
      }
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = old[i] + box_.options.squash * step * direction[static_cast<int>(i)];
    }
  }

  void make_planes() {
    const auto plane = [&](int axis, double at) {
      Vec3 p[3];
      for (int i = 0; i < 3; ++i) {
        p[i].setZero();
        p[i][axis] = at;
        if (i > 0) p[i][(axis + i) % 3] = 1;
        p[i] = mapped(p[i]);
      }
      box_.planes.push_back({p[0], p[1], p[2]});
    };
    for (int axis = 0; axis < 3; ++axis)
      for (const double at : {0.0, 1.0}) plane(axis, at);
    if (box_.options.regions) plane(0, 0.5);
    if (box_.options.sheet) plane(2, 0.5);
    for (int i = 0; i < 8; ++i)
      box_.corners.push_back(mapped({double(i & 1), double(i >> 1 & 1), double(i >> 2)}));
  }

  int n_;
  std::set<Index> held_;
};

template <class Map>
std::string compare(const Map& before, const Map& after, double tolerance, const char* what) {
  if (before.size() != after.size()) return std::string(what) + ": other tags; ";
  for (const auto& [tag, value] : before) {
    const auto found = after.find(tag);
    if (found == after.end() || std::abs(found->second - value) > tolerance * value)
      return std::string(what) + " of tag " + std::to_string(tag) + " changed; ";
  }
  return {};
}

struct Measures {
  std::map<TetDomain::Tag, double> volumes, areas, lengths;

  explicit Measures(const TaggedTetrahedra& t) {
    const auto p = [&](const FacetList& list, std::size_t f, std::size_t i) {
      return Vec3(t.points[list.facet(f)[i]].data());
    };
    for (std::size_t f = 0; f < t.tets.size(); ++f) {
      const Vec3 a = p(t.tets, f, 0);
      volumes[t.regions[f]] += (p(t.tets, f, 1) - a).cross(p(t.tets, f, 2) - a).dot(p(t.tets, f, 3) - a) / 6;
    }
    for (std::size_t f = 0; f < t.triangles.size(); ++f) {
      const Vec3 a = p(t.triangles, f, 0);
      areas[t.patches[f]] += (p(t.triangles, f, 1) - a).cross(p(t.triangles, f, 2) - a).norm() / 2;
    }
    for (std::size_t f = 0; f < t.edges.size(); ++f)
      lengths[t.edge_tags[f]] += (p(t.edges, f, 1) - p(t.edges, f, 0)).norm();
  }
};

std::vector<long> topology_of(const TetDomain& domain) {
  const TetTopology r = multimesh::topology_of(domain.tagged());
  std::vector<long> list{static_cast<long>(r.components), r.handles, r.cavities,
                         r.boundary_euler_characteristic};
  for (const auto& node : {domain.surface(), domain.curves()}) {
    if (!node) continue;
    const Topology t = topology(domain.tree().mesh(*node));
    list.insert(list.end(), {t.euler, t.components, t.boundary});
  }
  return list;
}

}  // namespace

Box make_box(const BoxOptions& options) {
  return std::move(BoxMaker(options).box_);
}

Kept::Kept(const TetDomain& domain) : topology_(topology_of(domain)) {
  const Measures m(domain.tagged());
  volumes_ = m.volumes;
  areas_ = m.areas;
  lengths_ = m.lengths;
}

std::string Kept::fault(const TetDomain& after) const {
  std::string fault;
  for (const std::string& p : validate(after.tree())) fault += p + "; ";
  const Measures m(after.tagged());
  fault += compare(volumes_, m.volumes, 1e-12, "volume");
  fault += compare(areas_, m.areas, 1e-12, "area");
  fault += compare(lengths_, m.lengths, 1e-12, "length");
  if (topology_of(after) != topology_) fault += "topology changed; ";
  if (!all_positive(after)) fault += "a tetrahedron is inverted; ";
  return fault;
}

bool all_positive(const TetDomain& domain) {
  const tet::TetMesh& mesh = domain.mesh();
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    const Index* v = mesh.corners(t);
    const auto p = [&](int i) { return domain.points()[v[i]].data(); };
    if (orient3d(p(0), p(1), p(2), p(3)) <= 0) return false;
  }
  return true;
}

double max_amips(const TetDomain& domain) {
  const tet::TetMesh& mesh = domain.mesh();
  double worst = 0;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    const Index* v = mesh.corners(t);
    const auto& p = domain.points();
    worst = std::max(worst, improvement::amips(p[v[0]], p[v[1]], p[v[2]], p[v[3]]));
  }
  return worst;
}

}  // namespace multimesh::test
