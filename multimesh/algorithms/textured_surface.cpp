// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/textured_surface.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <string>
#include <unordered_map>

#include "adapters/openmesh/connectivity.hpp"
#include "adapters/openmesh/make_mesh.hpp"
#include "multimesh/build.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;

struct TexturedSurface::Data {
  std::unique_ptr<MultiMesh> tree;
  std::optional<NodeId> texture, seams;
  OpenMesh::VPropHandleT<Vec3d> position_property;
  OpenMesh::VPropHandleT<Vec2d> texcoord_property;
  std::vector<Vec3d>* positions = nullptr;
  std::vector<Vec2d>* texcoords = nullptr;
  std::vector<Index>* source_position = nullptr;  // per root vertex: the input's index
  std::vector<Index>* source_triangle = nullptr;  // per root facet
  std::vector<char>* reversed = nullptr;          // per root facet
  CutReport report;
  std::vector<Vec2d> no_texcoords;
};

namespace {

openmesh::Connectivity& connectivity(MultiMesh& tree, NodeId n) {
  return dynamic_cast<openmesh::Connectivity&>(tree.mesh(n));
}

template <class Handle>
auto* add_property(openmesh::Connectivity& mesh, Handle handle, const char* name) {
  mesh.openmesh().add_property(handle, name);
  return &mesh.openmesh().property(handle).data_vector();
}

/// Per texture coordinate, the first one with the same value: -0 and 0 are equal.
std::vector<Index> first_of_equal(const std::vector<Vec2d>& values) {
  std::unordered_map<std::array<std::uint64_t, 2>, Index, ArrayHash> first;
  first.reserve(values.size());
  std::vector<Index> result(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    const std::array<std::uint64_t, 2> key{std::bit_cast<std::uint64_t>(values[i][0] + 0.0),
                                           std::bit_cast<std::uint64_t>(values[i][1] + 0.0)};
    result[i] = first.try_emplace(key, i).first->second;
  }
  return result;
}

void check_corners(const TexturedTriangles& input, std::size_t t) {
  int without = 0;
  for (const auto& c : input.triangles[t]) {
    if (c.position < 0 || static_cast<std::size_t>(c.position) >= input.positions.size())
      throw InputError("triangle " + std::to_string(t) + ": no position " + std::to_string(c.position));
    if (c.texcoord >= 0 && static_cast<std::size_t>(c.texcoord) >= input.texcoords.size())
      throw InputError("triangle " + std::to_string(t) + ": no texture coordinate " +
                       std::to_string(c.texcoord));
    without += c.texcoord < 0;
  }
  if (without != 0 && without != 3)
    throw InputError("triangle " + std::to_string(t) +
                     " has texture coordinates on some corners only; give all three or none");
}

/// Builds the tree, mesh by mesh.
class Builder {
 public:
  Builder(const TexturedTriangles& input, TexturedSurface::Data& out) : input_(input), out_(out) {}

  void run();

 private:
  void add_surface();
  void lock_copies();
  void add_texture();
  void add_seams();
  int curve_kind(Index edge) const;

  const TexturedTriangles& input_;
  TexturedSurface::Data& out_;
  Cut cut_;
};

void Builder::run() {
  if (!input_.labels.empty() && input_.labels.size() != input_.triangles.size())
    throw InputError(std::to_string(input_.labels.size()) + " labels for " +
                     std::to_string(input_.triangles.size()) + " triangles; give one each, or none");
  for (std::size_t t = 0; t < input_.triangles.size(); ++t) check_corners(input_, t);
  add_surface();
  lock_copies();
  add_texture();
  add_seams();
}

void Builder::add_surface() {
  FacetList facets{2, static_cast<Index>(input_.positions.size()), {}};
  facets.corners.reserve(3 * input_.triangles.size());
  for (const auto& t : input_.triangles)
    for (const auto& c : t) facets.corners.push_back(static_cast<Index>(c.position));
  cut_ = cut(facets);
  out_.tree = std::make_unique<MultiMesh>(openmesh::make_mesh(cut_.facets));
  auto& mesh = connectivity(*out_.tree, NodeId::root);
  mesh.openmesh().add_property(out_.position_property, "position");
  out_.positions = &mesh.openmesh().property(out_.position_property).data_vector();
  out_.source_position = add_property(mesh, OpenMesh::VPropHandleT<Index>(), "source position");
  out_.source_triangle = add_property(mesh, OpenMesh::FPropHandleT<Index>(), "source triangle");
  out_.reversed = add_property(mesh, OpenMesh::FPropHandleT<char>(), "reversed");
  for (Index v = 0; v < cut_.source.size(); ++v) {
    (*out_.positions)[v] = input_.positions[cut_.source[v]];
    (*out_.source_position)[v] = cut_.source[v];
  }
  for (Index f = 0; f < input_.triangles.size(); ++f) {
    (*out_.source_triangle)[f] = f;
    (*out_.reversed)[f] = cut_.reversed[f];
    out_.report.reversed_triangles += cut_.reversed[f];
  }
}

void Builder::lock_copies() {
  std::vector<Index> copies(input_.positions.size(), 0);
  for (const Index v : cut_.source) ++copies[v];
  auto& om = connectivity(*out_.tree, NodeId::root).openmesh();
  for (Index v = 0; v < cut_.source.size(); ++v)
    if (copies[cut_.source[v]] > 1) om.status(OpenMesh::VertexHandle(static_cast<int>(v))).set_locked(true);
  for (const Index n : copies) out_.report.copied_vertices += n > 1 ? n - 1 : 0;
}

// The vertices of the texture: classes of corners with the same vertex of the surface and equal texture
// coordinates, cut to be manifold (charts that touch in a point come apart).
void Builder::add_texture() {
  const std::vector<Index> texcoord = first_of_equal(input_.texcoords);
  std::unordered_map<std::array<std::uint64_t, 2>, Index, ArrayHash> number;
  FacetList pairs{2, 0, {}}, over{2, cut_.facets.vertices, {}};
  std::vector<Index> parent_facets, texcoord_of;
  for (Index f = 0; f < input_.triangles.size(); ++f) {
    if (input_.triangles[f][0].texcoord < 0) {
      ++out_.report.triangles_without_texcoords;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t given = cut_.reversed[f] && i < 2 ? 1 - i : i;
      const Index vt = texcoord[static_cast<std::size_t>(input_.triangles[f][given].texcoord)];
      const Index v = cut_.facets.facet(f)[i];
      const auto [it, is_new] = number.try_emplace({v, vt}, pairs.vertices);
      if (is_new) {
        ++pairs.vertices;
        texcoord_of.push_back(vt);
      }
      pairs.corners.push_back(it->second);
      over.corners.push_back(v);
    }
    parent_facets.push_back(f);
  }
  if (parent_facets.empty()) return;
  const Cut texture = cut(pairs);
  for (std::size_t f = 0; f < parent_facets.size(); ++f)
    if (texture.reversed[f]) std::swap(over.corners[3 * f], over.corners[3 * f + 1]);
  out_.texture =
      add_child_by_facets(*out_.tree, NodeId::root, texture.facets, over, parent_facets, openmesh::make_mesh);
  auto& mesh = connectivity(*out_.tree, *out_.texture);
  mesh.openmesh().add_property(out_.texcoord_property, "texcoord");
  out_.texcoords = &mesh.openmesh().property(out_.texcoord_property).data_vector();
  for (Index v = 0; v < texture.source.size(); ++v)
    (*out_.texcoords)[v] = input_.texcoords[texcoord_of[texture.source[v]]];
}

// What runs along an edge: nothing (0), a seam between two charts or two places of one (1), the border of the
// texture (2); the border of triangles that were turned round (4), and that between labels (8).
int Builder::curve_kind(Index edge) const {
  const Mesh& root = out_.tree->mesh(NodeId::root);
  const Dart e = root.dart_of(1, edge);
  if (root.is_boundary(e, 1)) return 0;
  const Index f = root.facet(e), g = root.facet(root.switch_dart(e, 2));
  const bool labels_differ = !input_.labels.empty() && input_.labels[f] != input_.labels[g];
  const int borders = ((*out_.reversed)[f] != (*out_.reversed)[g] ? 4 : 0) | (labels_differ ? 8 : 0);
  if (!out_.texture) return borders;
  DartBuffer copies;
  out_.tree->to_child(*out_.texture, e, 1, copies);
  if (copies.size() == 2) return 1 | borders;
  return (copies.size() == 1 && out_.tree->mesh(*out_.texture).is_boundary(copies[0], 1) ? 2 : 0) | borders;
}

void Builder::add_seams() {
  const Mesh& root = out_.tree->mesh(NodeId::root);
  std::vector<int> kind(root.capacity(1));
  struct AtVertex {
    int degree = 0, kind = 0;
    bool same_kind = true;
  };
  std::vector<AtVertex> at(root.capacity(0));
  for (Index e = 0; e < root.capacity(1); ++e) {
    kind[e] = curve_kind(e);
    if (kind[e] == 0) continue;
    const Dart d = root.dart_of(1, e);
    for (const Dart end : {d, root.switch_dart(d, 0)}) {
      AtVertex& v = at[root.vertex(end)];
      v.same_kind &= v.degree++ == 0 || v.kind == kind[e];
      v.kind = kind[e];
    }
  }
  if (std::all_of(kind.begin(), kind.end(), [](int k) { return k == 0; })) return;
  // A curve goes on through a vertex only if nothing but that one curve passes there.
  const auto ends_at = [&](Index v) {
    if (at[v].degree != 2 || !at[v].same_kind) return true;
    const Dart d = root.dart_of(0, v);
    if (root.is_boundary(d, 0)) return true;
    if (!out_.texture) return false;
    DartBuffer copies;
    out_.tree->to_child(*out_.texture, d, 0, copies);
    return copies.size() > (at[v].kind & 1 ? 2U : 1U);
  };
  out_.seams = add_child_from_tags(*out_.tree, NodeId::root, 1, [&](Index e) { return kind[e] != 0; },
                                   openmesh::make_mesh, {ends_at});
}

}  // namespace

TexturedSurface::TexturedSurface(const TexturedTriangles& input) : data_(std::make_unique<Data>()) {
  if (input.triangles.empty()) throw InputError("the surface has no triangles");
  Builder(input, *data_).run();
}

TexturedSurface::~TexturedSurface() = default;
TexturedSurface::TexturedSurface(TexturedSurface&&) noexcept = default;

MultiMesh& TexturedSurface::tree() {
  return *data_->tree;
}
const MultiMesh& TexturedSurface::tree() const {
  return *data_->tree;
}
std::optional<NodeId> TexturedSurface::texture() const {
  return data_->texture;
}
std::optional<NodeId> TexturedSurface::seams() const {
  return data_->seams;
}
std::vector<Vec3d>& TexturedSurface::positions() {
  return *data_->positions;
}
const std::vector<Vec3d>& TexturedSurface::positions() const {
  return *data_->positions;
}
std::vector<Vec2d>& TexturedSurface::texcoords() {
  return data_->texcoords ? *data_->texcoords : data_->no_texcoords;
}
const std::vector<Vec2d>& TexturedSurface::texcoords() const {
  return data_->texcoords ? *data_->texcoords : data_->no_texcoords;
}
const std::vector<Index>& TexturedSurface::source_positions() const {
  return *data_->source_position;
}
const CutReport& TexturedSurface::cut_report() const {
  return data_->report;
}

std::size_t TexturedSurface::live_triangles() const {
  const Mesh& root = tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index f = 0; f < root.capacity(2); ++f) n += root.is_live(2, f);
  return n;
}

TexturedTriangles TexturedSurface::triangles(std::vector<Index>& source) const {
  const MultiMesh& tree = *data_->tree;
  const Mesh& root = tree.mesh(NodeId::root);
  TexturedTriangles out;
  source.clear();
  std::unordered_map<std::array<std::uint64_t, 4>, std::int32_t, ArrayHash> joined;
  std::unordered_map<std::array<std::uint64_t, 2>, std::int32_t, ArrayHash> texcoord_number;
  std::vector<std::int32_t> position_number(root.capacity(0), -1);
  const auto position = [&](Index v) {
    std::int32_t& number = position_number[v];
    if (number >= 0) return number;
    const Vec3d& p = positions()[v];
    const std::array<std::uint64_t, 4> key{(*data_->source_position)[v], std::bit_cast<std::uint64_t>(p[0]),
                                           std::bit_cast<std::uint64_t>(p[1]),
                                           std::bit_cast<std::uint64_t>(p[2])};
    const auto [it, is_new] = joined.try_emplace(key, static_cast<std::int32_t>(out.positions.size()));
    if (is_new) out.positions.push_back(p);
    return number = it->second;
  };
  const auto texcoord = [&](const Vec2d& p) {
    const std::array<std::uint64_t, 2> key{std::bit_cast<std::uint64_t>(p[0] + 0.0),
                                           std::bit_cast<std::uint64_t>(p[1] + 0.0)};
    const auto [it, is_new] =
        texcoord_number.try_emplace(key, static_cast<std::int32_t>(out.texcoords.size()));
    if (is_new) out.texcoords.push_back(p);
    return it->second;
  };

  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!root.is_live(2, f)) continue;
    const Dart d = root.dart_of(2, f);
    std::array<Index, 4> v{}, u{};
    root.vertices(d, v.data());
    const bool textured = data_->texture && tree.has_preimage(NodeId::root, d, 2, *data_->texture);
    if (textured) {
      DartBuffer copy;
      tree.to_child(*data_->texture, d, 2, copy);
      tree.mesh(*data_->texture).vertices(copy[0], u.data());
    }
    std::array<TexturedTriangles::Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = {position(v[i]), textured ? texcoord(texcoords()[u[i]]) : -1};
    if ((*data_->reversed)[f]) std::swap(corners[0], corners[1]);
    out.triangles.push_back(corners);
    source.push_back((*data_->source_triangle)[f]);
  }
  return out;
}

}  // namespace multimesh
