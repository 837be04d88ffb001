// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/solid.hpp"

#include <algorithm>

#include "oracle/disjoint_sets.hpp"
#include "oracle/homology.hpp"
#include "oracle/orientation.hpp"

namespace multimesh::oracle {

namespace {

Complex surface_of(const SimplexSet& triangles) {
  Complex c{2, {}};
  for (const Simplex& s : of_dimension(triangles, 2)) c.facets.push_back({s.v[0], s.v[1], s.v[2]});
  return c;
}

std::vector<Complex> components(const Complex& c) {
  const std::vector<int> all = vertices(c);
  const auto at = [&](int v) {
    return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), v) - all.begin());
  };
  DisjointSets sets(all.size());
  for (const Facet& f : c.facets)
    for (std::size_t i = 1; i <= static_cast<std::size_t>(c.dim); ++i) sets.join(at(f[0]), at(f[i]));
  std::map<std::size_t, Complex> parts;
  for (const Facet& f : c.facets) {
    Complex& part = parts[sets.find(at(f[0]))];
    part.dim = c.dim;
    part.facets.push_back(f);
  }
  std::vector<Complex> list;
  for (auto& [v, part] : parts) list.push_back(std::move(part));
  return list;
}

}  // namespace

std::string solid_error(const Complex& c) {
  const SimplexSet all = simplices(c);
  for (const Simplex& s : of_dimension(all, 2))
    if (star(all, s).size() > 3) return "triangle " + to_string(s) + " is in more than two facets";
  for (const Simplex& v : of_dimension(all, 0)) {
    const Complex around = surface_of(link(all, v));
    const bool whole = is_manifold(around) && number_of_components(around) == 1;
    const Signature type = whole ? signature(around) : Signature{};
    if (type != Signature{2, 0, 1} && type != Signature{1, 1, 1})
      return "the link of vertex " + to_string(v) + " is neither a sphere nor a disk";
  }
  return {};
}

bool is_orientable_solid(const Complex& c) {
  Complex copy = c;
  return orient(copy);
}

Signature solid_signature(const Complex& c) {
  std::vector<Signature> types;
  for (const Complex& part : components(c)) {
    const Betti b = betti(simplices(part));
    Signature type(b.begin(), b.end());
    type.push_back(is_orientable_solid(part) ? 1 : 0);
    const Complex rim = surface_of(boundary(part));
    const Signature rims = rim.facets.empty() ? Signature{} : signature(rim);
    type.push_back(static_cast<std::int64_t>(rims.size()));
    type.insert(type.end(), rims.begin(), rims.end());
    types.push_back(std::move(type));
  }
  std::sort(types.begin(), types.end());
  Signature words;
  for (const Signature& t : types) words.insert(words.end(), t.begin(), t.end());
  return words;
}

}  // namespace multimesh::oracle
