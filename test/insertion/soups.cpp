// SPDX-License-Identifier: BSD-3-Clause
#include "test/insertion/soups.hpp"

#include <random>

namespace multimesh::test {

namespace {

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  unsigned below(unsigned n) { return unsigned(random_()) % n; }
  double unit() { return std::uniform_real_distribution<>(0, 1)(random_); }
  Vec3 anywhere() { return {unit(), unit(), unit()}; }
  Vec3 on_grid(unsigned n) { return {double(below(n)), double(below(n)), double(below(n))}; }

  Index add(const Vec3& p) {
    soup_.points.push_back(p);
    return Index(soup_.points.size() - 1);
  }
  void add(Index a, Index b, Index c) {
    soup_.triangles.corners.insert(soup_.triangles.corners.end(), {a, b, c});
  }
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Index first = add(a);
    add(b), add(c);
    add(first, first + 1, first + 2);
  }
  /// Twelve triangles.
  void add_box(const Vec3& low, const Vec3& high) {
    Index v[8];
    for (unsigned i = 0; i < 8; ++i)
      v[i] = add(Vec3(i & 1U ? high[0] : low[0], i & 2U ? high[1] : low[1], i & 4U ? high[2] : low[2]));
    constexpr unsigned sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& s : sides) add(v[s[0]], v[s[1]], v[s[2]]), add(v[s[0]], v[s[2]], v[s[3]]);
  }
  const std::vector<Vec3>& points() const { return soup_.points; }
  TriangleSoup done() {
    soup_.triangles.vertices = Index(soup_.points.size());
    return std::move(soup_);
  }

 private:
  std::mt19937 random_;
  TriangleSoup soup_;
};

TriangleSoup anywhere(unsigned seed) {
  Maker m(seed);
  for (unsigned n = 3 + m.below(12); n > 0; --n) m.add(m.anywhere(), m.anywhere(), m.anywhere());
  return m.done();
}

TriangleSoup on_grid(unsigned seed) {
  Maker m(seed);
  const unsigned size = 2 + m.below(4);
  for (unsigned n = 3 + m.below(16); n > 0; --n) m.add(m.on_grid(size), m.on_grid(size), m.on_grid(size));
  return m.done();
}

TriangleSoup with_common_vertices(unsigned seed) {
  Maker m(seed);
  const unsigned points = 5 + m.below(6);
  for (unsigned i = 0; i < points; ++i) m.add(seed % 2 ? m.anywhere() : m.on_grid(4));
  for (unsigned n = 5 + m.below(20); n > 0; --n) {
    const Index a = m.below(points), b = m.below(points), c = m.below(points);
    m.add(a, b, c);
    if (m.below(4) == 0) m.add(b, a, c);
  }
  return m.done();
}

TriangleSoup slivers(unsigned seed) {
  Maker m(seed);
  for (unsigned n = 3 + m.below(8); n > 0; --n) {
    const Vec3 a = m.anywhere(), b = m.anywhere();
    m.add(a, b, a + (b - a) * m.unit() + m.anywhere() * (m.below(3) == 0 ? 0 : 1e-6));
  }
  return m.done();
}

TriangleSoup in_planes(unsigned seed) {
  Maker m(seed);
  const unsigned size = 3 + m.below(5);
  for (unsigned n = 3 + m.below(10); n > 0; --n) {
    const std::size_t axis = m.below(2);
    Vec3 p[3] = {m.on_grid(size), m.on_grid(size), m.on_grid(size)};
    for (Vec3& x : p) x[axis] = 1;
    m.add(p[0], p[1], p[2]);
  }
  return m.done();
}

TriangleSoup boxes(unsigned seed) {
  Maker m(seed);
  for (unsigned n = 2 + m.below(3); n > 0; --n) {
    const Vec3 low = m.on_grid(4);
    m.add_box(low, low + m.on_grid(3) + Vec3(1, 1, 1));
  }
  return m.done();
}

TriangleSoup t_junctions(unsigned seed) {
  Maker m(seed);
  m.add(m.on_grid(9), m.on_grid(9), m.on_grid(9));
  for (unsigned n = 3 + m.below(10); n > 0; --n) {
    const auto& p = m.points();
    const auto some = [&] { return p[m.below(unsigned(p.size()))]; };
    const Vec3 a = some(), b = some(), c = (a + b) / 2;
    m.add(c, some(), m.on_grid(9));
  }
  return m.done();
}

}  // namespace

const std::vector<SoupKind>& soup_kinds() {
  static const std::vector<SoupKind> kinds{
      {"Anywhere", anywhere},     {"OnGrid", on_grid},     {"CommonVertices", with_common_vertices},
      {"Slivers", slivers},       {"InPlanes", in_planes}, {"Boxes", boxes},
      {"TJunctions", t_junctions}};
  return kinds;
}

TriangleSoup cube(const Vec3& low, double edge) {
  Maker m(1);
  m.add_box(low, low + Vec3(edge, edge, edge));
  return m.done();
}

}  // namespace multimesh::test
