// SPDX-License-Identifier: BSD-3-Clause
#include "property/oracle_tree.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "multimesh/build.hpp"
#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/permutation.hpp"
#include "oracle/image.hpp"
#include "oracle/orientation.hpp"
#include "oracle/random_surface.hpp"

namespace multimesh::test {

namespace {

using oracle::Complex;
using oracle::Simplex;

std::size_t corners(const Complex& c) {
  return static_cast<std::size_t>(c.dim) + 1;
}

std::map<int, Index> ranks(const Complex& c) {
  std::map<int, Index> rank;
  for (const int v : vertices(c)) rank.emplace(v, static_cast<Index>(rank.size()));
  return rank;
}

FacetList facet_list(const Complex& c, const std::map<int, Index>& names) {
  FacetList list{c.dim, static_cast<Index>(names.size()), {}};
  for (const auto& f : c.facets)
    for (std::size_t i = 0; i < corners(c); ++i) list.corners.push_back(names.at(f[i]));
  return list;
}

/// A parent facet with all these vertices, any of them.
Index facet_with(const Complex& parent, const Simplex& s, std::mt19937_64& rng) {
  std::vector<Index> all;
  for (std::size_t f = 0; f < parent.facets.size(); ++f)
    if (contains(facet_simplex(parent, f), s)) all.push_back(static_cast<Index>(f));
  return all.at(oracle::pick(rng, all.size()));
}

}  // namespace

std::optional<MultiMesh> to_multimesh(const oracle::Tree& plain, std::mt19937_64& rng) {
  std::vector<Complex> meshes;
  std::vector<std::map<int, Index>> names;
  for (const oracle::TreeNode& node : plain.nodes) {
    meshes.push_back(node.mesh);
    std::function<bool()> mirror;
    if (node.parent >= 0) mirror = [&rng] { return oracle::chance(rng, 50); };
    if (!oracle::orient(meshes.back(), mirror)) return std::nullopt;
    names.push_back(ranks(node.mesh));
  }
  MultiMesh tree(make_mesh(facet_list(meshes[0], names[0])));
  for (std::size_t i = 1; i < plain.nodes.size(); ++i) {
    const oracle::TreeNode& node = plain.nodes[i];
    const auto above = static_cast<std::size_t>(node.parent);
    std::map<int, Index> images;
    for (const auto& [v, image] : node.image) images[v] = names[above].at(image);
    FacetList over = facet_list(meshes[i], images);
    over.vertices = static_cast<Index>(names[above].size());
    std::vector<Index> parents;
    for (std::size_t f = 0; f < meshes[i].facets.size(); ++f)
      parents.push_back(facet_with(meshes[above], mapped(facet_simplex(meshes[i], f), node.image), rng));
    add_child_by_facets(tree, static_cast<NodeId>(above), facet_list(meshes[i], names[i]), over, parents,
                        make_mesh);
  }
  return tree;
}

oracle::Tree to_oracle(const MultiMesh& tree) {
  oracle::Tree plain;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const NodeId n{i};
    const Mesh& mesh = tree.mesh(n);
    oracle::TreeNode node{{mesh.dimension(), {}}, i == 0 ? -1 : static_cast<int>(index(tree.parent(n))), {}};
    for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f) {
      if (!mesh.is_live(mesh.dimension(), f)) continue;
      std::array<Index, 4> own{}, image{};
      const Anchor anchor = i == 0 ? Anchor{mesh.dart_of(mesh.dimension(), f)} : mesh.anchor(f);
      mesh.vertices(anchor.own, own.data());
      if (i > 0) tree.mesh(tree.parent(n)).vertices(anchor.parent, image.data());
      oracle::Facet facet{-1, -1, -1, -1};
      for (std::size_t k = 0; k < corners(node.mesh); ++k) {
        facet[k] = static_cast<int>(own[k]);
        if (i == 0) continue;
        const auto [known, fresh] = node.image.emplace(facet[k], static_cast<int>(image[k]));
        if (!fresh && known->second != static_cast<int>(image[k]))
          throw std::logic_error("vertex " + std::to_string(facet[k]) + " of mesh " + std::to_string(i) +
                                 " has two images");
      }
      node.mesh.facets.push_back(facet);
    }
    plain.nodes.push_back(std::move(node));
  }
  return plain;
}

std::string tree_difference(const oracle::Tree& expected, const oracle::Tree& actual) {
  if (expected.nodes.size() != actual.nodes.size()) return "different numbers of meshes";
  for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
    const std::string where = "mesh " + std::to_string(i) + ": ";
    const oracle::SimplexSet want = facet_set(expected.nodes[i].mesh), have = facet_set(actual.nodes[i].mesh);
    if (actual.nodes[i].mesh.facets.size() != have.size()) return where + "two facets with the same vertices";
    for (const Simplex& f : want)
      if (!contains(have, f)) return where + "facet " + to_string(f) + " is missing";
    for (const Simplex& f : have)
      if (!contains(want, f)) return where + "facet " + to_string(f) + " should not be there";
    for (const auto& [v, image] : expected.nodes[i].image) {
      const auto found = actual.nodes[i].image.find(v);
      if (found == actual.nodes[i].image.end()) return where + "no vertex " + std::to_string(v);
      if (found->second != image)
        return where + "vertex " + std::to_string(v) + " lies over " + std::to_string(found->second) +
               " instead of " + std::to_string(image);
    }
  }
  return {};
}

oracle::Tree renamed(const oracle::Tree& tree, const Renaming& names) {
  const auto name = [&](std::size_t node, int v) {
    const auto it = names[node].find(v);
    return it == names[node].end() ? v : it->second;
  };
  oracle::Tree result = tree;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    oracle::TreeNode& node = result.nodes[i];
    for (auto& f : node.mesh.facets)
      for (std::size_t k = 0; k < corners(node.mesh); ++k) f[k] = name(i, f[k]);
    node.image.clear();
    for (const auto& [v, image] : tree.nodes[i].image)
      node.image[name(i, v)] = name(static_cast<std::size_t>(node.parent), image);
  }
  return result;
}

Dart edge_dart(const Mesh& mesh, int a, int b) {
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    if (!mesh.is_live(1, e)) continue;
    const Dart d = mesh.dart_of(1, e);
    const Dart back = mesh.reorder(d, exchange_ends);
    const auto from = static_cast<int>(mesh.vertex(d)), to = static_cast<int>(mesh.vertex(back));
    if (from == a && to == b) return d;
    if (from == b && to == a) return back;
  }
  return no_dart;
}

std::string query_difference(const MultiMesh& tree, const oracle::Tree& plain) {
  DartBuffer found;
  for (std::uint32_t i = 1; i < plain.nodes.size(); ++i) {
    const NodeId n{i}, above = tree.parent(n);
    const Mesh &mesh = tree.mesh(n), &parent = tree.mesh(above);
    const oracle::TreeNode& node = plain.nodes[i];
    for (int k = 0; k <= mesh.dimension(); ++k)
      for (Index s = 0; s < parent.capacity(k); ++s) {
        if (!parent.is_live(k, s) || parent.dart_of(k, s) == no_dart) continue;
        const Dart d = parent.dart_of(k, s);
        const auto simplex_of = [k](const Mesh& m, Dart dart) {
          std::array<Index, 4> v{};
          m.vertices(dart, v.data());
          oracle::Facet w{-1, -1, -1, -1};
          for (std::size_t j = 0; j <= static_cast<std::size_t>(k); ++j) w[j] = static_cast<int>(v[j]);
          return w;
        };
        const auto order = simplex_of(parent, d);
        found.clear();
        tree.to_child(n, d, k, found);
        oracle::SimplexSet over;
        for (const Dart e : found) {
          const auto w = simplex_of(mesh, e);
          for (std::size_t j = 0; j <= static_cast<std::size_t>(k); ++j)
            if (node.image.at(w[j]) != order[j]) return "a preimage with its vertices in another order";
          over.push_back(oracle::facet_simplex({k, {w}}, 0));
        }
        oracle::normalize(over);
        const Simplex image = oracle::facet_simplex({k, {order}}, 0);
        if (over.size() != found.size()) return "a preimage that is reported twice";
        if (over != preimages(node.mesh, node.image, image))
          return "mesh " + std::to_string(i) + ": wrong preimages of " + to_string(image);
      }
    for (const auto& [v, image] : map_to(plain, static_cast<int>(i), 0)) {
      const Dart root = tree.to_root(n, mesh.dart_of(0, static_cast<Index>(v)));
      if (static_cast<int>(tree.mesh(NodeId::root).vertex(root)) != image)
        return "mesh " + std::to_string(i) + ": wrong image of vertex " + std::to_string(v) + " in the root";
    }
  }
  return {};
}

}  // namespace multimesh::test
