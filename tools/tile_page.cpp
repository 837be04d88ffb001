// SPDX-License-Identifier: BSD-3-Clause
#include "tools/tile_page.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <numbers>
#include <utility>

#include "multimesh/geometry/tet_shape.hpp"

namespace multimesh::tools {

namespace {

constexpr std::array<std::array<float, 3>, 6> side_colors = {{{0.86F, 0.45F, 0.35F},
                                                              {0.42F, 0.66F, 0.40F},
                                                              {0.35F, 0.50F, 0.80F},
                                                              {0.85F, 0.70F, 0.30F},
                                                              {0.62F, 0.45F, 0.72F},
                                                              {0.35F, 0.68F, 0.70F}}};
/// Of regions and of the surface: without much colour beside those.
constexpr std::array<std::array<float, 3>, 3> other_colors = {
    {{0.78F, 0.80F, 0.84F}, {0.60F, 0.63F, 0.70F}, {0.90F, 0.89F, 0.84F}}};

/// Faces of a tile and what they are.
class Painter {
 public:
  explicit Painter(const PeriodicDomain& domain)
      : tile_(domain.tile_lists()), sides_(domain.sides()), d_(tile_.facets.dimension) {
    for (const auto& p : tile_.points) page_.surface.positions.push_back({p[0], p[1], p[2]});
    for (const PeriodicSide& side : sides_)
      for (const FacetList* faces : {&side.master, &side.slave})
        for (std::size_t f = 0; f < faces->size(); ++f) side_of_[key(faces->facet(f))] = &side;
  }

  HtmlMesh page() {
    d_ == 2 ? add_triangles() : add_boundary();
    return std::move(page_);
  }

 private:
  using Corners = std::array<Index, 3>;

  static Corners key(std::span<const Index> corners) {
    Corners k{no_index, no_index, no_index};
    std::ranges::copy(corners, k.begin());
    std::ranges::sort(k);
    return k;
  }

  const PeriodicSide* side(std::span<const Index> face) const {
    const auto at = side_of_.find(key(face));
    return at == side_of_.end() ? nullptr : at->second;
  }

  void add(const Corners& v, const std::string& name, bool is_side) {
    auto& triangle = page_.surface.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i].position = static_cast<std::int32_t>(v[i]);
    const auto [at, is_new] = material_.try_emplace(name, static_cast<Index>(page_.materials.size()));
    if (is_new) {
      std::size_t& n = is_side ? n_sides_ : n_others_;
      page_.materials.push_back(
          {name, is_side ? side_colors[n % side_colors.size()] : other_colors[n % other_colors.size()]});
      ++n;
    }
    page_.material.push_back(at->second);
  }
  void add(const Corners& v, const PeriodicSide* side, const std::string& otherwise) {
    add(v, side ? "side " + name_of(side->shift) : otherwise, side != nullptr);
  }

  void add_triangles() {
    for (std::size_t f = 0; f < tile_.facets.size(); ++f) {
      const auto c = tile_.facets.facet(f);
      const PeriodicSide* at = nullptr;
      for (std::size_t i = 0; i < 3 && !at; ++i) at = side(std::array{c[i], c[(i + 1) % 3]});
      const auto region = tile_.regions.empty() ? 0 : tile_.regions[f];
      add({c[0], c[1], c[2]}, at, "region " + std::to_string(region));
    }
  }

  // As seen from outside.
  void add_boundary() {
    constexpr std::size_t opposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    struct Face {
      Corners corners;
      int facets = 0;
      PeriodicTile::Region low = 0, high = 0;
    };
    std::map<Corners, Face> faces;
    for (std::size_t t = 0; t < tile_.facets.size(); ++t) {
      const auto c = tile_.facets.facet(t);
      for (const auto& o : opposite) {
        const Corners corners{c[o[0]], c[o[1]], c[o[2]]};
        const auto region = tile_.regions.empty() ? 0 : tile_.regions[t];
        Face& face = faces[key(corners)];
        if (++face.facets == 1) face.corners = corners, face.low = face.high = region;
        face.low = std::min(face.low, region), face.high = std::max(face.high, region);
      }
    }
    for (const auto& [sorted, face] : faces) {
      if (face.facets == 1) add(face.corners, side(face.corners), "surface");
      if (face.low != face.high) add(face.corners, "interface", false);
    }
  }

  PeriodicTile tile_;
  std::vector<PeriodicSide> sides_;
  int d_;
  std::map<Corners, const PeriodicSide*> side_of_;
  std::map<std::string, Index> material_;
  std::size_t n_sides_ = 0, n_others_ = 0;
  HtmlMesh page_;
};

double least_angle(const std::array<Vec3, 4>& p, std::size_t corners) {
  double least = std::numbers::pi;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = corners == 3 ? i : 0; j < (corners == 3 ? i + 1 : i); ++j) {
      std::array<std::size_t, 2> other{};
      for (std::size_t k = 0, n = 0; k < corners; ++k)
        if (k != i && k != j) other[n++] = k;
      const double angle = corners == 3 ? angle_between(p[other[0]] - p[i], p[other[1]] - p[i])
                                        : dihedral_angle(p[i], p[j], p[other[0]], p[other[1]]);
      least = std::min(least, angle);
    }
  return least * 180 / std::numbers::pi;
}

constexpr double bin = 5;

/// Facets by their least angle.
std::vector<std::size_t> count_angles(const PeriodicTile& tile, std::size_t bins) {
  std::vector<std::size_t> counts(bins, 0);
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto c = tile.facets.facet(f);
    std::array<Vec3, 4> p{};
    for (std::size_t i = 0; i < c.size(); ++i)
      p[i] = {tile.points[c[i]][0], tile.points[c[i]][1], tile.points[c[i]][2]};
    ++counts[std::min(bins - 1, static_cast<std::size_t>(least_angle(p, c.size()) / bin))];
  }
  return counts;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

HtmlMesh html_mesh(const PeriodicDomain& domain) {
  return Painter(domain).page();
}

TilePage::TilePage(const PeriodicDomain& before) : before_(html_mesh(before)) {
  const PeriodicTile tile = before.tile_lists();
  const bool is_solid = tile.facets.dimension == 3;
  histogram_.name = is_solid ? "Tetrahedra by their least dihedral angle, in degrees"
                             : "Triangles by their least angle, in degrees";
  const std::size_t bins = is_solid ? 15 : 12;  // 70.5 and 60 degrees at best
  for (std::size_t i = 0; i <= bins; ++i) histogram_.bounds.push_back(bin * static_cast<double>(i));
  histogram_.before = count_angles(tile, bins);
}

void TilePage::show(RunReport& report, const PeriodicDomain& after, const std::string& input,
                    const std::string& output) {
  HtmlReport page;
  page.title = file_name(input);
  page.before = std::move(before_);
  page.before.caption = file_name(input);
  page.after = html_mesh(after);
  page.after.caption = file_name(output);
  histogram_.after = count_angles(after.tile_lists(), histogram_.before.size());
  page.histograms.push_back(std::move(histogram_));
  for (std::size_t i = 0; i < 3; ++i) {
    LatticeVector unit{};
    unit[i] = 1;
    if (after.lattice().is_periodic(static_cast<int>(i))) page.periods.push_back(after.lattice().shift(unit));
  }
  page.numbers = report.json();
  report.show(std::move(page));
}

}  // namespace multimesh::tools
