// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimate_domain.hpp"

#include <algorithm>

namespace multimesh {

namespace {

/// The greatest length of an edge of the surface.
double longest_edge(const TetDomain& domain) {
  const Mesh& surface = domain.tree().mesh(*domain.surface());
  double longest = 0;
  const auto at = [&](Dart d) {
    return domain.points()[domain.mesh().vertex(domain.tree().to_root(*domain.surface(), d))];
  };
  for (Index e = 0; e < surface.capacity(1); ++e) {
    if (!surface.is_live(1, e)) continue;
    const Dart d = surface.dart_of(1, e);
    longest = std::max(longest, (at(d) - at(surface.reorder(d, exchange_ends))).norm());
  }
  return longest;
}

}  // namespace

DomainDecimateResult decimate(TetDomain& domain, const DomainDecimateOptions& options) {
  if (!domain.surface()) throw InputError("decimate: the tetrahedra have no surface");
  Embedding embedding = domain.embedding();
  lock(embedding, domain, options);
  DecimateOptions rounds = static_cast<const DecimateOptions&>(options);
  if (options.passes_between > 0)
    rounds.between_rounds = [&](std::span<Attribute* const> carried) {
      ImproveOptions improving{.target_amips = options.target_amips,
                               .max_passes = options.passes_between,
                               .confined = fixed_surface(domain)};
      improving.edge_length = longest_edge(domain);
      improving.carried.assign(carried.begin(), carried.end());
      // Places of the other embedding are prescribed by decimation meanwhile.
      Embedding inside = domain.embedding();
      lock(inside, domain, options);
      (void)improve(inside, NodeId::root, improving);
    };
  DomainDecimateResult r;
  r.surface = decimate(embedding, *domain.surface(), rounds);
  if (options.passes_at_end > 0)
    r.tetrahedra = improve(embedding, NodeId::root,
                           {.target_amips = options.target_amips,
                            .max_passes = options.passes_at_end,
                            .confined = fixed_surface(domain)});
  return r;
}

}  // namespace multimesh
