// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "multimesh/embedding.hpp"

namespace multimesh::test {

/// A domain with a surface on which an algorithm is run.
class SurfaceInDomain {
 public:
  virtual ~SurfaceInDomain() = default;
  virtual const MultiMesh& tree() const = 0;
  virtual NodeId surface() const = 0;
  virtual Embedding embedding() = 0;
  /// The position of a vertex of the surface in the domain's own data.
  virtual Vec3 place(Dart vertex) const = 0;
  /// Further conditions after an algorithm, or an empty string: what follows the positions is in its place,
  /// and nothing is inverted.
  virtual std::string fault() const = 0;
  /// Of the surface's triangles. Those here keep it but for curved parts.
  virtual double area() const;
};

/// One domain per kind; what is below it and above it is in the name.
struct DomainCase {
  const char* name;
  std::unique_ptr<SurfaceInDomain> (*make)();
  /// Tetrahedra around the surface follow, but are not improved: they limit the algorithm.
  bool in_tets = false;
  /// Curves of the surface have corners that no mesh keeps: they are rounded off.
  bool loose_corners = false;
};
inline void PrintTo(const DomainCase& c, std::ostream* out) {
  *out << c.name;
}
/// A textured surface, an attached OpenMesh mesh with texture and curve, the surface and the interfaces of
/// tetrahedra, an interface as a mesh of its own, a textured surface of tetrahedra, a tile, and the surface
/// of the material in a tile of tetrahedra.
std::vector<DomainCase> domain_cases();
std::unique_ptr<SurfaceInDomain> interface_in_tetrahedra();
std::unique_ptr<SurfaceInDomain> texture_over_tetrahedra();

/// What every algorithm must preserve: the Betti numbers of all meshes, and which faces are boundary.
struct TreeFacts {
  std::vector<std::vector<long>> betti;
  std::vector<std::size_t> boundaries;  ///< of those of dimension 1 and 2: ends or loops
  friend bool operator==(const TreeFacts&, const TreeFacts&) = default;
};
TreeFacts facts_of(const MultiMesh& tree);

/// All errors of a domain after an algorithm, or an empty string.
std::string fault_of(SurfaceInDomain& domain, const TreeFacts& before);

std::size_t live_facets(const Mesh& mesh);

/// A sentence about a tetrahedron that is not positive, by exact arithmetic that is not the library's; empty
/// if there is none.
std::string inverted_tet(const Mesh& mesh, const std::function<Vec3(Index)>& at);

}  // namespace multimesh::test
