// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/overlay.hpp"

#include <algorithm>
#include <cstdint>

#include "oracle/gluing.hpp"
#include "oracle/graph_type.hpp"
#include "oracle/layer_image.hpp"
#include "oracle/solid_overlay.hpp"

namespace multimesh::oracle {

namespace {

/// Closes every boundary loop of a surface with a cone, each with its own apex.
Complex capped(const Complex& host) {
  Complex closed = host;
  SimplexSet rim = of_dimension(boundary(host), 1);
  for (int apex = kOmega; !rim.empty(); ++apex) {
    std::vector<int> reached{rim[0].v[0]};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const Simplex& e : rim) {
        if (contains(e, reached[i])) {
          closed.facets.push_back({e.v[0], e.v[1], apex});
          reached.push_back(e.v[0] == reached[i] ? e.v[1] : e.v[0]);
        }
      }
      std::erase_if(rim, [&](const Simplex& e) { return contains(e, reached[i]); });
    }
  }
  return closed;
}

/// Lengthens a curve at each end by an edge that no layer covers.
Complex lengthened(const Complex& host) {
  Complex longer = host;
  int fresh = kOmega;
  for (int end : boundary_points(host)) longer.facets.push_back({end, fresh++, -1});
  return longer;
}

/// One overlay on a surface: cuts, regions, graph.
class SurfaceOverlay {
 public:
  SurfaceOverlay(const Complex& host, const std::vector<LayerImage>& layers, bool mark_boundary)
      : layers_(layers), uses_(edge_uses(host)), covered_(host.facets.size(), 0) {
    for (std::size_t f = 0; f < host.facets.size(); ++f) covered_[f] = cover(facet_simplex(host, f));
    SimplexSet cuts;
    for (const EdgeUse& use : uses_) {
      if (is_cut(use)) cuts.push_back(use.edge);
      if (mark_boundary && use.count == 1) rim_.insert(rim_.end(), {use.edge.v[0], use.edge.v[1]});
    }
    std::sort(rim_.begin(), rim_.end());
    regions_ = oracle::regions(glue(host, uses_, cuts));
    region_cover_.assign(regions_.types.size(), 0);
    for (std::size_t f = 0; f < covered_.size(); ++f) region_cover_[region_of(f)] = covered_[f];
    for (const EdgeUse& use : uses_) {
      if (contains(cuts, use.edge)) add_edge(use, mark_boundary && use.count == 1);
    }
    for (std::size_t f = 0; f < host.facets.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) add_point(host.facets[f][i], f);
  }

  Signature regions() const {
    std::vector<std::uint64_t> codes;
    for (std::size_t r = 0; r < regions_.types.size(); ++r) codes.push_back(code(r));
    std::sort(codes.begin(), codes.end());
    return Signature(codes.begin(), codes.end());
  }

  Signature graph() const { return graph_type(graph_); }

 private:
  std::uint64_t cover(const Simplex& facet) const {
    std::uint64_t mask = 0;
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      if (layers_[l].dim() == 2 && layers_[l].count(facet) > 0) mask |= std::uint64_t{1} << l;
    }
    return mask;
  }

  bool is_cut(const EdgeUse& use) const {
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      const int preimages = layers_[l].count(use.edge);
      if (layers_[l].dim() == 1 && preimages > 0) return true;
      if (layers_[l].dim() < 2 || use.count != 2) continue;
      const bool one = covered_[static_cast<std::size_t>(use.facet[0])] >> l & 1;
      const bool two = covered_[static_cast<std::size_t>(use.facet[1])] >> l & 1;
      if (one != two || (one && preimages != 1)) return true;
    }
    return false;
  }

  std::size_t region_of(std::size_t facet) const {
    return static_cast<std::size_t>(regions_.of_facet[facet]);
  }

  /// (Euler characteristic, loops, orientable, cover) of a region in one readable word.
  std::uint64_t code(std::size_t r) const {
    const Region& type = regions_.types[r];
    const auto euler = static_cast<std::uint64_t>(type.euler + 500);
    return ((euler * 1000 + static_cast<std::uint64_t>(type.loops)) * 10 + (type.orientable ? 1 : 0)) * 1000 +
           region_cover_[r];
  }

  /// Label of a simplex: preimages per layer, and whether it lies on the boundary of the host.
  std::uint64_t label(const Simplex& s, bool on_boundary) const {
    std::uint64_t hash = on_boundary ? 1 : 0;
    for (const LayerImage& layer : layers_) hash = mix(hash, static_cast<std::uint64_t>(layer.count(s)));
    return hash;
  }

  void add_edge(const EdgeUse& use, bool on_boundary) {
    std::array<std::uint64_t, 2> sides{0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
      if (use.facet[i] >= 0) sides[i] = code(region_of(static_cast<std::size_t>(use.facet[i])));
    }
    std::sort(sides.begin(), sides.end());
    const std::uint64_t ordinary = label(use.edge, on_boundary);
    const std::uint64_t kind = mix(mix(ordinary, sides[0]), sides[1]);
    graph_.edges.push_back({use.edge.v[0], use.edge.v[1], kind, ordinary});
    for (std::size_t i = 0; i < 2; ++i) {
      const int v = use.edge.v[i];
      const bool on_rim = std::binary_search(rim_.begin(), rim_.end(), v);
      graph_.vertices[v] = label(simplex({v}), on_rim);
    }
  }

  /// A vertex of a facet that lies under a point and on no cut edge.
  void add_point(int v, std::size_t facet) {
    const Simplex point = simplex({v});
    const bool covered = std::any_of(layers_.begin(), layers_.end(), [&](const LayerImage& layer) {
      return layer.dim() == 0 && layer.count(point) > 0;
    });
    if (!covered || graph_.vertices.contains(v)) return;
    const bool on_rim = std::binary_search(rim_.begin(), rim_.end(), v);
    graph_.vertices[v] = mix(label(point, on_rim), code(region_of(facet)));
  }

  const std::vector<LayerImage>& layers_;
  std::vector<EdgeUse> uses_;
  std::vector<std::uint64_t> covered_;  // per facet, bit l: layer l covers it
  std::vector<int> rim_;                // boundary vertices, sorted
  Regions regions_;
  std::vector<std::uint64_t> region_cover_;
  LabelledGraph graph_;
};

/// Type of the image of a surface layer as a complex of its own: normalization, and copies of pinched
/// vertices.
Signature closure_type(const Complex& host, const LayerImage& layer) {
  Complex image{2, {}};
  for (std::size_t f = 0; f < host.facets.size(); ++f) {
    if (layer.count(facet_simplex(host, f)) > 0) image.facets.push_back(host.facets[f]);
  }
  const Gluing glued = glue(image);
  Signature words = signature(oracle::regions(glued).types);
  std::map<int, std::int64_t> copies;
  for (const auto& [vertex, copy] : vertex_copies(glued)) ++copies[vertex];
  Signature pinches;
  for (const auto& [vertex, number] : copies) {
    if (number > 1) pinches.push_back(number);
  }
  std::sort(pinches.begin(), pinches.end());
  words.push_back(-1);  // separates the two lists
  words.insert(words.end(), pinches.begin(), pinches.end());
  return words;
}

Signature curve_graph(const Complex& host, const std::vector<LayerImage>& layers) {
  LabelledGraph graph;
  const auto label = [&](const Simplex& s) {
    std::uint64_t hash = 0;
    for (const LayerImage& layer : layers) hash = mix(hash, static_cast<std::uint64_t>(layer.count(s)));
    return hash;
  };
  for (const Simplex& s : simplices(host)) {
    if (s.n == 1) {
      graph.vertices[s.v[0]] = label(s);
    } else {
      graph.edges.push_back({s.v[0], s.v[1], label(s), label(s)});
    }
  }
  return graph_type(graph);
}

}  // namespace

OverlayType overlay_type(const Complex& host, const std::vector<Layer>& layers, bool host_boundary) {
  if (host.dim == 3) return solid_overlay_type(host, layers, host_boundary);
  const std::vector<LayerImage> images(layers.begin(), layers.end());
  OverlayType type;
  if (host.dim <= 1) {
    type.graph = curve_graph(host_boundary ? host : lengthened(host), images);
    return type;
  }
  const SurfaceOverlay overlay(host_boundary ? host : capped(host), images, host_boundary);
  type.regions = overlay.regions();
  type.graph = overlay.graph();
  for (const LayerImage& layer : images) {
    if (layer.dim() != 2) continue;
    const Signature words = closure_type(host, layer);
    type.closures.push_back(static_cast<std::int64_t>(words.size()));
    type.closures.insert(type.closures.end(), words.begin(), words.end());
  }
  return type;
}

}  // namespace multimesh::oracle
