// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh_domain.hpp"

namespace multimesh {

namespace {

/// `fixed`: the surface, and all else that improvement must leave as it is.
DomainRemeshResult remesh(const Embedding& embedding, NodeId tetrahedra, NodeId surface,
                          const std::vector<Confinement>& fixed, const SurfaceRemeshOptions& options) {
  const auto improving = [&](int passes) {
    return ImproveOptions{.target_amips = options.target_amips, .max_passes = passes, .confined = fixed};
  };
  RemeshOptions rounds = static_cast<const RemeshOptions&>(options);
  rounds.between_rounds = [&](int, std::span<Attribute* const> carried) {
    ImproveOptions between = improving(options.passes_between);
    between.carried.assign(carried.begin(), carried.end());
    (void)improve(embedding, tetrahedra, between);
  };
  DomainRemeshResult r;
  r.surface = remesh(embedding, surface, rounds);
  ImproveOptions at_end = improving(options.passes_at_end);
  at_end.max_growth = options.max_growth;
  r.tetrahedra = improve(embedding, tetrahedra, at_end);
  return r;
}

}  // namespace

DomainRemeshResult remesh(TetDomain& domain, const DomainRemeshOptions& options) {
  if (!domain.surface()) throw InputError("remesh: the tetrahedra have no surface");
  Embedding embedding = domain.embedding();
  lock(embedding, domain, options);
  return remesh(embedding, NodeId::root, *domain.surface(), fixed_surface(domain), options);
}

DomainRemeshResult remesh_walls(PeriodicDomain& domain, TileSides sides,
                                const SurfaceRemeshOptions& options) {
  const std::optional<NodeId> surface = domain.add_walls();
  if (!surface) throw InputError("remesh: the tetrahedra have no surface");
  return remesh(domain.embedding(sides), domain.tile(), *surface, fixed_walls(domain), options);
}

}  // namespace multimesh
