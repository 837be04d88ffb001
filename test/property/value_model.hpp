// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

/// The rules by which values follow operations (docs/concepts.md#values), on plain vertex sets. Shares no
/// code with the library.
namespace multimesh::test {

using Vertices = std::set<unsigned>;

/// One value per kind of rule. Not every kind is used on every kind of simplex.
struct Values {
  int carried = 0;      ///< a property that follows without a call
  int plain = 0;        ///< in a vector of the test's own, by the default rules
  unsigned flags = 0;   ///< united
  unsigned status = 0;  ///< the bits of OpenMesh's edge status
  int larger = 0;
  double mean = 0;  ///< interpolated
  double part = 0;  ///< shared out to the halves; swapped facets add twice the other's
};

/// What differs, or nullptr.
const char* difference(const Values& x, const Values& y);

constexpr int fresh_plain = -7;  ///< `plain` of new edges

struct Facet {
  std::vector<unsigned> order;  ///< its vertices as the mesh orders them, up to an even permutation
  Values values;
  std::map<unsigned, Values> corners;
};

/// A mesh with values on everything. In dimension 3 only edges and faces that were given a value have one.
struct ValueMesh {
  int dimension = 0;
  std::map<unsigned, Values> vertices;
  std::map<Vertices, Values> edges, faces;  ///< faces: of tetrahedra
  std::map<Vertices, Facet> facets;

  void split(unsigned a, unsigned b, unsigned c, double t);
  /// Merges a into b, at (1-t) a + t b. `a_wins`: the sets a-x, a-x-y that lie in a mesh below, where b-x,
  /// b-x-y do not. `taking_back`: nothing at b changes.
  void collapse(unsigned a, unsigned b, double t, const std::set<Vertices>& a_wins, bool taking_back);
  void flip(unsigned a, unsigned b, unsigned l, unsigned r);

 private:
  void merge(std::map<Vertices, Values>& all, unsigned a, unsigned b, double t,
             const std::set<Vertices>& a_wins, bool taking_back);
  void halve(std::map<Vertices, Values>& all, unsigned a, unsigned b, unsigned c, double t);
};

}  // namespace multimesh::test
