// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remesh_domain.hpp"

namespace multimesh {

namespace {

/// With the surface as it is.
ImproveOptions of_tetrahedra(const TetDomain& domain, const DomainRemeshOptions& o, int passes) {
  ImproveOptions improving;
  improving.target_amips = o.target_amips;
  improving.max_passes = passes;
  improving.confined = {{NodeId::root, Confined::fixed}, {*domain.surface(), Confined::fixed}};
  return improving;
}

}  // namespace

DomainRemeshResult remesh(TetDomain& domain, const DomainRemeshOptions& options) {
  if (!domain.surface()) throw InputError("remesh: the tetrahedra have no surface");
  Embedding embedding = domain.embedding();
  lock(embedding, domain, options);
  RemeshOptions rounds = static_cast<const RemeshOptions&>(options);
  rounds.between_rounds = [&](int, std::span<Attribute* const> carried) {
    ImproveOptions improving = of_tetrahedra(domain, options, options.passes_between);
    improving.carried.assign(carried.begin(), carried.end());
    (void)improve(embedding, NodeId::root, improving);
  };
  DomainRemeshResult r;
  r.surface = remesh(embedding, *domain.surface(), rounds);
  r.tetrahedra = improve(embedding, NodeId::root, of_tetrahedra(domain, options, options.passes_at_end));
  return r;
}

}  // namespace multimesh
