// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/simplex.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace multimesh::oracle {

namespace {

void insert_vertex(Simplex& s, int vertex) {
  int at = 0;
  while (at < s.n && s.v[static_cast<std::size_t>(at)] < vertex) ++at;
  if (at < s.n && s.v[static_cast<std::size_t>(at)] == vertex) return;
  if (s.n == 4) throw std::logic_error("a simplex with more than four vertices");
  for (int i = s.n; i > at; --i) s.v[static_cast<std::size_t>(i)] = s.v[static_cast<std::size_t>(i - 1)];
  s.v[static_cast<std::size_t>(at)] = vertex;
  ++s.n;
}

}  // namespace

Simplex simplex(std::initializer_list<int> vertices) {
  Simplex s;
  for (int v : vertices) insert_vertex(s, v);
  return s;
}

Simplex joined(Simplex s, int vertex) {
  insert_vertex(s, vertex);
  return s;
}

bool contains(const Simplex& s, int vertex) {
  return std::find(s.v.begin(), s.v.begin() + s.n, vertex) != s.v.begin() + s.n;
}

bool contains(const Simplex& s, const Simplex& face) {
  return std::includes(s.v.begin(), s.v.begin() + s.n, face.v.begin(), face.v.begin() + face.n);
}

bool contains(const SimplexSet& set, const Simplex& s) {
  return std::binary_search(set.begin(), set.end(), s);
}

Simplex minus(const Simplex& s, const Simplex& t) {
  Simplex rest;
  for (int i = 0; i < s.n; ++i) {
    const int v = s.v[static_cast<std::size_t>(i)];
    if (!contains(t, v)) rest.v[static_cast<std::size_t>(rest.n++)] = v;
  }
  return rest;
}

void normalize(SimplexSet& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

SimplexSet closure(const SimplexSet& list) {
  SimplexSet all;
  all.reserve(list.size() * 15);
  for (const Simplex& s : list) {
    for (int subset = 1; subset < (1 << s.n); ++subset) {
      Simplex face;
      for (int i = 0; i < s.n; ++i) {
        if (subset >> i & 1) face.v[static_cast<std::size_t>(face.n++)] = s.v[static_cast<std::size_t>(i)];
      }
      all.push_back(face);
    }
  }
  normalize(all);
  return all;
}

SimplexSet intersection(const SimplexSet& a, const SimplexSet& b) {
  SimplexSet both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

SimplexSet unite(const SimplexSet& a, const SimplexSet& b) {
  SimplexSet any;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(any));
  return any;
}

SimplexSet of_dimension(const SimplexSet& set, int k) {
  SimplexSet some;
  std::copy_if(set.begin(), set.end(), std::back_inserter(some),
               [k](const Simplex& s) { return s.n == k + 1; });
  return some;
}

Simplex mapped(const Simplex& s, const std::map<int, int>& map) {
  Simplex image;
  for (int i = 0; i < s.n; ++i) insert_vertex(image, map.at(s.v[static_cast<std::size_t>(i)]));
  return image;
}

std::string to_string(const Simplex& s) {
  std::string text = "{";
  for (int i = 0; i < s.n; ++i) {
    if (i > 0) text += ' ';
    text += std::to_string(s.v[static_cast<std::size_t>(i)]);
  }
  return text + '}';
}

}  // namespace multimesh::oracle
