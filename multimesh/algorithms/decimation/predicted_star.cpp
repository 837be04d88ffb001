// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/predicted_star.hpp"

#include <algorithm>

namespace multimesh::decimation {

inline PredictedStar::Face& PredictedStar::next_face() {
  if (n_faces_ == faces_.size()) faces_.emplace_back();
  return faces_[n_faces_++];
}

void PredictedStar::read(Dart e) {
  n_faces_ = 0;
  const Dart far = mesh_.reorder(e, exchange_ends);
  sheets_.assign(1, e);
  if (reader_.ranks().has_sheets()) reader_.ranks().sheets(e, mesh_.vertex(e), mesh_.vertex(far), sheets_);
  ends_.clear();
  for (const Dart sheet : sheets_) {
    ends_.push_back({mesh_.vertex(sheet), mesh_.vertex(mesh_.reorder(sheet, exchange_ends))});
    mesh_.star(sheet, 1, star_);
    for (const Dart d : star_) {
      Face& f = next_face();
      reader_.read(d, f.before);
      f.dies = f.changes = true;
    }
  }
  n_dying_ = n_faces_;
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    const Vec3 from_first = reader_.positions()[ends_[i].a] - reader_.positions()[ends_[0].a];
    if (!was_read(ends_[i].a, i, End::a)) read_end(sheets_[i], End::a, from_first);
    if (!was_read(ends_[i].b, i, End::b))
      read_end(mesh_.reorder(sheets_[i], exchange_ends), End::b, from_first);
  }
}

// Two sheets may share an end.
bool PredictedStar::was_read(Index vertex, std::size_t sheets, End which) const {
  return std::any_of(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(sheets),
                     [&](const auto& ends) { return vertex == (which == End::a ? ends.a : ends.b); });
}

// Those over an edge have been read first: seldom more than two.
inline bool PredictedStar::is_dying(Index facet) const {
  for (std::size_t i = 2; i < n_dying_; ++i)
    if (faces_[i].before.facet == facet) return true;
  return (n_dying_ > 0 && faces_[0].before.facet == facet) ||
         (n_dying_ > 1 && faces_[1].before.facet == facet);
}

void PredictedStar::read_end(Dart end, End which, const Vec3& from_first) {
  mesh_.star(end, 0, star_);
  for (const Dart d : star_) {
    if (is_dying(mesh_.facet(d))) continue;
    Face& f = next_face();
    reader_.read(d, f.before);
    f.end = which;
    f.dies = false;
    f.from_first = from_first;
  }
}

void PredictedStar::place(const CollapsePlan& plan) {
  for (Face& f : std::span(faces_.data(), n_faces_)) {
    if (f.dies) continue;
    f.changes = plan.moves(f.end);
    f.position = f.changes ? plan.position + f.from_first : f.before.positions[0];
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
