// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "multimesh/algorithms/improvement/improver.hpp"
#include "multimesh/algorithms/improvement/obstacles.hpp"
#include "multimesh/error.hpp"

namespace multimesh {

namespace improvement {
namespace {

void check_options(const ImproveOptions& o) {
  const auto require = [](bool good, const char* what) {
    if (!good) throw InputError(std::string("improve: ") + what);
  };
  require(o.target_amips >= 3 && std::isfinite(o.target_amips),
          "the target of the AMIPS energy must be at least 3, that of the regular tetrahedron");
  require(o.max_passes >= 0, "max_passes must not be negative");
  require(o.edge_length >= 0 && std::isfinite(o.edge_length), "edge_length must be finite and not negative");
  require(o.min_edge_length >= 0 && std::isfinite(o.min_edge_length),
          "min_edge_length must be finite and not negative");
}

void check_input(const Workspace& work) {
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    const Corners c = work.corners(t);
    for (const Index v : c)
      if (!work.point(v).allFinite())
        throw InputError("improve: point " + std::to_string(v) + " is not finite");
    if (work.quality_of(c) < std::numeric_limits<double>::infinity()) continue;
    throw InputError("improve: tetrahedron " + std::to_string(t) + " (points " + std::to_string(c[0]) + ", " +
                     std::to_string(c[1]) + ", " + std::to_string(c[2]) + ", " + std::to_string(c[3]) +
                     ") is flat or inverted; only meshes of tetrahedra of positive volume can be improved");
  }
}

TetQuality measure(const Workspace& work, double target) {
  TetQuality q;
  for (Index v = 0; v < work.mesh().capacity(0); ++v) q.vertices += work.mesh().is_live(0, v);
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    const double cubed = work.quality_of(t), amips = std::cbrt(cubed);
    ++q.tets;
    q.above_target += cubed > target * target * target;
    q.max_amips = std::max(q.max_amips, amips);
    q.mean_amips += amips;
  }
  if (q.tets > 0) q.mean_amips /= static_cast<double>(q.tets);
  return q;
}

std::vector<OperationCount> named(const Counts& counts) {
  constexpr const char* kinds[] = {"split", "collapse", "edge swap", "face swap", "smoothing"};
  constexpr const char* reasons[] = {"quality", "inversion", "held", "length", "legality"};
  std::vector<OperationCount> list;
  for (std::size_t k = 0; k < n_kinds; ++k) {
    OperationCount& c = list.emplace_back();
    c.name = kinds[k];
    c.tried = counts[k].tried;
    c.done = counts[k].done;
    for (std::size_t r = 0; r < n_reasons; ++r)
      if (counts[k].refused[r] > 0) c.refused.emplace_back(reasons[r], counts[k].refused[r]);
  }
  return list;
}

std::size_t count_bad(const Improver& improver) {
  std::size_t n = 0;
  for (Index t = 0; t < improver.work().mesh().capacity(3); ++t)
    n += improver.work().is_live(t) && improver.work().quality_of(t) > improver.limit();
  return n;
}

/// A plain pass, then ones with trials of 1, 2, 4 .. splits, until not even the longest ones help.
int run(Improver& improver, const ImproveOptions& options) {
  constexpr int most_trial_splits = 16;
  int pass = 0, trial_splits = 0;
  while (pass < options.max_passes) {
    const std::size_t resized = options.edge_length > 0 ? improver.resize() : 0;
    if (count_bad(improver) == 0 && resized == 0) break;
    ++pass;
    const std::size_t done = improver.pass(trial_splits);
    if (options.progress) options.progress(pass, count_bad(improver));
    if (done + resized == 0 && trial_splits == most_trial_splits) break;
    trial_splits = std::clamp(2 * trial_splits, 1, most_trial_splits);
  }
  return pass;
}

}  // namespace
}  // namespace improvement

ImproveResult improve(TetDomain& domain, const ImproveOptions& options) {
  using namespace improvement;
  check_options(options);
  const auto start = std::chrono::steady_clock::now();
  Improver improver(domain, options);
  check_input(improver.work());
  ImproveResult result;
  result.before = measure(improver.work(), options.target_amips);
  const Obstacles forced(improver.work(), options.surface_splits);
  result.least_max_amips = forced.bound();
  result.least_max_amips_at = {forced.place()[0], forced.place()[1], forced.place()[2]};
  result.passes = run(improver, options);
  result.after = measure(improver.work(), options.target_amips);
  result.target_reached = result.after.above_target == 0;
  result.operations = named(improver.counts());
  if (!result.target_reached)
    result.obstacles = Obstacles(improver.work(), options.surface_splits).explain(improver.limit());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace multimesh
