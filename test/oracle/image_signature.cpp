// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/image_signature.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/image.hpp"
#include "oracle/overlay.hpp"

namespace multimesh::oracle {

namespace {

using Aspect = SignaturePart::Aspect;

void append(TreeSignature& signature, int node, int host, OverlayType type) {
  signature.parts.push_back({Aspect::kRegions, node, host, std::move(type.regions)});
  signature.parts.push_back({Aspect::kGraph, node, host, std::move(type.graph)});
  signature.parts.push_back({Aspect::kClosure, node, host, std::move(type.closures)});
}

void append_images(TreeSignature& signature, const Tree& tree, int node, const SignatureOptions& options) {
  const Complex& mesh = tree.nodes[static_cast<std::size_t>(node)].mesh;
  int host = node;
  while ((host = tree.nodes[static_cast<std::size_t>(host)].parent) >= 0) {
    const Complex& in = tree.nodes[static_cast<std::size_t>(host)].mesh;
    append(signature, node, host,
           overlay_type(in, {{&mesh, map_to(tree, node, host)}}, options.host_boundary));
  }
}

void append_siblings(TreeSignature& signature, const Tree& tree, int host, const SignatureOptions& options) {
  std::vector<Layer> layers;
  for (const TreeNode& node : tree.nodes) {
    if (node.parent == host) layers.push_back({&node.mesh, node.image});
  }
  if (layers.size() < 2) return;
  append(signature, -1, host,
         overlay_type(tree.nodes[static_cast<std::size_t>(host)].mesh, layers, options.host_boundary));
}

std::string name(const SignaturePart& part) {
  static const std::array<const char*, 4> kNames{"type", "regions", "graph", "closure"};
  std::string text = kNames[static_cast<std::size_t>(part.aspect)];
  text += part.node < 0 ? " of the children" : " of node " + std::to_string(part.node);
  if (part.host >= 0) text += " in node " + std::to_string(part.host);
  return text;
}

}  // namespace

TreeSignature image_signature(const Tree& tree, const SignatureOptions& options) {
  TreeSignature result;
  for (int node = 0; node < static_cast<int>(tree.nodes.size()); ++node) {
    const Complex& mesh = tree.nodes[static_cast<std::size_t>(node)].mesh;
    result.parts.push_back({Aspect::kMesh, node, -1, signature(mesh)});
    append_images(result, tree, node, options);
    if (options.siblings) append_siblings(result, tree, node, options);
  }
  return result;
}

std::string difference(const TreeSignature& before, const TreeSignature& after) {
  if (before.parts.size() != after.parts.size()) return "different trees";
  std::string text;
  for (std::size_t i = 0; i < before.parts.size(); ++i) {
    if (before.parts[i] == after.parts[i]) continue;
    if (!text.empty()) text += "; ";
    text += name(before.parts[i]);
  }
  return text;
}

}  // namespace multimesh::oracle
