// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/periodic_links.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>

#include "multimesh/error.hpp"
#include "multimesh/hash.hpp"

namespace multimesh::io {

namespace {

using Vector = std::array<double, 3>;

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double diagonal_of(const std::vector<Vector>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const Vector& p : points)
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  return points.empty() ? 0 : distance(low, high);
}

Vector mean_difference(const SimplexSoup& soup, const SimplexSoup::Periodic& link) {
  Vector sum{};
  for (const auto& [slave, master] : link.points)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += soup.points[slave][i] - soup.points[master][i];
  for (double& x : sum) x /= static_cast<double>(link.points.size());
  return sum;
}

// The numbers of the file if the points confirm them: they have no noise.
Vector translation_of(const SimplexSoup& soup, const SimplexSoup::Periodic& link, double tolerance) {
  const Vector mean = mean_difference(soup, link);
  for (const auto& [slave, master] : link.points) {
    const Vector &s = soup.points[slave], &m = soup.points[master];
    if (!(distance(s, {m[0] + mean[0], m[1] + mean[1], m[2] + mean[2]}) <= tolerance))
      throw InputError("the points of periodic entity " + std::to_string(link.slave) +
                       " are no translated copies of those of entity " + std::to_string(link.master) +
                       " (rotations are not supported); correct $Periodic or remove it");
  }
  if (link.affine.empty()) return mean;
  const Vector given{link.affine[3], link.affine[7], link.affine[11]};
  return distance(given, mean) <= tolerance ? given : mean;
}

}  // namespace

PeriodicPairs periodic_pairs(const SimplexSoup& soup) {
  PeriodicPairs found;
  const double tolerance = 1e-6 * diagonal_of(soup.points);
  for (const SimplexSoup::Periodic& link : soup.periodic) {
    if (link.points.empty()) continue;
    found.translations.push_back(translation_of(soup, link, tolerance));
    found.pairs.insert(found.pairs.end(), link.points.begin(), link.points.end());
  }
  std::ranges::sort(found.pairs);
  found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
  return found;
}

namespace {

/// Adds faces that a block does not list yet.
class FaceList {
 public:
  FaceList(SimplexSoup& soup, int dimension)
      : soup_(soup),
        dimension_(dimension),
        n_(static_cast<std::size_t>(dimension) + 1),
        block_(soup.simplices[n_ - 1]) {
    for (std::size_t i = 0; i < block_.size(); ++i)
      known_.insert(key(std::span(block_.corners).subspan(n_ * i, n_)));
    for (const std::int32_t tag : block_.tags) last_tag_ = std::max(last_tag_, tag);
    for (const SimplexSoup::Group& group : soup.groups)
      if (group.dimension == dimension) last_tag_ = std::max(last_tag_, group.tag);
  }

  void add(std::span<const std::uint32_t> corners, const std::string& name) {
    bool is_new_group = true;
    for (std::size_t i = 0; i + n_ <= corners.size(); i += n_) {
      const auto face = corners.subspan(i, n_);
      if (!known_.insert(key(face)).second) continue;
      if (std::exchange(is_new_group, false)) soup_.groups.push_back({dimension_, ++last_tag_, name});
      block_.corners.insert(block_.corners.end(), face.begin(), face.end());
      block_.tags.push_back(last_tag_);
      if (!block_.flags.empty()) block_.flags.push_back(0);
    }
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  static Key key(std::span<const std::uint32_t> corners) {
    Key k{};  // one more than the index; 0: no corner
    for (std::size_t i = 0; i < corners.size(); ++i) k[i] = std::uint64_t{corners[i]} + 1;
    std::ranges::sort(k);
    return k;
  }

  SimplexSoup& soup_;
  int dimension_;
  std::size_t n_;
  SimplexSoup::Block& block_;
  std::unordered_set<Key, ArrayHash> known_;
  std::int32_t last_tag_ = 0;
};

std::int32_t last_entity(const SimplexSoup& soup, int dimension) {
  std::int32_t last = 0;
  for (const std::int32_t tag : soup.simplices[static_cast<std::size_t>(dimension)].tags)
    last = std::max(last, tag);
  for (const SimplexSoup::Periodic& link : soup.periodic)
    if (link.dimension == dimension) last = std::max({last, link.slave, link.master});
  return last;
}

}  // namespace

void add_periodic_faces(SimplexSoup& soup, int dimension, const std::vector<PeriodicFaces>& sides) {
  FaceList faces(soup, dimension);
  for (const PeriodicFaces& side : sides) {
    faces.add(side.master, "periodic " + side.name);
    faces.add(side.slave, "periodic " + side.name + " copy");
  }
  std::int32_t entity = last_entity(soup, dimension);
  for (const PeriodicFaces& side : sides) {
    SimplexSoup::Periodic link{dimension, entity + 2, entity + 1, {}, {}};
    entity += 2;
    const Vector& t = side.translation;
    link.affine = {1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2], 0, 0, 0, 1};
    for (std::size_t i = 0; i < side.slave.size(); ++i)
      link.points.push_back({side.slave[i], side.master[i]});
    std::ranges::sort(link.points);
    link.points.erase(std::unique(link.points.begin(), link.points.end()), link.points.end());
    soup.periodic.push_back(std::move(link));
  }
}

}  // namespace multimesh::io
