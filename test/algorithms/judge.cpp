// SPDX-License-Identifier: BSD-3-Clause
#include "test/algorithms/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <tuple>

namespace multimesh::test {

namespace {

using Triangle = std::array<int, 3>;
using Edge = std::array<int, 2>;

Edge edge(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

class Pieces {
 public:
  explicit Pieces(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    int& p = parent_[static_cast<std::size_t>(i)];
    return p == i ? i : p = find(p);
  }
  void join(int i, int j) { parent_[static_cast<std::size_t>(find(i))] = find(j); }
  template <class Set>
  long count(const Set& of) {
    std::set<int> roots;
    for (const int i : of) roots.insert(find(i));
    return static_cast<long>(roots.size());
  }

 private:
  std::vector<int> parent_;
};

std::map<Edge, std::vector<int>> triangles_by_edge(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<int>> by_edge;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      by_edge[edge(triangles[t][i], triangles[t][(i + 1) % 3])].push_back(static_cast<int>(t));
  return by_edge;
}

long pinched(const std::vector<Triangle>& triangles, int vertices) {
  std::vector<std::vector<Edge>> links(static_cast<std::size_t>(vertices));
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      links[static_cast<std::size_t>(t[i])].push_back({t[(i + 1) % 3], t[(i + 2) % 3]});
  long n = 0;
  for (const auto& link : links) {
    std::map<int, int> number;
    for (const Edge& e : link)
      for (const int v : e) number.emplace(v, static_cast<int>(number.size()));
    Pieces rings(number.size());
    for (const Edge& e : link) rings.join(number[e[0]], number[e[1]]);
    std::vector<int> all(number.size());
    std::iota(all.begin(), all.end(), 0);
    n += rings.count(all) > 1;
  }
  return n;
}

ComplexFacts complex_facts(const std::vector<Triangle>& triangles, int vertices) {
  ComplexFacts f;
  std::set<int> used, rim;
  for (const Triangle& t : triangles) used.insert(t.begin(), t.end());
  const auto by_edge = triangles_by_edge(triangles);
  Pieces sheets(triangles.size()), loops(static_cast<std::size_t>(vertices));
  for (const auto& [e, at] : by_edge) {
    for (const int t : at) sheets.join(at[0], t);
    f.crowded_edges += at.size() > 2;
    if (at.size() == 1) loops.join(e[0], e[1]), rim.insert(e.begin(), e.end());
  }
  std::vector<int> all(triangles.size());
  std::iota(all.begin(), all.end(), 0);
  f.components = sheets.count(all);
  f.euler =
      static_cast<long>(used.size()) - static_cast<long>(by_edge.size()) + static_cast<long>(all.size());
  f.boundary = loops.count(rim);
  f.pinched_vertices = pinched(triangles, vertices);
  return f;
}

std::vector<Triangle> by_position(const TexturedTriangles& s) {
  std::vector<Triangle> result;
  for (const auto& t : s.triangles) result.push_back({t[0].position, t[1].position, t[2].position});
  return result;
}

/// Triangles by vertices of the texture, which are numbered; -1 in all corners where there is none.
std::vector<Triangle> by_texcoord(const TexturedTriangles& s, int& vertices) {
  std::map<std::tuple<int, double, double>, int> number;
  std::vector<Triangle> result;
  for (const auto& t : s.triangles) {
    Triangle corners{-1, -1, -1};
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i].texcoord < 0) continue;
      const Vec2& p = s.texcoords[static_cast<std::size_t>(t[i].texcoord)];
      const auto key = std::tuple(t[i].position, p[0], p[1]);
      corners[i] = number.emplace(key, static_cast<int>(number.size())).first->second;
    }
    result.push_back(corners);
  }
  vertices = static_cast<int>(number.size());
  return result;
}

SeamFacts seam_facts(const TexturedTriangles& s, const std::vector<Triangle>& textured) {
  const auto at = by_position(s);
  const auto copy = [&](int t, int v) {
    for (std::size_t i = 0; i < 3; ++i)
      if (at[static_cast<std::size_t>(t)][i] == v) return textured[static_cast<std::size_t>(t)][i];
    return -2;
  };
  std::vector<Edge> seams;
  std::map<int, std::vector<int>> around;
  for (const auto& [e, sides] : triangles_by_edge(at)) {
    if (sides.size() != 2) continue;
    if (copy(sides[0], e[0]) == copy(sides[1], e[0]) && copy(sides[0], e[1]) == copy(sides[1], e[1]))
      continue;
    for (const int v : e) around[v].push_back(static_cast<int>(seams.size()));
    seams.push_back(e);
  }
  SeamFacts f;
  Pieces curves(seams.size());
  for (const auto& [v, list] : around) {
    f.ends += list.size() == 1;
    f.junctions += list.size() > 2;
    if (list.size() == 2) curves.join(list[0], list[1]);
  }
  std::vector<int> all(seams.size());
  std::iota(all.begin(), all.end(), 0);
  f.curves = curves.count(all);
  return f;
}

double doubled_area(const TexturedTriangles& s, std::size_t t) {
  std::array<Vec2, 3> p;
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = s.texcoords[static_cast<std::size_t>(s.triangles[t][i].texcoord)];
  const Vec2 u = p[1] - p[0], v = p[2] - p[0];
  return u[0] * v[1] - u[1] * v[0];
}

bool runs_along(const Triangle& t, int a, int b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

/// Per triangle: the sign of its area relative to its chart; 0 for a chart without area. Charts are
/// traversed over edges with two triangles; between triangles of opposite orientation the sign
/// changes.
std::vector<int> right_signs(const TexturedTriangles& s, const std::vector<Triangle>& textured) {
  const auto by_edge = triangles_by_edge(textured);
  std::vector<int> turn(textured.size(), 0), sign(textured.size(), 0);
  for (std::size_t start = 0; start < textured.size(); ++start) {
    if (turn[start] != 0 || textured[start][0] < 0) continue;
    std::vector<std::size_t> chart{start};
    turn[start] = 1;
    double total = 0;
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Triangle t = textured[chart[i]];
      total += turn[chart[i]] * doubled_area(s, chart[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const auto& sides = by_edge.at(edge(a, b));
        if (sides.size() != 2) continue;
        const auto next = static_cast<std::size_t>(sides[0]) == chart[i] ? static_cast<std::size_t>(sides[1])
                                                                         : static_cast<std::size_t>(sides[0]);
        if (turn[next] != 0) continue;
        turn[next] = runs_along(textured[next], a, b) ? -turn[chart[i]] : turn[chart[i]];
        chart.push_back(next);
      }
    }
    for (const std::size_t t : chart) sign[t] = turn[t] * (total > 0 ? 1 : total < 0 ? -1 : 0);
  }
  return sign;
}

}  // namespace

Facts facts(const TexturedTriangles& surface) {
  Facts f;
  f.surface = complex_facts(by_position(surface), static_cast<int>(surface.positions.size()));
  int vertices = 0;
  std::vector<Triangle> textured = by_texcoord(surface, vertices);
  f.seams = seam_facts(surface, textured);
  std::erase_if(textured, [](const Triangle& t) { return t[0] < 0; });
  f.texture = complex_facts(textured, vertices);
  return f;
}

std::size_t newly_flipped(const TexturedTriangles& in, const TexturedTriangles& out,
                          const std::vector<Index>& source) {
  int vertices = 0;
  const std::vector<int> sign = right_signs(in, by_texcoord(in, vertices));
  Vec2 low(HUGE_VAL, HUGE_VAL), high(-HUGE_VAL, -HUGE_VAL);
  for (const Vec2& p : in.texcoords) low = min(low, p), high = max(high, p);
  const double zero = 1e-12 * (high - low).squared_norm();
  std::size_t n = 0;
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    if (out.triangles[t][0].texcoord < 0 || sign[source[t]] == 0) continue;
    const bool was_right = doubled_area(in, source[t]) * sign[source[t]] > zero;
    n += was_right && !(doubled_area(out, t) * sign[source[t]] > zero);
  }
  return n;
}

std::ostream& operator<<(std::ostream& out, const Facts& f) {
  for (const ComplexFacts& c : {f.surface, f.texture})
    out << c.components << " components, Euler " << c.euler << ", boundary " << c.boundary << ", crowded "
        << c.crowded_edges << ", pinched " << c.pinched_vertices << "; ";
  return out << f.seams.curves << " curves, " << f.seams.ends << " ends, " << f.seams.junctions
             << " junctions";
}

}  // namespace multimesh::test
