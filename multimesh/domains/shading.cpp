// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace multimesh {

namespace {

constexpr double smallest_difference = 0.5 * std::numbers::pi / 180;

class ShadingReader {
 public:
  ShadingReader(const TexturedTriangles& surface, std::span<const Vec3> normals,
                std::span<const std::array<std::int32_t, 3>> corners)
      : surface_(surface), normals_(normals), corners_(corners), bits_(surface.triangles.size(), 0) {}

  std::vector<std::uint8_t> run() {
    for (std::size_t t = 0; t < bits_.size(); ++t)
      bits_[t] =
          static_cast<std::uint8_t>((points_back(t) ? normals_behind : 0) | (flat(t) ? flat_shaded : 0));
    find_hard_edges();
    return std::move(bits_);
  }

 private:
  /// The edge from a corner of a triangle to the next.
  struct Side {
    std::uint64_t key;
    Index triangle;
    std::uint8_t corner;
    friend auto operator<=>(const Side&, const Side&) = default;
  };

  std::size_t position(std::size_t t, std::size_t i) const {
    return static_cast<std::size_t>(surface_.triangles[t][i % 3].position);
  }
  Vec3 normal(std::size_t t, std::size_t i) const {
    const std::int32_t n = corners_[t][i % 3];
    return n < 0 ? Vec3(0, 0, 0) : normals_[static_cast<std::size_t>(n)];
  }

  bool flat(std::size_t t) const {
    const Vec3 n = normal(t, 0);
    return n.squared_norm() > 0 && !differ(n, normal(t, 1)) && !differ(n, normal(t, 2));
  }

  bool points_back(std::size_t t) const {
    const Vec3& p = surface_.positions[position(t, 0)];
    const Vec3 front = cross(surface_.positions[position(t, 1)] - p, surface_.positions[position(t, 2)] - p);
    return dot(front, normal(t, 0) + normal(t, 1) + normal(t, 2)) < 0;
  }

  /// Positions whose corners do not all name the same normal: only there can an edge be hard.
  std::vector<bool> with_several_normals() const {
    constexpr std::int32_t unseen = -2;
    std::vector<std::int32_t> seen(surface_.positions.size(), unseen);
    std::vector<bool> several(surface_.positions.size(), false);
    for (std::size_t t = 0; t < bits_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        std::int32_t& first = seen[position(t, i)];
        if (first == unseen) first = corners_[t][i];
        if (first != corners_[t][i]) several[position(t, i)] = true;
      }
    return several;
  }

  void find_hard_edges() {
    const std::vector<bool> several = with_several_normals();
    std::vector<Side> sides;
    for (std::size_t t = 0; t < bits_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = position(t, i), b = position(t, i + 1);
        if (several[a] || several[b])
          sides.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), static_cast<Index>(t),
                           static_cast<std::uint8_t>(i)});
      }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0, j; i < sides.size(); i = j) {
      for (j = i; j < sides.size() && sides[j].key == sides[i].key;) ++j;
      if (j - i != 2 || !differ(sides[i], sides[i + 1])) continue;
      for (const Side& s : {sides[i], sides[i + 1]})
        bits_[s.triangle] = static_cast<std::uint8_t>(bits_[s.triangle] | 1U << s.corner);
    }
  }

  bool differ(const Side& s, const Side& t) const {
    const bool same_direction = position(s.triangle, s.corner) == position(t.triangle, t.corner);
    const std::size_t at_start = t.corner + (same_direction ? 0U : 1U);
    const std::size_t at_end = t.corner + (same_direction ? 1U : 0U);
    return differ(normal(s.triangle, s.corner), normal(t.triangle, at_start)) ||
           differ(normal(s.triangle, s.corner + 1U), normal(t.triangle, at_end));
  }
  static bool differ(const Vec3& m, const Vec3& n) {
    return m != n && std::atan2(cross(m, n).norm(), dot(m, n)) > smallest_difference;
  }

  const TexturedTriangles& surface_;
  std::span<const Vec3> normals_;
  std::span<const std::array<std::int32_t, 3>> corners_;
  std::vector<std::uint8_t> bits_;
};

}  // namespace

std::vector<std::uint8_t> shading(const TexturedTriangles& surface, std::span<const Vec3> normals,
                                  std::span<const std::array<std::int32_t, 3>> corners) {
  return ShadingReader(surface, normals, corners).run();
}

}  // namespace multimesh
