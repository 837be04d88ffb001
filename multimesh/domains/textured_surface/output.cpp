// SPDX-License-Identifier: BSD-3-Clause
// Triangles by corners, from a textured surface.
#include <algorithm>
#include <bit>
#include <unordered_map>

#include "multimesh/domains/textured_surface/data.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

constexpr std::int32_t unnumbered = -1;

/// Numbers the vertices of the surface in order of appearance; copies of one input position at one point are
/// one.
class PositionNumbers {
 public:
  PositionNumbers(const TexturedSurface& surface, TexturedTriangles& out)
      : surface_(surface), out_(out), number_(surface.tree().mesh(NodeId::root).capacity(0), unnumbered) {}

  std::int32_t operator()(Index v) {
    if (number_[v] == unnumbered) number_[v] = surface_.is_copy(v) ? number_of_copy(v) : append(v);
    return number_[v];
  }

 private:
  std::int32_t append(Index v) {
    out_.positions.push_back(surface_.positions()[v]);
    if (!surface_.colors().empty()) out_.colors.push_back(surface_.colors()[v]);
    return static_cast<std::int32_t>(out_.positions.size() - 1);
  }
  std::int32_t number_of_copy(Index v) {
    const Vec3& p = surface_.positions()[v];
    const std::array<std::uint64_t, 4> key{surface_.source_positions()[v], std::bit_cast<std::uint64_t>(p[0]),
                                           std::bit_cast<std::uint64_t>(p[1]),
                                           std::bit_cast<std::uint64_t>(p[2])};
    const auto found = copies_.find(key);
    return found != copies_.end() ? found->second : copies_[key] = append(v);
  }

  const TexturedSurface& surface_;
  TexturedTriangles& out_;
  std::vector<std::int32_t> number_;
  std::unordered_map<std::array<std::uint64_t, 4>, std::int32_t, ArrayHash> copies_;
};

/// Numbers the texture coordinates of one set in order of appearance; equal values are one.
class TexcoordNumbers {
 public:
  TexcoordNumbers(const TexturedSurface& surface, std::size_t set, std::vector<Vec2>& out)
      : tree_(surface.tree()),
        node_(surface.textures()[set]),
        values_(surface.texcoords(set)),
        out_(out),
        number_(tree_.mesh(node_).capacity(0), unnumbered) {}

  /// For the three vertices of the root dart d, in its order; -1 if the triangle is not in the texture.
  std::array<std::int32_t, 3> operator()(Dart d) {
    copy_.clear();
    tree_.to_child(node_, d, 2, copy_);
    if (copy_.empty()) return {-1, -1, -1};
    std::array<Index, 4> v{};
    tree_.mesh(node_).vertices(copy_[0], v.data());
    return {number(v[0]), number(v[1]), number(v[2])};
  }

 private:
  std::int32_t number(Index v) {
    if (number_[v] != unnumbered) return number_[v];
    const Vec2& p = values_[v];
    const std::array<std::uint64_t, 2> key{std::bit_cast<std::uint64_t>(p[0] + 0.0),
                                           std::bit_cast<std::uint64_t>(p[1] + 0.0)};
    const auto [it, is_new] = by_value_.try_emplace(key, static_cast<std::int32_t>(out_.size()));
    if (is_new) out_.push_back(p + Vec2(0, 0));  // no -0
    return number_[v] = it->second;
  }

  const MultiMesh& tree_;
  NodeId node_;
  const std::vector<Vec2>& values_;
  std::vector<Vec2>& out_;
  std::vector<std::int32_t> number_;
  std::unordered_map<std::array<std::uint64_t, 2>, std::int32_t, ArrayHash> by_value_;
  DartBuffer copy_;
};

/// As in shading.hpp. The corners are those of d, in its order.
std::uint8_t shading_of(const TexturedSurface& surface, const Mesh& root, Dart d) {
  const Dart from_second = root.switch_dart(root.switch_dart(d, 0), 1);
  const std::array edges{d, from_second, root.switch_dart(d, 1)};
  unsigned bits = surface.triangle_shading(root.facet(d));
  for (unsigned i = 0; i < 3; ++i) bits |= surface.hard(root.simplex(edges[i], 1)) ? 1U << i : 0U;
  return static_cast<std::uint8_t>(bits);
}

}  // namespace

TexturedTriangles TexturedSurface::triangles(std::vector<Index>& source) const {
  const Mesh& root = tree().mesh(NodeId::root);
  TexturedTriangles out;
  source.clear();
  out.more_uv_sets.resize(textures().empty() ? 0 : textures().size() - 1);
  PositionNumbers position(*this, out);
  std::vector<TexcoordNumbers> texcoord;
  for (std::size_t set = 0; set < textures().size(); ++set)
    texcoord.emplace_back(*this, set, set == 0 ? out.texcoords : out.more_uv_sets[set - 1].texcoords);

  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!root.is_live(2, f)) continue;
    Dart d = root.dart_of(2, f);
    // Turned back: the same triangle from the other end of its first edge.
    if (is_reversed(f)) d = root.switch_dart(d, 0);
    std::array<Index, 4> v{};
    root.vertices(d, v.data());
    auto& corners = out.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) corners[i].position = position(v[i]);
    for (std::size_t set = 0; set < texcoord.size(); ++set) {
      const std::array<std::int32_t, 3> vt = texcoord[set](d);
      if (set > 0) out.more_uv_sets[set - 1].corners.push_back(vt);
      for (std::size_t i = 0; i < 3 && set == 0; ++i) corners[i].texcoord = vt[i];
    }
    if (has_normals()) out.shading.push_back(shading_of(*this, root, d));
    source.push_back((*data_->source_triangle)[f]);
  }
  return out;
}

}  // namespace multimesh
