// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/solid_overlay.hpp"

#include <algorithm>

#include "oracle/graph_type.hpp"
#include "oracle/homology.hpp"
#include "oracle/layer_image.hpp"

namespace multimesh::oracle {

namespace {

using Label = std::uint64_t;

Label hash_of(const Signature& words) {
  Label hash = words.size();
  for (const std::int64_t w : words) hash = mix(hash, static_cast<Label>(w));
  return hash;
}

Label type_of(const LabelledGraph& around, Label own) {
  return mix(hash_of(graph_type(around)), own);
}

/// The cut of a host along its layers, and how it looks at each of its simplices.
class SolidOverlay {
 public:
  SolidOverlay(const Complex& host, const std::vector<LayerImage>& layers, bool host_boundary)
      : layers_(layers), all_(simplices(host)), rim_(boundary(host)), on_rim_(host_boundary) {
    for (const Simplex& s : all_)
      if (is_cut(s)) cut_.push_back(s);
    cut_ = closure(cut_);
    for (const Simplex& e : of_dimension(cut_, 1)) add_edge(e);
    for (const Simplex& v : of_dimension(cut_, 0)) add_vertex(v);
  }

  Signature graph() const { return graph_type(graph_); }
  const SingularSet& singular() const { return singular_; }

  Signature regions() const {
    Signature words;
    std::vector<SimplexSet> parts;
    SimplexSet together;
    for (const LayerImage& layer : layers_) {
      parts.push_back(image_of(layer));
      together = unite(together, parts.back());
    }
    append(words, betti(together));
    append(words, betti(all_, together));
    if (on_rim_) {
      parts.push_back(rim_);
      append(words, betti(unite(together, rim_)));
      append(words, betti(all_, unite(together, rim_)));
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) append(words, betti(intersection(parts[i], parts[j])));
    return words;
  }

  Signature closures() const {
    Signature words;
    for (const LayerImage& layer : layers_) append(words, betti(image_of(layer)));
    return words;
  }

 private:
  static void append(Signature& words, const Betti& b) { words.insert(words.end(), b.begin(), b.end()); }

  SimplexSet image_of(const LayerImage& layer) const {
    SimplexSet image;
    for (const Simplex& s : all_)
      if (layer.count(s) > 0) image.push_back(s);
    return image;
  }

  bool is_cut(const Simplex& s) const {
    for (const LayerImage& layer : layers_) {
      if (layer.dim() == s.n - 1 && s.n < 4 && layer.count(s) > 0) return true;
      if (layer.dim() == 3 && s.n == 3 && is_frontier(layer, s)) return true;
    }
    return false;
  }

  bool is_frontier(const LayerImage& layer, const Simplex& triangle) const {
    const SimplexSet sides = of_dimension(star(all_, triangle), 3);
    const bool one = layer.count(sides[0]) > 0, two = sides.size() > 1 && layer.count(sides[1]) > 0;
    if (sides.size() == 1) return one && !on_rim_;  // beyond the boundary nothing is covered
    return one != two || (one && layer.count(triangle) != 1);
  }

  Label label(const Simplex& s) const {
    Label hash = on_rim_ && contains(rim_, s) ? 1 : 0;
    for (const LayerImage& layer : layers_) hash = mix(hash, static_cast<Label>(layer.count(s)));
    return hash;
  }

  /// Labels of the triangles of the cut around an edge, ascending.
  std::vector<Label> around(const Simplex& edge) const {
    std::vector<Label> labels;
    for (const Simplex& t : star(cut_, edge))
      if (t.n == 3) labels.push_back(label(t));
    std::sort(labels.begin(), labels.end());
    return labels;
  }

  static Label kind(Label own, const std::vector<Label>& triangles) {
    Label hash = mix(own, triangles.size());
    for (const Label l : triangles) hash = mix(hash, l);
    return hash;
  }

  /// How a point inside a curve of such edges looks: the triangles run from pole to pole of its link.
  static Label inside_curve(Label own, const std::vector<Label>& triangles) {
    LabelledGraph link;
    link.vertices = {{0, own}, {1, own}};
    for (const Label l : triangles) link.edges.push_back({0, 1, l, l});
    return type_of(link, own);
  }

  static Label inside_surface(Label own) {
    LabelledGraph link;
    for (int i = 0; i < 3; ++i) {
      link.vertices[i] = own;
      link.edges.push_back({i, (i + 1) % 3, own, own});
    }
    return type_of(link, own);
  }

  void add_edge(const Simplex& e) {
    const std::vector<Label> triangles = around(e);
    const Label own = label(e);
    if (triangles.size() == 2 && triangles[0] == own && triangles[1] == own) return;
    singular_.edges.push_back(e);
    graph_.edges.push_back({e.v[0], e.v[1], kind(own, triangles), inside_curve(own, triangles)});
  }

  Label type_at(const Simplex& v) const {
    LabelledGraph link;
    for (const Simplex& s : star(cut_, v)) {
      const Simplex rest = minus(s, v);
      if (rest.n == 1) link.vertices[rest.v[0]] = label(s);
      if (rest.n == 2) link.edges.push_back({rest.v[0], rest.v[1], label(s), label(s)});
    }
    return type_of(link, label(v));
  }

  void add_vertex(const Simplex& v) {
    std::vector<Label> ordinary;
    for (const LabelledEdge& e : graph_.edges)
      if (e.from == v.v[0] || e.to == v.v[0]) ordinary.push_back(e.ordinary);
    const Label type = type_at(v);
    if (ordinary.empty()) {
      if (type == inside_surface(label(v))) return;
      singular_.isolated.push_back(v.v[0]);
    } else if (ordinary.size() != 2 || ordinary[0] != ordinary[1] || type != ordinary[0]) {
      singular_.corners.push_back(v.v[0]);
    }
    graph_.vertices[v.v[0]] = type;
  }

  const std::vector<LayerImage>& layers_;
  SimplexSet all_, rim_, cut_;
  bool on_rim_;
  LabelledGraph graph_;
  SingularSet singular_;
};

}  // namespace

OverlayType solid_overlay_type(const Complex& host, const std::vector<Layer>& layers, bool host_boundary) {
  const std::vector<LayerImage> images(layers.begin(), layers.end());
  const SolidOverlay overlay(host, images, host_boundary);
  return {overlay.regions(), overlay.graph(), overlay.closures()};
}

SingularSet singular_set(const Complex& host, const std::vector<Layer>& layers, bool host_boundary) {
  const std::vector<LayerImage> images(layers.begin(), layers.end());
  return SolidOverlay(host, images, host_boundary).singular();
}

}  // namespace multimesh::oracle
