// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Preserves the topology of a domain after its copies are joined again (TetDomain::tagged()): edges that
/// have copies stay as they are, and no two simplices get the same points.
class KeepsJoinedMesh final : public Invariant {
 public:
  /// \pre the domain is not compacted afterwards
  explicit KeepsJoinedMesh(const TetDomain& domain);
  bool before(const Event& event) override;
  /// Cost: the star of the event's vertex; where copies are near, also the stars of its copies
  bool after(const Event& event) override;

 private:
  bool has_copies_near(const DartBuffer& star) const;
  bool is_kept_around(const std::vector<Index>& copies);

  const TetDomain& domain_;
  std::map<Index, std::vector<Index>> copies_;  // vertices of the root, by their point
  DartBuffer star_;
};

}  // namespace multimesh
