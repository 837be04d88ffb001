// SPDX-License-Identifier: BSD-3-Clause
#include "test/property/value_model.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::test {

namespace {

bool near(double x, double y) {
  return std::abs(x - y) <= 1e-9 * (1 + std::abs(x));
}

Vertices replaced(const Vertices& s, unsigned old, unsigned now) {
  Vertices result = s;
  if (result.erase(old) > 0) result.insert(now);
  return result;
}

double mean(double at_a, double at_b, double t) {
  return (1 - t) * at_a + t * at_b;
}

/// Two simplices that become one: `b` at the vertex that survives.
Values merged(const Values& a, const Values& b, double t, bool a_wins) {
  Values v = a_wins ? a : b;
  v.flags = a.flags | b.flags;
  v.status = a.status | b.status;
  v.larger = std::max(a.larger, b.larger);
  v.mean = mean(a.mean, b.mean, t);
  return v;
}

Values half(const Values& whole, double share) {
  Values v = whole;
  v.part = whole.part * share;
  return v;
}

Values fresh() {
  Values v;
  v.plain = fresh_plain;
  return v;
}

/// The facet with another vertex in the place of one; its corner there stays.
Facet renamed(const Facet& f, unsigned old, unsigned now) {
  Facet g = f;
  std::replace(g.order.begin(), g.order.end(), old, now);
  if (const auto corner = f.corners.find(old); corner != f.corners.end()) {
    g.corners.erase(old);
    g.corners[now] = corner->second;
  }
  return g;
}

Vertices set_of(const Facet& f) {
  return {f.order.begin(), f.order.end()};
}

}  // namespace

const char* difference(const Values& x, const Values& y) {
  if (x.carried != y.carried) return "carried";
  if (x.plain != y.plain) return "plain";
  if (x.flags != y.flags) return "flags";
  if (x.status != y.status) return "status";
  if (x.larger != y.larger) return "larger";
  if (!near(x.mean, y.mean)) return "mean";
  if (!near(x.part, y.part)) return "part";
  return nullptr;
}

void ValueMesh::halve(std::map<Vertices, Values>& all, unsigned a, unsigned b, unsigned c, double t) {
  std::map<Vertices, Values> now;
  for (const auto& [s, v] : all) {
    if (!s.contains(a) || !s.contains(b)) {
      now[s] = v;
      continue;
    }
    now[replaced(s, b, c)] = half(v, t);
    now[replaced(s, a, c)] = half(v, 1 - t);
  }
  all = std::move(now);
}

void ValueMesh::split(unsigned a, unsigned b, unsigned c, double t) {
  vertices[c].mean = mean(vertices[a].mean, vertices[b].mean, t);
  vertices[c].plain = vertices[t < 0.5 ? a : b].plain;
  halve(edges, a, b, c, t);
  halve(faces, a, b, c, t);
  std::map<Vertices, Facet> now;
  for (const auto& [s, f] : facets) {
    if (!s.contains(a) || !s.contains(b)) {
      now[s] = f;
      continue;
    }
    for (const unsigned out : {a, b}) {
      Facet g = renamed(f, out, c);
      g.values = half(f.values, out == b ? t : 1 - t);
      if (!f.corners.empty()) g.corners[c].mean = mean(f.corners.at(a).mean, f.corners.at(b).mean, t);
      now[set_of(g)] = g;
    }
    if (dimension == 2)
      for (const unsigned x : s)
        if (x != a && x != b) edges[{c, x}] = fresh();
  }
  facets = std::move(now);
}

void ValueMesh::merge(std::map<Vertices, Values>& all, unsigned a, unsigned b, double t,
                      const std::set<Vertices>& a_wins, bool taking_back) {
  std::map<Vertices, Values> now;
  for (const auto& [s, v] : all)
    if (!s.contains(a)) now[s] = v;
  for (const auto& [s, v] : all) {
    if (!s.contains(a) || s.contains(b)) continue;
    const Vertices kept = replaced(s, a, b);
    // Whether they become one: in dimension 3 one of them may be there without a value.
    bool join = all.contains(kept);
    if (dimension == 3)
      for (const auto& [f, values] : facets)
        join |= f.contains(a) && std::includes(f.begin(), f.end(), kept.begin(), kept.end());
    if (join && taking_back) continue;
    now[kept] = all.contains(kept) ? merged(v, all.at(kept), t, a_wins.contains(s)) : v;
  }
  all = std::move(now);
}

void ValueMesh::collapse(unsigned a, unsigned b, double t, const std::set<Vertices>& a_wins,
                         bool taking_back) {
  Values& at_b = vertices[b];
  if (t < 1) {
    at_b.mean = mean(vertices[a].mean, at_b.mean, t);
    at_b.plain = vertices[t < 0.5 ? a : b].plain;
  }
  vertices.erase(a);
  merge(edges, a, b, t, a_wins, taking_back);
  merge(faces, a, b, t, a_wins, taking_back);
  std::map<Vertices, Facet> now;
  for (const auto& [s, f] : facets) {
    if (s.contains(a) && s.contains(b)) continue;
    const Facet g = renamed(f, a, b);
    now[set_of(g)] = g;
  }
  facets = std::move(now);
}

void ValueMesh::flip(unsigned a, unsigned b, unsigned l, unsigned r) {
  const Facet left = facets.at({a, b, l}), right = facets.at({a, b, r});
  facets.erase({a, b, l});
  facets.erase({a, b, r});
  for (const Facet& f : {left, right}) {
    const Facet& other = set_of(f) == set_of(left) ? right : left;
    const unsigned apex = set_of(f) == set_of(left) ? l : r, beyond = apex == l ? r : l;
    const auto at_a =
        static_cast<std::size_t>(std::find(f.order.begin(), f.order.end(), a) - f.order.begin());
    const unsigned lost = f.order[(at_a + 1) % 3] == b ? b : a;
    Facet g = renamed(f, lost, beyond);
    g.values.part += 2 * other.values.part;
    g.corners[beyond] = other.corners.at(beyond);
    facets[set_of(g)] = g;
  }
  edges.erase({a, b});
  edges[{l, r}] = fresh();
}

}  // namespace multimesh::test
