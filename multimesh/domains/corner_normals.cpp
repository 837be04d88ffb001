// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/corner_normals.hpp"

#include <bit>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "multimesh/domains/shading.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

constexpr double most_within_flat = 5 * std::numbers::pi / 180;

/// A rounded unit vector, without -0.
Vec3 tidy(const Vec3& n) {
  const double length = n.norm();
  if (!(length > 0)) return {0, 0, 1};
  const auto rounded = [&](double x) { return std::round(x / length * 1e6) / 1e6 + 0.0; };
  return {rounded(n[0]), rounded(n[1]), rounded(n[2])};
}

/// Numbers normals in order of appearance; equal values are one.
class NormalNumbers {
 public:
  explicit NormalNumbers(std::vector<Vec3>& out) : out_(out) {}
  std::int32_t operator()(const Vec3& n) {
    const std::array<std::uint64_t, 3> key{std::bit_cast<std::uint64_t>(n[0]),
                                           std::bit_cast<std::uint64_t>(n[1]),
                                           std::bit_cast<std::uint64_t>(n[2])};
    const auto [it, is_new] = number_.try_emplace(key, static_cast<std::int32_t>(out_.size()));
    if (is_new) out_.push_back(n);
    return it->second;
  }

 private:
  std::vector<Vec3>& out_;
  std::unordered_map<std::array<std::uint64_t, 3>, std::int32_t, ArrayHash> number_;
};

class NormalComputer {
 public:
  explicit NormalComputer(const TexturedSurface& surface)
      : surface_(surface), root_(surface.tree().mesh(NodeId::root)), fan_of_(root_.capacity(2)) {}

  CornerNormals run() {
    for (Index v = 0; v < root_.capacity(0); ++v) {
      if (!root_.is_live(0, v)) continue;
      if (const Dart d = root_.dart_of(0, v); d != no_dart) add_fans(first_of_a_fan(d));
    }
    return by_corner();
  }

 private:
  // Around v, the face of a dart (v, b, c) comes after the edge vb and before the edge vc.
  bool separates_before(Dart d) const {
    if (surface_.hard(root_.simplex(d, 1))) return true;
    const Dart beside = root_.switch_dart(d, 2);
    if (beside == no_dart || !is_flat(d) || !is_flat(beside)) return false;
    const Vec3 m = weighted_normal(d), n = weighted_normal(beside);
    return std::atan2(cross(m, n).norm(), dot(m, n)) > most_within_flat;
  }
  bool is_flat(Dart d) const { return (surface_.triangle_shading(root_.facet(d)) & flat_shaded) != 0; }
  Dart next(Dart d) const { return root_.switch_dart(root_.switch_dart(d, 1), 2); }
  Dart previous(Dart d) const {
    const Dart e = root_.switch_dart(d, 2);
    return e == no_dart ? no_dart : root_.switch_dart(e, 1);
  }

  /// A dart at the vertex of d with which a fan begins: the one at the boundary if there is one.
  Dart first_of_a_fan(Dart d) const {
    Dart first = d;
    for (Dart p = d;;) {
      if (separates_before(p)) first = p;
      const Dart q = previous(p);
      if (q == no_dart) return p;
      if (root_.facet(q) == root_.facet(d)) return first;
      p = q;
    }
  }

  void add_fans(Dart first) {
    Vec3 sum(0, 0, 0);
    for (Dart d = first;;) {
      fan_of_[root_.facet(d)][corner_of(d)] = static_cast<Index>(fans_.size());
      sum += weighted_normal(d);
      const Dart beside = next(d);
      const bool all_seen = beside == no_dart || root_.facet(beside) == root_.facet(first);
      if (all_seen || separates_before(beside)) {
        fans_.push_back(tidy(sum));
        sum = Vec3(0, 0, 0);
      }
      if (all_seen) return;
      d = beside;
    }
  }

  /// Which of the three corners of its face, in the order of its own dart, the vertex of d is.
  std::size_t corner_of(Dart d) const {
    std::array<Index, 4> v{};
    root_.vertices(root_.dart_of(2, root_.facet(d)), v.data());
    const Index here = root_.vertex(d);
    return v[0] == here ? 0 : v[1] == here ? 1 : 2;
  }

  /// Normal of the face in the orientation of the surface; its length is the angle of the face at the vertex.
  Vec3 weighted_normal(Dart d) const {
    std::array<Index, 4> v{};
    root_.vertices(root_.dart_of(2, root_.facet(d)), v.data());
    const std::size_t i = corner_of(d);
    const Vec3& p = surface_.positions()[v[i]];
    const Vec3 q = surface_.positions()[v[(i + 1) % 3]] - p, r = surface_.positions()[v[(i + 2) % 3]] - p;
    const Vec3 n = cross(q, r);
    const double length = n.norm();
    return length > 0 ? n * (std::atan2(length, dot(q, r)) / length) : Vec3(0, 0, 0);
  }

  CornerNormals by_corner() {
    CornerNormals out;
    NormalNumbers number(out.normals);
    for (Index f = 0; f < root_.capacity(2); ++f) {
      if (!root_.is_live(2, f)) continue;
      const bool reversed = surface_.is_reversed(f);
      const bool opposite = reversed != ((surface_.triangle_shading(f) & normals_behind) != 0);
      auto& corners = out.corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& n = fans_[fan_of_[f][i]];
        corners[i] = number(opposite ? Vec3(0, 0, 0) - n : n);
      }
      if (reversed) std::swap(corners[0], corners[1]);  // as surface.triangles() does
    }
    return out;
  }

  const TexturedSurface& surface_;
  const Mesh& root_;
  std::vector<std::array<Index, 3>> fan_of_;  // by face and corner
  std::vector<Vec3> fans_;                    // one normal each
};

}  // namespace

CornerNormals corner_normals(const TexturedSurface& surface) {
  return NormalComputer(surface).run();
}

}  // namespace multimesh
