// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/predicted_star.hpp"

#include <algorithm>

namespace multimesh::decimation {

PredictedStar::Face& PredictedStar::next_face() {
  if (n_faces_ == faces_.size()) faces_.emplace_back();
  return faces_[n_faces_++];
}

void PredictedStar::read(Dart e) {
  n_faces_ = 0;
  const Dart at_b = root_.reorder(e, exchange_ends);
  root_.star(e, 1, star_);
  for (const Dart d : star_) {
    Face& f = next_face();
    reader_.read(d, f.before);
    f.dies = f.changes = true;
  }
  read_end(e, root_.vertex(at_b), End::a);
  read_end(at_b, root_.vertex(e), End::b);
}

void PredictedStar::read_end(Dart end, Index other, End which) {
  root_.star(end, 0, star_);
  for (const Dart d : star_) {
    Face& f = next_face();
    reader_.read(d, f.before);
    if (f.before.vertices[1] == other || f.before.vertices[2] == other) {
      --n_faces_;
      continue;
    }
    f.end = which;
    f.dies = false;
  }
}

void PredictedStar::place(const CollapsePlan& plan) {
  for (Face& f : std::span(faces_.data(), n_faces_)) {
    if (f.dies) continue;
    f.changes = plan.moves(f.end);
    f.position = f.changes ? plan.position : f.before.positions[0];
    for (std::size_t k = 0; k < n_sets(); ++k) {
      const SurfaceTriangle::Textured& set = f.before.sets[k];
      if (set.facet == no_index) continue;
      f.texcoords[k] = set.texcoords[0];
      for (const CollapsePlan::Copy& c : plan.copies())
        if (c.set == k && set.vertices[0] == (f.end == End::a ? c.a : c.b)) f.texcoords[k] = c.texcoord;
    }
  }
}

}  // namespace multimesh::decimation
