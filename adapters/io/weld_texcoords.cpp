// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/weld_texcoords.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multimesh::io {
namespace {

using Uv = std::array<double, 2>;

/// Not joined, but nearer than charts in an atlas: a tenth of a texel of 1024.
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
    if (!find_several()) return;
    sort_corners();
    std::vector<std::int32_t> joined(soup_.corners.size());
    for (std::size_t c = 0; c < joined.size(); ++c) joined[c] = soup_.corners[c].vt;
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
      if (begin_[v] != begin_[v + 1]) vertex(v, joined);
    if (!any_joined_) return;
    for (std::size_t f = 0; f < soup_.face_count(); ++f) take(f, joined);
  }

 private:
  /// Finds vertices whose corners name several coordinates; at most vertices all corners name one.
  bool find_several() {
    std::vector<std::int32_t> first(soup_.positions.size(), -1);
    several_.assign(first.size(), 0);
    bool any = false;
    for (const auto& c : soup_.corners) {
      if (c.vt < 0) continue;
      std::int32_t& known = first[static_cast<std::size_t>(c.v)];
      if (known == c.vt) continue;
      if (known < 0) {
        known = c.vt;
        ++report_.textured_vertices;
      } else {
        several_[static_cast<std::size_t>(c.v)] = 1;
        any = true;
      }
    }
    return any;
  }

  /// Corners by vertex, where it has several coordinates: those of v are [begin_[v], begin_[v+1]).
  void sort_corners() {
    const auto v = [&](std::size_t c) { return static_cast<std::size_t>(soup_.corners[c].v); };
    begin_.assign(several_.size() + 1, 0);
    for (std::size_t c = 0; c < soup_.corners.size(); ++c) begin_[v(c) + 1] += several_[v(c)];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    order_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t c = 0; c < soup_.corners.size(); ++c)
      if (several_[v(c)]) order_[next[v(c)]++] = c;
  }

  const Uv& value(std::int32_t vt) const { return soup_.texcoords[static_cast<std::size_t>(vt)]; }

  /// Each corner joins the nearest coordinate within the tolerance that joined no other, as in
  /// coincident_points; there are few at one vertex.
  void vertex(std::size_t v, std::vector<std::int32_t>& joined) {
    kept_.clear();
    double farthest = 0;
    for (std::uint32_t i = begin_[v]; i < begin_[v + 1]; ++i) {
      const std::int32_t vt = soup_.corners[order_[i]].vt;
      if (vt < 0) continue;
      const auto [nearest, d] = nearest_kept(vt);
      if (nearest >= 0 && d <= tolerance_) {
        // Equal values already count as one, and may have different numbers on purpose.
        if (d != 0) joined[order_[i]] = nearest;
        any_joined_ |= d != 0;
      } else {
        kept_.push_back(vt);
        if (nearest >= 0 && d < near) farthest = std::max(farthest, d);
      }
    }
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

  /// A face that would flip, or lose its area, keeps its coordinates.
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
  std::vector<std::uint8_t> several_;  ///< per vertex, whether its corners name several
  std::vector<std::uint32_t> begin_, order_;
  bool any_joined_ = false;
  std::vector<std::int32_t> kept_;
};

}  // namespace

void weld_texcoords(PolygonSoup& soup, double tolerance, SurfaceWeldReport& report) {
  if (!soup.texcoords.empty()) TexcoordWeld(soup, tolerance, report).run();
}

}  // namespace multimesh::io
