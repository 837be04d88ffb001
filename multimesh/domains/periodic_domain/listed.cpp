// SPDX-License-Identifier: BSD-3-Clause
// What a tile lists, and the interfaces between its regions, as meshes below the root: on the sides, both
// copies of a face are one there.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

#include "multimesh/domains/periodic_domain/domain_data.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

using Key = std::array<std::uint64_t, 3>;

Key key_of(std::span<const Index> corners) {
  Key key{};
  for (std::size_t i = 0; i < corners.size(); ++i) key[i] = std::uint64_t{corners[i]} + 1;
  std::ranges::sort(key);
  return key;
}

/// Numbers for labels; 0 for that of simplices that are not listed.
class Numbers {
 public:
  explicit Numbers(std::vector<PeriodicLabel>& labels) : labels_(labels) { labels_.assign(1, {}); }
  Index operator()(PeriodicLabel label) {
    std::ranges::sort(label.copies);
    if (label.copies.empty()) return 0;
    const auto [entry, is_new] = number_.try_emplace(label, static_cast<Index>(labels_.size()));
    if (is_new) labels_.push_back(std::move(label));
    return entry->second;
  }

 private:
  std::vector<PeriodicLabel>& labels_;
  std::map<PeriodicLabel, Index> number_;
};

/// What is around an edge of the root: faces of the mesh of faces, and of the boundary.
struct AroundEdge {
  int faces = 0, of_mesh = 0;
  Index low = no_index, high = 0;  // of their labels
  double bend = 0;                 // of the surface, if there are two
  Vec3 first_inward{};

  /// `inward`: across the face, away from the edge.
  void add(Index label, bool is_of_mesh, const Vec3& inward) {
    if (faces == 0) first_inward = inward;
    if (faces == 1)
      bend = std::numbers::pi - std::atan2(cross(first_inward, inward).norm(), dot(first_inward, inward));
    ++faces, of_mesh += is_of_mesh;
    low = std::min(low, label), high = std::max(high, label);
  }
  bool is_curve(double feature_angle) const {
    return faces == 2 ? (of_mesh > 0 && low != high) || bend >= feature_angle : of_mesh > 0;
  }
  /// Curves end where this changes.
  std::array<Index, 4> kind(Index label) const {
    return {static_cast<Index>(faces), faces == 2 ? low : 0, faces == 2 ? high : 0, label};
  }
};

class Lister {
 public:
  using Data = PeriodicDomain::Data;

  Lister(Data& data, const PeriodicTile& input)
      : data_(data),
        input_(input),
        root_(data.tree.mesh(NodeId::root)),
        tile_(data.tree.mesh(data.tile)),
        number_(data.labels) {}

  void run() {
    const int d = root_.dimension();
    for (int k = 0; k < d; ++k) find(k);
    if (data_.interfaces) find_interfaces();
    if (d == 3) find_curves();
    if (d == 2 && may_have_corners()) find_boundary();
    for (int k = 0; k < d; ++k) add(k, ends(k));
  }

 private:
  std::vector<Index>& labels(int k) { return label_[static_cast<std::size_t>(k)]; }
  std::vector<bool>& wanted(int k) { return wanted_[static_cast<std::size_t>(k)]; }

  /// The labels of all k-simplices of the root.
  void find(int k) {
    const auto& listed = input_.listed[static_cast<std::size_t>(k)];
    labels(k).assign(root_.capacity(k), 0);
    wanted(k).assign(root_.capacity(k), false);
    std::unordered_map<Key, Index, ArrayHash> given;
    for (Index i = 0; i < listed.simplices.size(); ++i) given[key_of(listed.simplices.facet(i))] = i;
    if (given.empty()) return;
    std::vector<bool> found(listed.simplices.size(), false);
    for (Index s = 0; s < root_.capacity(k); ++s) {
      if (!root_.is_live(k, s) || root_.dart_of(k, s) == no_dart) continue;
      labels(k)[s] = number_(label_of(k, root_.dart_of(k, s), given, found));
      wanted(k)[s] = labels(k)[s] != 0;
    }
    for (const auto& [key, i] : given) data_.report.missing_listed += !found[i];
  }

  PeriodicLabel label_of(int k, Dart simplex, const std::unordered_map<Key, Index, ArrayHash>& given,
                         std::vector<bool>& found) {
    copies_.clear();
    data_.tree.to_child(data_.tile, simplex, k, copies_);
    const auto offset = [&](Dart copy) { return (*data_.offsets)[tile_.vertex(copy)]; };
    LatticeVector least = offset(copies_[0]);
    for (const Dart c : copies_) least = std::min(least, offset(c));
    PeriodicLabel label;
    for (const Dart c : copies_) {
      Index v[4];
      tile_.vertices(c, v);
      for (int i = 0; i <= k; ++i) v[i] = data_.input_vertices[v[i]];
      const auto at = given.find(key_of({v, static_cast<std::size_t>(k) + 1}));
      if (at == given.end()) continue;
      found[at->second] = true;
      label.copies.push_back(
          {offset(c) - least, input_.listed[static_cast<std::size_t>(k)].tags[at->second]});
    }
    return label;
  }

  PeriodicTile::Region region_of(Dart root_facet) {
    copies_.clear();
    data_.tree.to_child(data_.tile, root_facet, root_.dimension(), copies_);
    return data_.region(tile_.facet(copies_.front()));
  }
  void find_interfaces() {
    if (std::ranges::adjacent_find(data_.regions, std::ranges::not_equal_to{}) == data_.regions.end()) return;
    const int k = root_.dimension() - 1;
    DartBuffer cofacets;
    for (Index s = 0; s < root_.capacity(k); ++s) {
      if (!root_.is_live(k, s)) continue;
      root_.star(root_.dart_of(k, s), k, cofacets);
      if (cofacets.size() == 2 && region_of(cofacets[0]) != region_of(cofacets[1])) wanted(k)[s] = true;
    }
  }

  void find_curves() {
    around_.assign(root_.capacity(1), {});
    for (Index s = 0; s < root_.capacity(2); ++s) {
      if (!root_.is_live(2, s)) continue;
      const Dart d = root_.dart_of(2, s);
      if (!wanted(2)[s] && !root_.is_boundary(d, 2)) continue;
      for (const Dart e : {d, root_.reorder(d, permutation(1, 2, 0)), root_.reorder(d, permutation(0, 2, 1))})
        around_[root_.simplex(e, 1)].add(labels(2)[s], wanted(2)[s], inward(e));
    }
    for (Index e = 0; e < around_.size(); ++e)
      if (around_[e].is_curve(data_.feature_angle)) wanted(1)[e] = true;
  }

  /// Orthogonal to the edge of a face of the root, in the tile.
  Vec3 inward(Dart face) {
    copies_.clear();
    data_.tree.to_child(data_.tile, face, 2, copies_);
    Index v[4];
    tile_.vertices(copies_.front(), v);
    const auto& p = *data_.positions;
    const Vec3 along = (p[v[1]] - p[v[0]]).unit_or_zero(), to_corner = p[v[2]] - p[v[0]];
    return to_corner - along * dot(to_corner, along);
  }

  bool may_have_corners() const { return data_.interfaces && data_.corner_angle < std::numbers::pi; }
  void find_boundary() {
    for (Index s = 0; s < root_.capacity(1); ++s)
      if (root_.is_live(1, s) && root_.is_boundary(root_.dart_of(1, s), 1)) wanted(1)[s] = true;
  }
  /// From the first end of an edge of the root to the second one, in the tile.
  Vec3 direction(Dart edge) {
    copies_.clear();
    data_.tree.to_child(data_.tile, edge, 1, copies_);
    Index v[4];
    tile_.vertices(copies_.front(), v);
    return ((*data_.positions)[v[1]] - (*data_.positions)[v[0]]).unit_or_zero();
  }
  void add_corners(std::vector<bool>& ends) {
    std::vector<std::vector<Vec3>> out(root_.capacity(0));
    for (Index e = 0; e < root_.capacity(1); ++e) {
      if (!wanted(1)[e]) continue;
      const Dart d = root_.dart_of(1, e);
      const Vec3 along = direction(d);
      out[root_.vertex(d)].push_back(along);
      out[root_.vertex(root_.reorder(d, exchange_ends))].push_back(-along);
    }
    for (Index v = 0; v < out.size(); ++v)
      if (out[v].size() == 2) {
        const double cosine = -dot(out[v][0], out[v][1]), sine = cross(out[v][0], out[v][1]).norm();
        if (std::atan2(sine, cosine) >= data_.corner_angle) ends[v] = true;
      }
  }

  /// Vertices of the root where curves end because their kind changes, or they bend.
  std::vector<bool> ends(int k) {
    if (k != 1) return {};
    std::vector<std::set<std::array<Index, 4>>> kinds(root_.capacity(0));
    for (Index e = 0; e < root_.capacity(1); ++e) {
      if (!wanted(1)[e]) continue;
      Index v[4];
      root_.vertices(root_.dart_of(1, e), v);
      const AroundEdge around = around_.empty() ? AroundEdge{} : around_[e];
      for (int i = 0; i < 2; ++i) kinds[v[i]].insert(around.kind(labels(1)[e]));
    }
    std::vector<bool> ends;
    for (const auto& of_vertex : kinds) ends.push_back(of_vertex.size() > 1);
    if (root_.dimension() == 2 && may_have_corners()) add_corners(ends);
    return ends;
  }

  // The child's facets are in the order in which the simplices are asked for.
  void add(int k, const std::vector<bool>& ends) {
    std::vector<Index> list;
    for (Index s = 0; s < wanted(k).size(); ++s)
      if (wanted(k)[s]) list.push_back(labels(k)[s]);
    if (list.empty()) return;
    CutOptions options;
    if (!ends.empty()) options.ends_at = [&](Index v) { return ends[v]; };
    auto& made = data_.listed[static_cast<std::size_t>(k)];
    made.node = add_child_from_tags(
        data_.tree, NodeId::root, k, [&](Index s) { return wanted(k)[s]; }, make_mesh, options);
    made.label = &data_.tree.mesh(*made.node).add_values<Index>(k, "periodic:label");
    std::ranges::copy(list, made.label->begin());
  }

  Data& data_;
  const PeriodicTile& input_;
  const Mesh& root_;
  const Mesh& tile_;
  Numbers number_;
  std::array<std::vector<Index>, 3> label_;  // by dimension and simplex of the root
  std::array<std::vector<bool>, 3> wanted_;
  std::vector<AroundEdge> around_;  // by edge of the root
  DartBuffer copies_;
};

}  // namespace

void PeriodicDomain::Data::add_listed(const PeriodicTile& input, const PeriodicOptions& options) {
  interfaces = options.interfaces;
  corner_angle = options.corner_angle, feature_angle = options.feature_angle;
  const bool any = std::ranges::any_of(input.listed, [](const auto& l) { return !l.tags.empty(); });
  if (any || interfaces || feature_angle < std::numbers::pi) Lister(*this, input).run();
}

}  // namespace multimesh
