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
  placement,       ///< P: both ends must keep their place, or the one that must not was asked to
  contact,         ///< C: siblings, or a child and the boundary, would get into new contact
  locked,          ///< G: both ends are labelled points, or a labelled point was asked to move
  flip,            ///< a swap of an edge that is on a boundary, a seam or a child, or whose flip exists
  invariant,       ///< an invariant of the algorithm said no
};

std::string_view to_string(Check check) noexcept;

/// The answer to "may this be done?": a value, not an exception.
struct Refusal {
  Check check = Check::none;
  NodeId node = NodeId::root;  ///< the mesh that refused
  std::string_view invariant;  ///< its name, if an invariant did
  bool refused() const noexcept { return check != Check::none; }
};

struct LegalityOptions {
  /// Check (C), joint topology of siblings and of children with the boundary of their parent. Costs two
  /// vertex stars per mesh with children of lower dimension.
  bool contact = false;
};

/// Whether an edge may be collapsed, and which end stays: docs/concepts.md, "When a collapse is legal".
struct CollapseVerdict {
  Refusal refusal;
  bool hold_a = false, hold_b = false;  ///< P and G: the merged vertex must be this end
  /// Strata: in some mesh this end lies in the boundary while the other is interior. Not a matter of
  /// legality; a good placement honours it.
  bool prefer_a = false, prefer_b = false;
};

/// Judges collapses: L, U, P, G and, if asked, C, on every mesh of the tree. U is asked of every mesh with
/// each of its descendants, not only its children: a curve below a curve that is cut at a junction could be
/// glued in the root by a collapse that glues nothing in either of the two maps. Nothing is modified. Two
/// copies of the edge in one mesh are judged independently here; the second one is judged again, by the
/// operation, after the first was collapsed.
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
