// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/complex.hpp"

#include <algorithm>

#include "oracle/disjoint_sets.hpp"
#include "oracle/gluing.hpp"
#include "oracle/solid.hpp"

namespace multimesh::oracle {

Simplex facet_simplex(const Complex& c, std::size_t facet) {
  Simplex s;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(c.dim); ++i) s = joined(s, c.facets[facet][i]);
  return s;
}

SimplexSet facet_set(const Complex& c) {
  SimplexSet set;
  set.reserve(c.facets.size());
  for (std::size_t f = 0; f < c.facets.size(); ++f) set.push_back(facet_simplex(c, f));
  normalize(set);
  return set;
}

std::vector<int> vertices(const Complex& c) {
  std::vector<int> all;
  for (const auto& f : c.facets) all.insert(all.end(), f.begin(), f.begin() + c.dim + 1);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

SimplexSet simplices(const Complex& c) {
  return closure(facet_set(c));
}

SimplexSet simplices(const Complex& c, int k) {
  return of_dimension(simplices(c), k);
}

SimplexSet star(const SimplexSet& K, const Simplex& s) {
  SimplexSet cofaces;
  for (const Simplex& t : K) {
    if (contains(t, s)) cofaces.push_back(t);
  }
  return cofaces;
}

SimplexSet link(const SimplexSet& K, const Simplex& s) {
  SimplexSet opposite;
  for (const Simplex& t : K) {
    if (t.n > s.n && contains(t, s)) opposite.push_back(minus(t, s));
  }
  normalize(opposite);
  return opposite;
}

SimplexSet boundary(const Complex& c) {
  if (c.dim == 0) return {};
  SimplexSet sides;
  for (const Simplex& f : facet_set(c)) {
    for (int i = 0; i < f.n; ++i) sides.push_back(minus(f, simplex({f.v[static_cast<std::size_t>(i)]})));
  }
  std::sort(sides.begin(), sides.end());
  SimplexSet once;
  for (auto it = sides.begin(); it != sides.end();) {
    const auto next = std::upper_bound(it, sides.end(), *it);
    if (next - it == 1) once.push_back(*it);
    it = next;
  }
  return closure(once);
}

SimplexSet with_cone(const SimplexSet& K, const SimplexSet& B, int omega) {
  if (B.empty()) return K;
  SimplexSet cone{simplex({omega})};
  for (const Simplex& s : B) cone.push_back(joined(s, omega));
  normalize(cone);
  return unite(K, cone);
}

bool link_condition(const Complex& c, int a, int b) {
  const SimplexSet K = with_cone(simplices(c), boundary(c));
  return intersection(link(K, simplex({a})), link(K, simplex({b}))) == link(K, simplex({a, b}));
}

int euler_characteristic(const Complex& c) {
  int sum = 0;
  for (const Simplex& s : simplices(c)) sum += s.n % 2 == 1 ? 1 : -1;
  return sum;
}

int number_of_components(const Complex& c) {
  const std::vector<int> all = vertices(c);
  DisjointSets sets(all.size());
  const auto index = [&](int v) {
    return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), v) - all.begin());
  };
  for (const auto& f : c.facets) {
    for (std::size_t i = 1; i <= static_cast<std::size_t>(c.dim); ++i) sets.join(index(f[0]), index(f[i]));
  }
  return static_cast<int>(sets.count());
}

std::vector<int> boundary_loops(const Complex& c) {
  return boundary_loops(glue(c));
}

std::vector<int> boundary_points(const Complex& c) {
  std::vector<int> ends;
  for (const Simplex& s : boundary(c)) ends.push_back(s.v[0]);
  return ends;
}

namespace {

std::string facet_error(const Complex& c) {
  if (c.facets.empty()) return "no facets";
  for (std::size_t f = 0; f < c.facets.size(); ++f) {
    if (facet_simplex(c, f).n != c.dim + 1)
      return "facet " + to_string(facet_simplex(c, f)) + " is degenerate";
  }
  if (facet_set(c).size() != c.facets.size()) return "two facets with the same vertices";
  return {};
}

std::string curve_error(const Complex& c) {
  std::vector<int> ends;
  for (const auto& f : c.facets) ends.insert(ends.end(), f.begin(), f.begin() + 2);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 2; i < ends.size(); ++i) {
    if (ends[i] == ends[i - 2]) return "more than two edges at vertex " + std::to_string(ends[i]);
  }
  return {};
}

std::string surface_error(const Complex& c) {
  for (const EdgeUse& use : edge_uses(c)) {
    if (use.count > 2) return "edge " + to_string(use.edge) + " is in more than two facets";
  }
  const std::vector<int> pinched = pinched_vertices(glue(c));
  return pinched.empty() ? "" : "the link of vertex " + std::to_string(pinched[0]) + " is not connected";
}

}  // namespace

std::string manifold_error(const Complex& c) {
  const std::string error = facet_error(c);
  if (!error.empty() || c.dim == 0) return error;
  return c.dim == 1 ? curve_error(c) : c.dim == 2 ? surface_error(c) : solid_error(c);
}

bool is_manifold(const Complex& c) {
  return manifold_error(c).empty();
}

bool is_orientable(const Complex& c) {
  if (c.dim <= 1) return true;
  if (c.dim == 3) return is_orientable_solid(c);
  const std::vector<Region> all = regions(glue(c)).types;
  return std::all_of(all.begin(), all.end(), [](const Region& r) { return r.orientable; });
}

namespace {

Signature curve_signature(const Complex& c) {
  const std::vector<int> ends = boundary_points(c);
  // A component of a 1-manifold is an interval (two ends) or a circle (none).
  const int intervals = static_cast<int>(ends.size()) / 2;
  const int circles = number_of_components(c) - intervals;
  Signature words;
  for (int i = 0; i < circles; ++i) words.insert(words.end(), {0, 0, 1});
  for (int i = 0; i < intervals; ++i) words.insert(words.end(), {1, 2, 1});
  return words;
}

}  // namespace

Signature signature(const Complex& c) {
  if (c.dim == 3) return solid_signature(c);
  if (c.dim == 0) return {number_of_components(c)};
  return c.dim == 1 ? curve_signature(c) : signature(regions(glue(c)).types);
}

}  // namespace multimesh::oracle
