// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/texture_orientation.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/geometry/orient2d.hpp"

namespace multimesh::decimation {

namespace {

/// Doubled area that counts as none, relative to the squared diagonal of the bounding box.
constexpr double relative_no_area = 1e-11;
/// A chart has an orientation if what its sides have more than each other is at least this share of its area.
constexpr double oriented_share = 0.8;

int orientation(const std::array<Vec2, 3>& t) {
  return orient2d(t[0].data(), t[1].data(), t[2].data());
}

double doubled_area(const std::array<Vec2, 3>& t) {
  const Vec2 u = t[1] - t[0], v = t[2] - t[0];
  return u[0] * v[1] - u[1] * v[0];
}

int sign(double area, double none) {
  return area > none ? 1 : area < -none ? -1 : 0;
}

struct Box {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const Vec2& p) { low = min(low, p), high = max(high, p); }
  double squared_diagonal() const { return low[0] > high[0] ? 0 : (high - low).squared_norm(); }
};

}  // namespace

TextureOrientation::TextureOrientation(const TriangleReader& reader, std::size_t set)
    : PlacementTest(set == 0 ? "texture orientation" : "texture orientation " + std::to_string(set + 1)),
      set_(set) {
  find_charts(reader.tree().mesh(reader.texture(set)));
  orient_charts(reader);
}

void TextureOrientation::find_charts(const Mesh& texture) {
  chart_of_.assign(texture.capacity(2), no_index);
  std::vector<Index> chart;
  for (Index start = 0; start < texture.capacity(2); ++start) {
    if (chart_of_[start] != no_index || !texture.is_live(2, start)) continue;
    const auto id = static_cast<Index>(charts_.size());
    charts_.emplace_back();
    chart_of_[start] = id;
    chart.assign(1, start);
    while (!chart.empty()) {
      Dart d = texture.dart_of(2, chart.back());
      chart.pop_back();
      for (int side = 0; side < 3; ++side, d = texture.reorder(d, edge_bx)) {
        const Dart across = texture.switch_dart(d, 2);
        if (across == no_dart || chart_of_[texture.facet(across)] != no_index) continue;
        chart_of_[texture.facet(across)] = id;
        chart.push_back(texture.facet(across));
      }
    }
  }
}

// Signs are taken in the order that the surface's own darts give, since stars are read in it; a chart runs
// with the surface everywhere or against it everywhere.
void TextureOrientation::orient_charts(const TriangleReader& reader) {
  const Mesh& mesh = reader.mesh();
  std::vector<double> total(charts_.size(), 0), absolute(charts_.size(), 0);
  std::vector<Box> boxes(charts_.size());
  Box whole;
  SurfaceTriangle t;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    reader.read(mesh.dart_of(2, f), t);
    if (t.sets[set_].facet == no_index) continue;
    const Index chart = chart_of_[t.sets[set_].facet];
    const double area = doubled_area(t.sets[set_].texcoords);
    total[chart] += area;
    absolute[chart] += std::abs(area);
    for (const Vec2& p : t.sets[set_].texcoords) boxes[chart].add(p), whole.add(p);
  }
  no_area_ = relative_no_area * whole.squared_diagonal();
  for (std::size_t c = 0; c < charts_.size(); ++c)
    charts_[c] = {sign(total[c], oriented_share * absolute[c]),
                  relative_no_area * boxes[c].squared_diagonal()};
}

bool TextureOrientation::allows(const PredictedStar& star, const CollapsePlan&) {
  return std::all_of(star.faces().begin(), star.faces().end(), [&](const PredictedStar::Face& f) {
    return f.dies || !f.changes || f.before.sets[set_].facet == no_index || keeps_sign(f);
  });
}

// Asked twice: of the exact signs, so that no triangle flips, however small; and of those of areas that can
// be seen, so that none grows on the wrong side out of one that cannot. What a triangle has on the right
// side, or had before, it may have.
bool TextureOrientation::keeps_sign(const PredictedStar::Face& f) const {
  const Chart& chart = charts_[chart_of_[f.before.sets[set_].facet]];
  const std::array<Vec2, 3>& old = f.before.sets[set_].texcoords;
  const std::array<Vec2, 3> now = f.texcoords_after(set_);
  const double before = doubled_area(old), after = doubled_area(now);
  const int seen = sign(after, chart.no_area), has = orientation(now);
  if (seen != chart.sign && seen != sign(before, chart.no_area)) return false;
  if (has != chart.sign) {
    const int had = orientation(old);
    if (has != had && (had != 0 || chart.sign != 0)) return false;
  }
  return std::abs(before) <= no_area_ || std::abs(after) > no_area_;
}

}  // namespace multimesh::decimation
