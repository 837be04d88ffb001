// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <set>

#include "multimesh/algorithms/domain_locks.hpp"
#include "multimesh/domains/tet_domain.hpp"

namespace multimesh::test {

/// The triangles with a tag, by their points.
std::set<std::array<std::array<double, 3>, 3>> triangles_of_patch(const TaggedTetrahedra& t,
                                                                  TetDomain::Tag tag);

/// An algorithm on the surface of tetrahedra, such that it changes much of the box of make_box({}).
using OnDomain = std::function<void(TetDomain& domain, const DomainLocks& locks)>;

/// What every such algorithm must do.
void expect_locked_patches_keep_their_triangles(const OnDomain& run);
void expect_locked_regions_keep_their_tetrahedra(const OnDomain& run);
void expect_required_triangles_stay(const OnDomain& run);
void expect_a_domain_without_surface_is_refused(const OnDomain& run);
void expect_the_same_twice(const OnDomain& run);

/// Solids of cubes or single tetrahedra that touch themselves in points and edges stay what they are when
/// joined again. `run` tells whether it has changed something. \param tolerance of areas and volumes
void expect_solids_stay_what_they_are(const std::function<bool(TetDomain& domain, unsigned seed)>& run,
                                      double tolerance, std::size_t least_changed);

}  // namespace multimesh::test
