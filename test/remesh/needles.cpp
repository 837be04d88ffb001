// SPDX-License-Identifier: BSD-3-Clause
#include "test/remesh/needles.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace multimesh::test {

namespace {

using Ring = std::vector<int>;

class Builder {
 public:
  int vertex(double x, double y, double z) {
    out.positions.emplace_back(x, y, z);
    return static_cast<int>(out.positions.size() - 1);
  }
  void triangle(int a, int b, int c) {
    auto& t = out.triangles.emplace_back();
    t[0].position = a, t[1].position = b, t[2].position = c;
    for (auto& corner : t) corner.texcoord = -1;
  }
  Ring ring(int n, double radius, double z, double x = 0, double y = 0) {
    Ring r;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      r.push_back(vertex(x + radius * std::cos(angle), y + radius * std::sin(angle), z));
    }
    return r;
  }
  void band(const Ring& low, const Ring& high) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      const std::size_t j = (i + 1) % low.size();
      triangle(low[i], low[j], high[j]);
      triangle(low[i], high[j], high[i]);
    }
  }
  void tip(const Ring& r, int middle) {
    for (std::size_t i = 0; i < r.size(); ++i) triangle(r[i], r[(i + 1) % r.size()], middle);
  }
  /// What a square has besides a hole. Both turn left seen from above; a quarter of the rim to each corner.
  void around_hole(const Ring& square, const Ring& hole, bool from_below) {
    const auto add = [&](int a, int p, int q) { from_below ? triangle(a, q, p) : triangle(a, p, q); };
    const std::size_t n = hole.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = 4 * i / n, next = 4 * (i + 1) / n;
      add(square[k], hole[(i + 1) % n], hole[i]);
      if (next != k) add(square[k], square[next % 4], hole[(i + 1) % n]);
    }
  }
  /// Seen from its front, the ring turns left.
  void close(const Ring& r, Cap cap, double z) {
    const std::size_t n = r.size();
    if (cap == Cap::fan) {
      tip(r, vertex(0, 0, z));
    }
    if (cap == Cap::corner)
      for (std::size_t i = 1; i + 1 < n; ++i) triangle(r[0], r[i], r[i + 1]);
    if (cap == Cap::strip)
      for (std::size_t low = 0, high = n - 1; high - low > 1;) {
        triangle(r[low], r[low + 1], r[high]);
        if (++low == high - 1) break;
        triangle(r[low], r[high - 1], r[high]);
        --high;
      }
    if (cap == Cap::halves) halve(r, 0, n - 1);
  }

  TexturedTriangles out;

 private:
  void halve(const Ring& r, std::size_t first, std::size_t last) {
    if (last - first < 2) return;
    const std::size_t middle = (first + last) / 2;
    triangle(r[first], r[middle], r[last]);
    halve(r, first, middle);
    halve(r, middle, last);
  }
};

Ring reversed(const Ring& r) {
  return {r.rbegin(), r.rend()};
}

}  // namespace

std::string name(Cap cap) {
  return cap == Cap::fan ? "Fan" : cap == Cap::corner ? "Corner" : cap == Cap::strip ? "Strip" : "Halves";
}

TexturedTriangles disk(int segments, Cap cap) {
  Builder b;
  b.close(b.ring(segments, 1, 0), cap, 0);
  return b.out;
}

TexturedTriangles cone(int segments, double height, Cap cap) {
  Builder b;
  const Ring base = b.ring(segments, 1, 0);
  b.tip(base, b.vertex(0, 0, height));
  b.close(reversed(base), cap, 0);
  return b.out;
}

TexturedTriangles cylinder(int segments, double height, double radius_on_top, Cap cap) {
  Builder b;
  const Ring low = b.ring(segments, 1, 0), high = b.ring(segments, radius_on_top, height);
  b.band(low, high);
  b.close(reversed(low), cap, 0);
  b.close(high, cap, height);
  return b.out;
}

TexturedTriangles eccentric_disk(int segments, double x, double y) {
  Builder b;
  b.tip(b.ring(segments, 1, 0), b.vertex(x, y, 0));
  return b.out;
}

TexturedTriangles lens(int segments) {
  Builder b;
  const Ring rim = b.ring(segments, 1, 0);
  b.tip(rim, b.vertex(0, 0, 1));
  b.tip(reversed(rim), b.vertex(0, 0, -1));
  return b.out;
}

TexturedTriangles drilled_plate(int segments, double x, double y, double radius, double thickness) {
  Builder b;
  const auto level = [&](double z) {
    Ring corners{b.vertex(1, 1, z), b.vertex(-1, 1, z), b.vertex(-1, -1, z), b.vertex(1, -1, z)};
    return std::pair{corners, b.ring(segments, radius, z, x, y)};
  };
  const auto [low, low_hole] = level(0);
  if (thickness == 0) {
    b.around_hole(low, low_hole, false);
    return b.out;
  }
  const auto [high, high_hole] = level(thickness);
  b.around_hole(low, low_hole, true);
  b.around_hole(high, high_hole, false);
  b.band(low, high);
  b.band(reversed(low_hole), reversed(high_hole));
  return b.out;
}

TexturedTriangles plate(int segments, double thickness) {
  Builder b;
  const double y[] = {0, 1, 1, 0}, z[] = {0, 0, thickness, thickness};
  Ring before;
  for (int i = 0; i <= segments; ++i) {
    Ring r;
    for (int k = 3; k >= 0; --k) r.push_back(b.vertex(double(i) / segments, y[k], z[k]));
    if (i > 0) b.band(before, r);
    if (i == 0) b.close(reversed(r), Cap::corner, 0);
    if (i == segments) b.close(r, Cap::corner, 0);
    before = r;
  }
  return b.out;
}

}  // namespace multimesh::test
