// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/domains/textured_surface/data.hpp"

namespace multimesh {

TexturedSurface::TexturedSurface(const TexturedTriangles& input, const TexturedSurfaceOptions& options)
    : data_(std::make_unique<Data>()) {
  check(input);
  if (input.uv_sets() > max_uv_sets)
    throw InputError(std::to_string(input.uv_sets()) + " sets of texture coordinates; at most " +
                     std::to_string(max_uv_sets) + " can be kept");
  {
    const Cut cut = add_surface(input, *data_);
    for (std::size_t set = 0; set < input.uv_sets(); ++set) add_texture(input, cut, set, *data_);
  }
  add_curves(input, options, *data_);
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
  return data_->textures.empty() ? std::optional<NodeId>() : data_->textures.front();
}
std::span<const NodeId> TexturedSurface::textures() const {
  return data_->textures;
}
std::optional<NodeId> TexturedSurface::seams() const {
  return data_->curves;
}
std::vector<Vec3>& TexturedSurface::positions() {
  return *data_->positions;
}
const std::vector<Vec3>& TexturedSurface::positions() const {
  return *data_->positions;
}
std::vector<Vec2>& TexturedSurface::texcoords(std::size_t set) {
  return set < data_->texcoords.size() ? *data_->texcoords[set] : data_->no_texcoords;
}
const std::vector<Vec2>& TexturedSurface::texcoords(std::size_t set) const {
  return set < data_->texcoords.size() ? *data_->texcoords[set] : data_->no_texcoords;
}
std::vector<Vec3>& TexturedSurface::colors() {
  return data_->colors ? *data_->colors : data_->no_colors;
}
const std::vector<Vec3>& TexturedSurface::colors() const {
  return data_->colors ? *data_->colors : data_->no_colors;
}
const std::vector<Index>& TexturedSurface::source_positions() const {
  return *data_->source_position;
}
const CutReport& TexturedSurface::cut_report() const {
  return data_->report;
}

CurveKinds TexturedSurface::curve_kinds(Dart root_edge) const {
  if (!data_->curves) return no_curve;
  const Index c = tree().facet_over(*data_->curves, root_edge);
  return c == no_index ? CurveKinds{no_curve} : (*data_->curve_kinds)[c];
}

CurveKinds TexturedSurface::curve_kinds_of(Index curve_edge) const {
  return (*data_->curve_kinds)[curve_edge];
}

bool TexturedSurface::is_copy(Index vertex) const {
  return (*data_->is_copy)[vertex] != 0;
}

void TexturedSurface::set_locked(Index vertex, bool on) {
  data_->tree->mesh(NodeId::root).set_locked(vertex, on || is_copy(vertex));
}

bool TexturedSurface::has_normals() const {
  return data_->hard != nullptr;
}
bool TexturedSurface::hard(Index edge) const {
  return data_->hard && (*data_->hard)[edge] != 0;
}
void TexturedSurface::set_hard(Index edge, bool on) {
  (*data_->hard)[edge] = on;
}
unsigned TexturedSurface::triangle_shading(Index triangle) const {
  return data_->triangle_shading ? static_cast<unsigned char>((*data_->triangle_shading)[triangle]) : 0U;
}
bool TexturedSurface::is_reversed(Index triangle) const {
  return (*data_->reversed)[triangle] != 0;
}

std::size_t TexturedSurface::live_triangles() const {
  const Mesh& root = tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index f = 0; f < root.capacity(2); ++f) n += root.is_live(2, f);
  return n;
}

}  // namespace multimesh
