// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/weld_texcoords.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::io {
namespace {

using Uv = std::array<double, 2>;

/// Not joined, but nearer than charts are in an atlas: a tenth of a texel of 1024.
constexpr double near = 1e-4;

/// Relative to the size of the coordinates, where that is above 1.
double distance(const Uv& a, const Uv& b) {
  const double size = std::max({1.0, std::abs(a[0]), std::abs(a[1]), std::abs(b[0]), std::abs(b[1])});
  return std::hypot(a[0] - b[0], a[1] - b[1]) / size;
}

class TexcoordWeld {
 public:
  TexcoordWeld(PolygonSoup& soup, double tolerance, SurfaceWeldReport& report)
      : soup_(soup), tolerance_(tolerance), report_(report) {}

  void run() {
    sort_corners();
    std::vector<std::int32_t> joined(soup_.corners.size());
    for (std::size_t c = 0; c < joined.size(); ++c) joined[c] = soup_.corners[c].vt;
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) vertex(v, joined);
    for (std::size_t f = 0; f < soup_.face_count(); ++f) take(f, joined);
  }

 private:
  /// Corners by vertex: those of v are [begin_[v], begin_[v+1]).
  void sort_corners() {
    begin_.assign(soup_.positions.size() + 1, 0);
    for (const auto& c : soup_.corners) ++begin_[static_cast<std::size_t>(c.v) + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    order_.resize(soup_.corners.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t c = 0; c < order_.size(); ++c)
      order_[next[static_cast<std::size_t>(soup_.corners[c].v)]++] = c;
  }

  const Uv& value(std::int32_t vt) const { return soup_.texcoords[static_cast<std::size_t>(vt)]; }

  /// Each corner joins the nearest coordinate within the tolerance that joined no other, as in
  /// coincident_points; few are at one vertex.
  void vertex(std::size_t v, std::vector<std::int32_t>& joined) {
    kept_.clear();
    double farthest = 0;
    for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i) {
      const std::int32_t vt = soup_.corners[order_[i]].vt;
      if (vt < 0) continue;
      const auto [nearest, d] = nearest_kept(vt);
      if (nearest >= 0 && d <= tolerance_) {
        // Equal values are one anyway, and may have numbers of their own on purpose.
        joined[order_[i]] = d == 0 ? vt : nearest;
      } else {
        kept_.push_back(vt);
        if (nearest >= 0 && d < near) farthest = std::max(farthest, d);
      }
    }
    report_.textured_vertices += !kept_.empty();
    if (farthest == 0) return;
    ++report_.near_texcoords;
    report_.near_texcoord_distance = std::max(report_.near_texcoord_distance, farthest);
  }

  std::pair<std::int32_t, double> nearest_kept(std::int32_t vt) const {
    std::pair<std::int32_t, double> found{-1, 0};
    for (const std::int32_t other : kept_) {
      if (other == vt) return {vt, 0};
      const double d = distance(value(vt), value(other));
      if (found.first < 0 || d < found.second) found = {other, d};
    }
    return found;
  }

  /// A face that would turn over, or lose its area, keeps what it has.
  void take(std::size_t f, const std::vector<std::int32_t>& joined) {
    const std::uint32_t begin = soup_.face_begin[f], end = soup_.face_begin[f + 1];
    const auto old = [&](std::uint32_t c) { return soup_.corners[c].vt; };
    const auto now = [&](std::uint32_t c) { return joined[c]; };
    std::size_t moved = 0;
    for (std::uint32_t c = begin; c < end; ++c) moved += old(c) >= 0 && value(old(c)) != value(now(c));
    if (moved != 0 && sign(begin, end, old) != sign(begin, end, now)) return;
    report_.texcoords += moved;
    for (std::uint32_t c = begin; c < end; ++c) soup_.corners[c].vt = joined[c];
  }

  /// Of the area of a face in the texture.
  template <class Texcoord>
  int sign(std::uint32_t begin, std::uint32_t end, const Texcoord& texcoord) const {
    double area = 0;
    for (std::uint32_t c = begin; c < end; ++c)
      if (texcoord(c) < 0) return 0;
    const Uv& o = value(texcoord(begin));
    for (std::uint32_t c = begin + 1; c + 1 < end; ++c) {
      const Uv &a = value(texcoord(c)), &b = value(texcoord(c + 1));
      area += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  PolygonSoup& soup_;
  double tolerance_;
  SurfaceWeldReport& report_;
  std::vector<std::uint32_t> begin_, order_;
  std::vector<std::int32_t> kept_;
};

}  // namespace

void weld_texcoords(PolygonSoup& soup, double tolerance, SurfaceWeldReport& report) {
  if (!soup.texcoords.empty()) TexcoordWeld(soup, tolerance, report).run();
}

}  // namespace multimesh::io
