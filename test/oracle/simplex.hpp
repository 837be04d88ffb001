// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <compare>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace multimesh::oracle {

/// A simplex of dimension 0..3: its distinct vertices in ascending order; v[n..] is 0.
struct Simplex {
  int n = 0;  ///< number of vertices, dimension + 1
  std::array<int, 4> v{};

  friend bool operator==(const Simplex& s, const Simplex& t) {
    return s.n == t.n && s.v[0] == t.v[0] && s.v[1] == t.v[1] && s.v[2] == t.v[2] && s.v[3] == t.v[3];
  }

  /// By dimension, then by vertices.
  friend std::strong_ordering operator<=>(const Simplex& s, const Simplex& t) {
    if (s.n != t.n) return s.n <=> t.n;
    if (s.v[0] != t.v[0]) return s.v[0] <=> t.v[0];
    if (s.v[1] != t.v[1]) return s.v[1] <=> t.v[1];
    if (s.v[2] != t.v[2]) return s.v[2] <=> t.v[2];
    return s.v[3] <=> t.v[3];
  }
};

/// A set of simplices: sorted, without duplicates. The empty simplex is never a member.
using SimplexSet = std::vector<Simplex>;

/// The simplex on these vertices, in any order and with repetitions (which are dropped). At most 4 distinct.
/// \throw std::logic_error with more than 4 distinct vertices
Simplex simplex(std::initializer_list<int> vertices);

bool contains(const Simplex& s, int vertex);
/// Whether `face` is a face of `s` (a subset; improper included).
bool contains(const Simplex& s, const Simplex& face);
bool contains(const SimplexSet& set, const Simplex& s);

/// s with one more vertex, or s if it has that vertex.
Simplex joined(Simplex s, int vertex);

/// s without the vertices of t.
Simplex minus(const Simplex& s, const Simplex& t);

/// Sorts and removes duplicates: makes any list of simplices a set.
void normalize(SimplexSet& list);

/// The simplices together with all their non-empty faces.
SimplexSet closure(const SimplexSet& list);

SimplexSet intersection(const SimplexSet& a, const SimplexSet& b);
SimplexSet unite(const SimplexSet& a, const SimplexSet& b);

/// The members with dimension k.
SimplexSet of_dimension(const SimplexSet& set, int k);

/// The image of s when each vertex v goes to map.at(v); degenerate images are smaller simplices.
/// \throw std::out_of_range when a vertex has no image
Simplex mapped(const Simplex& s, const std::map<int, int>& map);

/// "{1 2 3}", for messages.
std::string to_string(const Simplex& s);

}  // namespace multimesh::oracle
