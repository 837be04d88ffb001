// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "multimesh/algorithms/improvement/improver.hpp"
#include "multimesh/algorithms/improvement/obstacles.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/tet_shape.hpp"

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
  require(o.max_edge_length >= 0 && std::isfinite(o.max_edge_length),
          "max_edge_length must be finite and not negative");
  require(o.time_limit >= 0, "time_limit must not be negative");
  require(o.max_growth >= 1, "max_growth must be at least 1");
  require(o.keep_volume > 0, "keep_volume must be greater than 0");
  for (const Confinement& c : o.confined)
    require(c.how != Confined::envelope || (c.distance > 0 && std::isfinite(c.distance)),
            "the distance of an envelope must be finite and greater than 0");
}

void check_input(const Workspace& work) {
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    const Corners c = work.corners(t);
    for (const Index v : c)
      if (!std::ranges::all_of(work.point(v), [](double x) { return std::isfinite(x); }))
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

/// Tetrahedra that a mesh of this volume and edge length has, about.
double expected_size(const Workspace& work, double length) {
  if (length == 0) return 0;
  double volume = 0;
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    const Corners c = work.corners(t);
    volume += six_volume(work.point(c[0]), work.point(c[1]), work.point(c[2]), work.point(c[3])) / 6;
  }
  return volume / (length * length * length / (6 * std::sqrt(2)));
}

class Run {
 public:
  Run(Improver& improver, const ImproveOptions& options) : improver_(improver), options_(options) {
    constexpr double least = 500;
    const double size = std::max({least, static_cast<double>(improver.work().count_tets()),
                                  expected_size(improver.work(), options.edge_length),
                                  expected_size(improver.work(), options.max_edge_length)});
    improver.set_largest_size(static_cast<std::size_t>(std::min(1e18, options.max_growth * size)));
    if (options.progress) improver.set_tick([this] { tell(); });
  }

  /// Where the surface forces more than the target somewhere, that is aimed at first, everywhere: it takes
  /// few new vertices, and nothing is refined on the way to what the worst place makes impossible.
  void go(ImproveResult& result) {
    const double possible = near_bound * improver_.forced().bound();
    if (possible > options_.target_amips && std::isfinite(possible)) approach(possible);
    approach(options_.target_amips);
    result.passes = pass_;
    result.stop = stop();
  }

 private:
  bool may_go_on() const { return pass_ < options_.max_passes && !improver_.is_out_of_time(); }

  /// Passes; then refinement of all that is bad, as long as that helps.
  void approach(double amips) {
    improver_.aim_at(amips);
    make_passes();
    while (improver_.count_bad() > 0 && may_go_on() && improver_.refine_and_improve()) {
      ++pass_;
      tell();
    }
  }

  /// A plain pass, then ones with trials of 1, 2, 4 .. splits, until not even the longest ones help, nor, in
  /// the end, smaller steps.
  void make_passes() {
    constexpr int most_trial_splits = 16;
    Badness before = improver_.badness();
    for (int trial_splits = 0; is_bad_or_missized() && may_go_on();) {
      ++pass_;
      improver_.pass(trial_splits);
      tell();
      const Badness now = improver_.badness();
      const bool helped = before.is_worse_than(now) || resized_ > 0;
      if (helped) before = now;
      if (!helped && trial_splits == most_trial_splits && !improver_.take_smaller_steps()) break;
      trial_splits = std::clamp(2 * trial_splits, 1, most_trial_splits);
    }
  }

  bool is_bad_or_missized() {
    if (options_.has_sizes() && may_go_on()) resized_ = improver_.resize(pass_ == 0);
    return improver_.count_bad() > 0 || resized_ > 0;
  }

  ImproveStop stop() const {
    if (improver_.count_bad() == 0) return ImproveStop::done;
    if (improver_.is_out_of_time()) return ImproveStop::time_limit;
    if (pass_ >= options_.max_passes) return ImproveStop::max_passes;
    return improver_.was_full() ? ImproveStop::max_growth : ImproveStop::done;
  }

  void tell() const {
    if (!options_.progress) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    options_.progress({pass_, improver_.count_above(options_.target_amips), improver_.work().count_tets(),
                       seconds.count()});
  }

  Improver& improver_;
  const ImproveOptions& options_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int pass_ = 0;
  std::size_t resized_ = 0;
};

}  // namespace
}  // namespace improvement

namespace {

/// What a domain is improved as.
struct LockedDomain {
  Embedding embedding;
  ImproveOptions options;

  LockedDomain(TetDomain& domain, const DomainImproveOptions& o) : embedding(domain.embedding()), options(o) {
    lock(embedding, domain, o);
    if (o.envelope > 0 && domain.surface())
      options.confined.push_back({*domain.surface(), Confined::envelope, o.envelope});
    if (!o.lock_surface) return;
    const std::vector<Confinement> fixed = fixed_surface(domain);
    options.confined.insert(options.confined.end(), fixed.begin(), fixed.end());
  }
};

}  // namespace

std::vector<Confinement> fixed_surface(const TetDomain& domain) {
  std::vector<Confinement> fixed{{NodeId::root, Confined::fixed}};
  if (domain.surface()) fixed.push_back({*domain.surface(), Confined::fixed});
  return fixed;
}

std::vector<Confinement> fixed_walls(PeriodicDomain& domain) {
  std::vector<Confinement> fixed;
  for (const std::optional<NodeId> surface : {domain.add_walls(), domain.listed(2)})
    if (surface) fixed.push_back({*surface, Confined::fixed});
  return fixed;
}

ImproveResult improve(TetDomain& domain, const DomainImproveOptions& options) {
  const LockedDomain locked(domain, options);
  return improve(locked.embedding, NodeId::root, locked.options);
}

std::size_t split_long_edges(TetDomain& domain, double longest, const DomainImproveOptions& options) {
  const LockedDomain locked(domain, options);
  return split_long_edges(locked.embedding, NodeId::root, longest, locked.options);
}

ImproveResult improve(const Embedding& embedding, NodeId node, const ImproveOptions& options) {
  using namespace improvement;
  check_options(options);
  const auto start = std::chrono::steady_clock::now();
  Improver improver(embedding, node, options);
  check_input(improver.work());
  ImproveResult result;
  result.before = measure(improver.work(), options.target_amips);
  const Obstacles& forced = improver.forced();
  result.least_max_amips = forced.bound();
  result.least_max_amips_at = {forced.place()[0], forced.place()[1], forced.place()[2]};
  Run(improver, options).go(result);
  if (options.has_sizes()) result.lengths = improver.measure_lengths();
  result.after = measure(improver.work(), options.target_amips);
  result.target_reached = result.after.above_target == 0;
  result.envelopes = improver.work().measure_envelopes();
  result.operations = named(improver.counts());
  if (!result.target_reached)
    result.obstacles = Obstacles(improver.work(), options.surface_splits).explain(improver.limit());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::size_t split_long_edges(const Embedding& embedding, NodeId node, double longest,
                             const ImproveOptions& options) {
  using namespace improvement;
  check_options(options);
  if (!(longest > 0 && std::isfinite(longest)))
    throw InputError("split_long_edges: the length must be finite and greater than 0");
  Improver improver(embedding, node, options);
  check_input(improver.work());
  return improver.split_longer(longest);
}

}  // namespace multimesh
