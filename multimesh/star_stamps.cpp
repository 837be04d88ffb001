// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/star_stamps.hpp"

namespace multimesh {

void StarStamps::change(std::span<const Index> vertices) {
  ++last_;
  for (const Index v : vertices) {
    if (v >= stamps_.size()) stamps_.resize(v + v / 2 + 1, 0);
    Stamp& stamp = stamps_[v];
    if (stamp == last_) continue;
    if (trials_ > 0) log_.push_back({v, stamp});
    stamp = last_;
  }
}

void StarStamps::end_trial(std::size_t begin, bool is_kept) {
  for (; !is_kept && log_.size() > begin; log_.pop_back()) stamps_[log_.back().vertex] = log_.back().before;
  if (--trials_ == 0) log_.clear();
}

}  // namespace multimesh
