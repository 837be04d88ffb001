// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// Per vertex of a mesh, a number for the current state of its star. The same number means the same star:
/// what was refused then need not be asked again. Whoever changes the mesh says which stars have changed.
class StarStamps {
 public:
  using Stamp = std::uint32_t;

  Stamp of(Index v) const noexcept { return v < stamps_.size() ? stamps_[v] : 0; }
  /// Of a simplex with these vertices: another one whenever any of their stars changes.
  Stamp latest(std::span<const Index> vertices) const noexcept {
    Stamp latest = 0;
    for (const Index v : vertices) latest = std::max(latest, of(v));
    return latest;
  }
  /// No star has a greater one.
  Stamp now() const noexcept { return last_; }
  /// Call when the stars of these vertices have changed. Repeated ones are allowed.
  void change(std::span<const Index> vertices);

  /// During its lifetime, changes are on trial: unless kept, they are undone, and the stars have their old
  /// numbers again. Trials nest.
  class Trial {
   public:
    explicit Trial(StarStamps& stamps) : stamps_(stamps), begin_(stamps.log_.size()) { ++stamps_.trials_; }
    ~Trial() { stamps_.end_trial(begin_, is_kept_); }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    void keep() noexcept { is_kept_ = true; }

   private:
    StarStamps& stamps_;
    std::size_t begin_;
    bool is_kept_ = false;
  };

 private:
  struct Change {
    Index vertex;
    Stamp before;
  };
  void end_trial(std::size_t begin, bool is_kept);

  std::vector<Stamp> stamps_;
  Stamp last_ = 0;
  std::vector<Change> log_;  ///< of the trials in progress
  int trials_ = 0;
};

}  // namespace multimesh
