// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh_domain.hpp"

namespace multimesh {

DomainRemeshResult remesh(TetDomain& domain, const DomainRemeshOptions& options) {
  if (!domain.surface()) throw InputError("remesh: the tetrahedra have no surface");
  Embedding embedding = domain.embedding();
  lock(embedding, domain, options);
  RemeshOptions rounds = static_cast<const RemeshOptions&>(options);
  rounds.between_rounds = [&](int, std::span<Attribute* const> carried) {
    ImproveOptions improving{.target_amips = options.target_amips,
                             .max_passes = options.passes_between,
                             .confined = fixed_surface(domain)};
    improving.carried.assign(carried.begin(), carried.end());
    (void)improve(embedding, NodeId::root, improving);
  };
  DomainRemeshResult r;
  r.surface = remesh(embedding, *domain.surface(), rounds);
  r.tetrahedra = improve(embedding, NodeId::root,
                         {.target_amips = options.target_amips,
                          .max_passes = options.passes_at_end,
                          .confined = fixed_surface(domain)});
  return r;
}

}  // namespace multimesh
