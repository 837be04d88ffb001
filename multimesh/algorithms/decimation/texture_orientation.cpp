// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/texture_orientation.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/geometry/keeps_side.hpp"

namespace multimesh::decimation {

namespace {

/// A chart has an orientation if what its sides have more than each other is at least this share of its area.
constexpr double oriented_share = 0.8;

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
  keeps_.no_area = KeepsSide::relative_no_area * whole.squared_diagonal();
  for (std::size_t c = 0; c < charts_.size(); ++c)
    charts_[c] = {sign(total[c], oriented_share * absolute[c]),
                  KeepsSide::relative_no_area * boxes[c].squared_diagonal()};
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
  const Corners<2>& old = f.before.sets[set_].texcoords;
  const Corners<2> now = f.texcoords_after(set_);
  const int seen = sign(doubled_area(now), chart.no_area);
  if (seen != chart.sign && seen != sign(doubled_area(old), chart.no_area)) return false;
  // In a chart without a wrong side, a triangle without area may get any.
  return keeps_(old, now, chart.sign != 0 || side_of(old) != 0 ? chart.sign : side_of(now));
}

}  // namespace multimesh::decimation
