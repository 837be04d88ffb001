// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "multimesh/copy.hpp"

namespace multimesh {

/// Why an operation was refused.
enum class Check : std::uint8_t {
  none,            ///< not refused
  link_condition,  ///< L: a mesh would change its topology, or stop being a complex
  gluing,          ///< U: parts of a child's image would be glued that the child keeps apart
  placement,       ///< P: both ends must keep their place, or the caller insists on another place
  contact,         ///< C: siblings, or a child and the boundary, would come into new contact
  locked,          ///< G: both ends are locked, or a locked vertex was asked to move
  flip,            ///< a swap of an edge on a boundary, a seam or a child, or whose new edge exists
  invariant,       ///< an invariant of the algorithm refused
};

std::string_view to_string(Check check) noexcept;

/// The answer to "may this be done?": a value, not an exception.
struct Refusal {
  Check check = Check::none;
  NodeId node = NodeId::root;  ///< the mesh that refused
  std::string_view invariant;  ///< its name, if an invariant refused
  bool refused() const noexcept { return check != Check::none; }
};

struct LegalityOptions {
  /// Check (C): no new contact of siblings, or of children with the boundary of their parent. Cost: two
  /// vertex stars per mesh with children of lower dimension.
  bool contact = false;
};

/// Whether an edge may be collapsed, and which end must stay: docs/concepts.md, "When a collapse is legal".
struct CollapseVerdict {
  Refusal refusal;
  bool hold_a = false, hold_b = false;  ///< P and G: the merged vertex must be this end
  /// Strata: in some mesh this end lies in the boundary while the other is interior. Not required for
  /// legality, but a good placement respects it.
  bool prefer_a = false, prefer_b = false;
};

/// Judges collapses: L, U, P, G and, on request, C, on every mesh of the tree. U is checked for every mesh
/// with each of its descendants, not only its children: a curve below a curve that is cut at a junction could
/// be glued in the root by a collapse that glues nothing in either of the two maps. Nothing is modified. Two
/// copies of the edge in one mesh are judged independently here; the operation judges the second one again
/// after it has collapsed the first.
class Legality {
 public:
  CollapseVerdict collapse(const MultiMesh& tree, const Copies& copies, const LegalityOptions& options);

 private:
  bool link_conditions(const MultiMesh& tree, const Copies& copies, CollapseVerdict& verdict);
  bool no_gluing(const MultiMesh& tree, const Copies& copies, std::uint32_t i, NodeId below,
                 CollapseVerdict& verdict);
  bool no_contact(const MultiMesh& tree, const Copies& copies, std::uint32_t i, CollapseVerdict& verdict);
  bool unmatched(const MultiMesh& tree, std::span<const Copy> over, NodeId from, NodeId below, Dart at_end,
                 End end);
  bool link_gluing(const MultiMesh& tree, const Copy& e, NodeId below);

  DartBuffer star_, found_, unmatched_;
};

}  // namespace multimesh
