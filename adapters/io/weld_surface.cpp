// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/weld_surface.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "adapters/io/repeated_faces.hpp"
#include "adapters/io/soup_check.hpp"
#include "adapters/io/weld.hpp"
#include "adapters/io/weld_texcoords.hpp"

namespace multimesh::io {
namespace {

using Corner = PolygonSoup::Corner;

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

/// The values at the corners of each vertex: an index into texture coordinates or normals, none, or several
/// that differ in value.
template <std::size_t N>
class CornerValues {
 public:
  static constexpr std::int32_t unused = -3, several = -2, none = -1;

  CornerValues(const PolygonSoup& soup, const std::vector<std::array<double, N>>& values,
               std::int32_t Corner::*index)
      : values_(values), of_(soup.positions.size(), unused) {
    for (const Corner& c : soup.corners) {
      std::int32_t& of = of_[at(c.v)];
      if (of == unused)
        of = c.*index;
      else if (of != several && !equal(of, c.*index))
        of = several;
    }
  }

  bool are_single() const { return std::ranges::find(of_, several) == of_.end(); }
  bool agree(std::size_t v, std::size_t w) const { return of_[v] != several && equal(of_[v], of_[w]); }
  bool is_used(std::size_t v) const { return of_[v] != unused; }

  bool equal(std::int32_t i, std::int32_t j) const {
    return i == j || (i >= 0 && j >= 0 && values_[at(i)] == values_[at(j)]);
  }

 private:
  const std::vector<std::array<double, N>>& values_;
  std::vector<std::int32_t> of_;
};

class SurfaceWeld {
 public:
  /// `place`: see coincident_points()
  SurfaceWeld(PolygonSoup& soup, std::vector<std::uint32_t> place)
      : soup_(soup),
        texcoords_(soup, soup.texcoords, &Corner::vt),
        normals_(soup, soup.normals, &Corner::vn),
        place_(std::move(place)),
        layer_(soup.positions.size(), 0) {}

  SurfaceWeldReport run() {
    find_shared();
    if (report_.coincident == 0) return report_;
    separate_layers();
    remove_faces(soup_, copies_);
    report_.copied_faces = copies_.size();
    report_.texcoords_by_vertex = are_by_vertex(&Corner::vt);
    report_.normals_by_vertex = are_by_vertex(&Corner::vn);
    join(targets(open_vertices()));
    if (report_.welded == 0) return report_;
    report_.split_by_texcoord = !soup_.texcoords.empty() && texcoords_.are_single();
    report_.split_by_normal = !soup_.normals.empty() && normals_.are_single();
    return report_;
  }

 private:
  bool are_by_vertex(std::int32_t Corner::*index) const {
    return std::ranges::all_of(soup_.corners, [&](const Corner& c) { return c.*index == c.v; });
  }

  void find_shared() {
    std::vector<std::uint32_t> used(place_.size(), 0);
    for (std::size_t v = 0; v < place_.size(); ++v)
      if (texcoords_.is_used(v) && used[place_[v]]++ != 0) ++report_.coincident;
    shared_.resize(place_.size());
    for (std::size_t v = 0; v < place_.size(); ++v) shared_[v] = used[place_[v]] > 1;
  }

  // Faces at the same places are either copies, or sides of a sheet, which get their own vertices: those of
  // the second side are in layer 1, and so on. Vertices of different layers are not joined.
  void separate_layers() {
    constexpr std::uint8_t last = 7;
    for (std::uint8_t layer = 0; layer < last; ++layer) {
      copies_.clear();
      bool is_done = true;
      for (const auto& [face, earlier] : faces_at_same_places()) {
        if (have_same_vertices(face, earlier)) continue;  // kept by clean_faces; welding changes nothing
        if (is_copy(face, earlier)) {
          copies_.push_back(face);
          continue;
        }
        is_done = false;
        for (const Corner& c : soup_.face(face)) layer_[at(c.v)] = static_cast<std::uint8_t>(layer + 1);
      }
      if (is_done) return;
    }
    // With more sides than that, all of them are left as they are.
    for (std::size_t v = 0; v < layer_.size(); ++v) shared_[v] = shared_[v] && layer_[v] == 0;
  }

  bool have_same_vertices(std::uint32_t f, std::uint32_t g) const {
    return std::ranges::all_of(soup_.face(f), [&](const Corner& c) {
      return std::ranges::find(soup_.face(g), c.v, &Corner::v) != soup_.face(g).end();
    });
  }

  std::vector<RepeatedFace> faces_at_same_places() const {
    std::vector<bool> all(place_.size(), true);
    const std::vector<std::int32_t> to = targets(all);
    PolygonSoup by_place;
    by_place.positions.resize(soup_.positions.size());
    by_place.face_begin = soup_.face_begin;
    by_place.corners = soup_.corners;
    for (Corner& c : by_place.corners) c.v = to[at(c.v)];
    return repeated_faces(by_place);
  }

  /// The same face in the same section, with equal corners, at most rotated in its own plane.
  bool is_copy(std::uint32_t f, std::uint32_t g) const {
    const auto a = soup_.face(f), b = soup_.face(g);
    if (soup_.sections[soup_.face_section[f]] != soup_.sections[soup_.face_section[g]]) return false;
    for (std::size_t turn = 0; turn < a.size(); ++turn) {
      std::size_t i = 0;
      while (i < a.size() && looks_like(a[i], b[(i + turn) % a.size()])) ++i;
      if (i == a.size()) return true;
    }
    return false;
  }
  bool looks_like(const Corner& c, const Corner& d) const {
    return place_[at(c.v)] == place_[at(d.v)] && texcoords_.equal(c.vt, d.vt) && normals_.equal(c.vn, d.vn) &&
           (soup_.colors.empty() || soup_.colors[at(c.v)] == soup_.colors[at(d.v)]);
  }

  /// Ends of edges with one face. Only edges from vertices that share their place are examined.
  std::vector<bool> open_vertices() const {
    std::vector<std::array<std::int32_t, 2>> edges;
    for (std::size_t f = 0; f < soup_.face_count(); ++f) {
      const auto face = soup_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::int32_t a = face[i].v, b = face[(i + 1) % face.size()].v;
        if (shared_[at(a)] || shared_[at(b)]) edges.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    std::ranges::sort(edges);
    std::vector<bool> open(place_.size(), false);
    for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
      while (j < edges.size() && edges[j] == edges[i]) ++j;
      if (j - i == 1)
        for (const std::int32_t v : edges[i]) open[at(v)] = true;
    }
    return open;
  }

  /// Per vertex the first one with which it is to be joined, among those that may be joined.
  std::vector<std::int32_t> targets(const std::vector<bool>& may) const {
    std::vector<std::tuple<std::uint32_t, std::uint8_t, std::int32_t>> members;  // place, layer, vertex
    std::vector<std::int32_t> to(place_.size());
    for (std::size_t v = 0; v < place_.size(); ++v) {
      to[v] = static_cast<std::int32_t>(v);
      if (shared_[v] && may[v] && texcoords_.is_used(v)) members.emplace_back(place_[v], layer_[v], to[v]);
    }
    std::ranges::sort(members);
    for (std::size_t i = 1; i < members.size(); ++i) {
      const auto& [place, layer, v] = members[i];
      const auto& [place_before, layer_before, before] = members[i - 1];
      if (place == place_before && layer == layer_before) to[at(v)] = to[at(before)];
    }
    return to;
  }

  void join(const std::vector<std::int32_t>& to) {
    blend_colors(to);
    for (std::size_t v = 0; v < to.size(); ++v) {
      if (at(to[v]) == v) continue;
      ++report_.welded;
      const bool same_color = soup_.colors.empty() || soup_.colors[v] == soup_.colors[at(to[v])];
      report_.redundant += texcoords_.agree(v, at(to[v])) && normals_.agree(v, at(to[v])) && same_color;
    }
    for (Corner& c : soup_.corners) c.v = to[at(c.v)];
    for (std::int32_t& v : soup_.line_corners) v = to[at(v)];
  }

  void blend_colors(const std::vector<std::int32_t>& to) {
    if (soup_.colors.empty()) return;
    std::vector<std::uint32_t> count(to.size(), 1);
    std::vector<std::array<double, 3>> sum = soup_.colors;
    for (std::size_t v = 0; v < to.size(); ++v) {
      const std::size_t first = at(to[v]);
      if (first == v) continue;
      report_.blended_colors += soup_.colors[v] != soup_.colors[first];
      ++count[first];
      for (std::size_t k = 0; k < 3; ++k) sum[first][k] += soup_.colors[v][k];
    }
    if (report_.blended_colors == 0) return;
    for (std::size_t v = 0; v < to.size(); ++v)
      for (std::size_t k = 0; k < 3 && count[v] > 1; ++k) soup_.colors[v][k] = sum[v][k] / count[v];
  }

  PolygonSoup& soup_;
  CornerValues<2> texcoords_;
  CornerValues<3> normals_;
  std::vector<std::uint32_t> place_;  ///< per vertex the first one there
  std::vector<std::uint8_t> layer_;
  std::vector<bool> shared_;           ///< per vertex whether others are at its place
  std::vector<std::uint32_t> copies_;  ///< faces, ascending
  SurfaceWeldReport report_;
};

bool any_coincident(const std::vector<std::uint32_t>& place) {
  for (std::size_t v = 0; v < place.size(); ++v)
    if (place[v] != v) return true;
  return false;
}

}  // namespace

SurfaceWeldReport weld_surface(PolygonSoup& soup, const SurfaceWeldOptions& options, std::string_view file) {
  SurfaceWeldReport report;
  if (options.positions) {
    std::vector<std::uint32_t> place = coincident_points(soup.positions, options.tolerance);
    if (any_coincident(place)) report = SurfaceWeld(soup, std::move(place)).run();
  }
  if (report.welded != 0) remove_collapsed_faces(soup, file);
  weld_texcoords(soup, options.texcoord_tolerance, report);
  return report;
}

}  // namespace multimesh::io
