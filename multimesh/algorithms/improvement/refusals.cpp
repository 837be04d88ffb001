// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/refusals.hpp"

#include <bit>

namespace multimesh::improvement {

Refusals::Refusals(std::size_t tets) {
  constexpr std::size_t least = std::size_t{1} << 12U, most = std::size_t{1} << 20U;
  const std::size_t size = std::bit_ceil(std::clamp(8 * tets, least, most));
  table_.resize(size);
  shift_ = 64U - static_cast<unsigned>(std::countr_zero(size));
}

void Refusals::change(Layer layer, Index v) {
  std::vector<State>& states = states_[static_cast<std::size_t>(layer)];
  if (v >= states.size()) states.resize(v + v / 2 + 1, 0);
  if (states[v] == last_) return;
  if (depth_ > 0) log_.push_back({layer, v, states[v]});
  states[v] = last_;
}

void Refusals::change(const std::vector<Index>& vertices, bool surface) {
  ++last_;
  for (const Index v : vertices) {
    change(Layer::star, v);
    if (surface) change(Layer::surface, v);
  }
}

std::size_t Refusals::begin_trial() {
  ++depth_;
  return log_.size();
}

void Refusals::end_trial(std::size_t begin, bool undone) {
  for (; undone && log_.size() > begin; log_.pop_back()) {
    const Change& c = log_.back();
    states_[static_cast<std::size_t>(c.layer)][c.vertex] = c.before;
  }
  if (--depth_ == 0) log_.clear();
}

}  // namespace multimesh::improvement
