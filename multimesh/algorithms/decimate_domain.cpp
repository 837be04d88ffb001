// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimate_domain.hpp"

#include <algorithm>

namespace multimesh {

namespace {

/// The greatest length of an edge of a surface.
double longest_edge(const EmbeddedMesh& surface) {
  const Mesh& mesh = surface.mesh();
  const auto at = [&](Dart d) { return surface.positions().at(mesh.vertex(d)); };
  double longest = 0;
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    if (!mesh.is_live(1, e)) continue;
    const Dart d = mesh.dart_of(1, e);
    longest = std::max(longest, (at(d) - at(mesh.reorder(d, exchange_ends))).norm());
  }
  return longest;
}

/// `fixed`: the surface, and all else that improvement must leave as it is.
DomainDecimateResult decimate(const Embedding& embedding, NodeId tetrahedra, NodeId surface,
                              const std::vector<Confinement>& fixed, const SurfaceDecimateOptions& options) {
  const auto improving = [&](int passes) {
    return ImproveOptions{.target_amips = options.target_amips, .max_passes = passes, .confined = fixed};
  };
  DecimateOptions rounds = static_cast<const DecimateOptions&>(options);
  if (options.passes_between > 0)
    rounds.between_rounds = [&](std::span<Attribute* const> carried) {
      ImproveOptions between = improving(options.passes_between);
      between.edge_length = longest_edge(EmbeddedMesh(embedding, surface));
      between.carried.assign(carried.begin(), carried.end());
      (void)improve(embedding, tetrahedra, between);
    };
  DomainDecimateResult r;
  r.surface = decimate(embedding, surface, rounds);
  if (options.passes_at_end > 0) {
    ImproveOptions at_end = improving(options.passes_at_end);
    at_end.max_growth = options.max_growth;
    r.tetrahedra = improve(embedding, tetrahedra, at_end);
  }
  return r;
}

}  // namespace

DomainDecimateResult decimate(TetDomain& domain, const DomainDecimateOptions& options) {
  if (!domain.surface()) throw InputError("decimate: the tetrahedra have no surface");
  Embedding embedding = domain.embedding();
  lock(embedding, domain, options);
  return decimate(embedding, NodeId::root, *domain.surface(), fixed_surface(domain), options);
}

DomainDecimateResult decimate(PeriodicDomain& domain, TileSides sides,
                              const SurfaceDecimateOptions& options) {
  if (domain.tree().mesh(domain.tile()).dimension() == 2)
    return {decimate(domain.embedding(sides), domain.tile(), options), {}};
  const std::optional<NodeId> surface = domain.add_walls();
  if (!surface) throw InputError("decimate: the tetrahedra have no surface");
  return decimate(domain.embedding(sides), domain.tile(), *surface, fixed_walls(domain), options);
}

}  // namespace multimesh
