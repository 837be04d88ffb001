// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// What image_signature() compares.
struct SignatureOptions {
  bool host_boundary = true;  ///< contact of an image with the boundary of its host counts; see overlay.hpp
  bool siblings = false;      ///< also the joint type of all children of each mesh (their contacts)
};

/// One comparable statement about a tree.
struct SignaturePart {
  enum class Aspect { kMesh, kRegions, kGraph, kClosure };
  Aspect aspect = Aspect::kMesh;
  int node = 0;   ///< the mesh whose image it is; -1: all children of the host together
  int host = -1;  ///< the ancestor it lies in; -1 for the mesh itself
  Signature words;

  friend bool operator==(const SignaturePart&, const SignaturePart&) = default;
};

/// All statements about a tree. Equal before and after an operation means: every mesh has kept its
/// homeomorphism type, and every image in its parent, the root and the ancestors between has kept its type,
/// that of its complement, its seam graph and its singular points (as exactly as overlay.hpp and
/// graph_type.hpp say).
struct TreeSignature {
  std::vector<SignaturePart> parts;

  friend bool operator==(const TreeSignature&, const TreeSignature&) = default;
};

/// \pre tree_error(tree) is empty
TreeSignature image_signature(const Tree& tree, const SignatureOptions& options = {});

/// "graph of node 2 in node 0; ..." for all parts that differ; empty when equal.
std::string difference(const TreeSignature& before, const TreeSignature& after);

}  // namespace multimesh::oracle
