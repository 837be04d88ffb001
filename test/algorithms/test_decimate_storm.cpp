// SPDX-License-Identifier: BSD-3-Clause
// Random surfaces, options and ratios, from seeds.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

/// How many runs: MULTIMESH_DECIMATE_RUNS, for long ones by hand; MULTIMESH_DECIMATE_SEED is the first seed.
unsigned given(const char* name, unsigned fallback) {
  const char* value = std::getenv(name);
  return value ? static_cast<unsigned>(std::strtoul(value, nullptr, 10)) : fallback;
}

/// Of one seed: a surface, what it is made into, and how it is decimated.
class Trial {
 public:
  explicit Trial(unsigned seed) : random_(seed) {
    make_shape();
    // At edges with three faces, the cut decides which two are one chart; the judge cannot know.
    if (facts(input).surface.crowded_edges == 0) make_sets();
    if (chance(0.3)) make_colors();
    if (chance(0.2)) make_labels();
    choose_options();
  }

  TexturedTriangles input;
  TexturedSurfaceOptions surface_options;
  DecimateOptions options;
  std::string what() const { return what_.str(); }

 private:
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::size_t below(std::size_t n) { return random_() % n; }

  void make_shape() {
    static const std::vector<MadeSurface> made = made_surfaces();
    const std::size_t which = below(made.size() + 3);
    if (which < made.size()) {
      input = made[which].input;
      what_ << made[which].name;
    } else if (which == made.size()) {
      make_patches();
    } else {
      input = cube(6);
      which % 2 ? unwrap_to_faces(input, 6) : unwrap_to_cross(input, 6);
      what_ << "Cube";
    }
    if (chance(0.7)) {
      const double by = number(0.01, 0.45);
      jitter(input, by, static_cast<unsigned>(random_()));
      what_ << " jittered " << by;
    }
    if (chance(0.3)) {
      const Vec3 axis(number(-1, 1), number(-1, 1), number(-1, 1));
      for (Vec3& p : input.positions) p += Vec3(0, 0, 1) * (2 * std::sin(dot(p, axis)));
      what_ << " waved";
    }
  }

  /// A grid with a random map of charts: blobs with junctions, ends on the boundary, islands, bare parts.
  void make_patches() {
    const auto side = static_cast<Index>(8 + below(14));
    std::vector<std::pair<Vec3, std::size_t>> centres;
    std::vector<AffineMap> maps;
    const std::size_t n = 2 + below(7);
    for (std::size_t i = 0; i < n; ++i) {
      centres.push_back({Vec3(number(0, side), number(0, side), 0), chance(0.1) ? no_texture : i});
      const double turn = number(0, 6.28), mirror = chance(0.3) ? -1 : 1;
      maps.push_back({{{{mirror * std::cos(turn), -mirror * std::sin(turn), 0.1, 100.0 * double(i)},
                        {std::sin(turn), std::cos(turn), 0, number(-3, 3)}}}});
    }
    const auto chart = [&](const Vec3& p) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < n; ++i)
        if ((centres[i].first - p).squared_norm() < (centres[best].first - p).squared_norm()) best = i;
      return centres[best].second;
    };
    input = with_charts("Patches", grid(side, side), chart, maps).input;
    what_ << "Patches " << side << " " << n;
  }

  void make_sets() {
    while (input.more_uv_sets.size() < 2 && chance(0.25)) {
      const Vec3 cut(number(-1, 1), number(-1, 1), number(-1, 1));
      const double at = number(-0.5, 8), some = number(-1, 12);
      const bool part = chance(0.3);
      // Random texture coordinates may be flipped from the start; that must not matter.
      const Vec3 u(number(-1, 1), number(-1, 1), number(-1, 1)),
          v(number(-1, 1), number(-1, 1), number(-1, 1));
      bool any = false;
      for (std::size_t t = 0; t < input.triangles.size(); ++t) any |= !part || centroid(input, t)[0] < some;
      if (!any) continue;
      add_uv_set(
          input,
          [&](std::size_t t, const Vec3& p) {
            return Vec2(dot(u, p) + (dot(cut, centroid(input, t)) < at ? 0 : 50), dot(v, p));
          },
          [&](std::size_t t) { return !part || centroid(input, t)[0] < some; });
      what_ << (part ? ", part of a set" : ", another set");
    }
  }

  void make_colors() {
    for (std::size_t v = 0; v < input.positions.size(); ++v)
      input.colors.push_back({number(0, 1), number(0, 1), number(0, 1)});
  }

  void make_labels() {
    const Vec3 cut(number(-1, 1), number(-1, 1), number(-1, 1));
    for (std::size_t t = 0; t < input.triangles.size(); ++t)
      input.labels.push_back(dot(cut, centroid(input, t)) < 1 ? 3 : 4);
    surface_options.keep_label_borders = chance(0.8);
    what_ << ", labels";
  }

  void choose_options() {
    static constexpr std::array weights{0.0, 1e-3, 0.05, 1.0, 30.0, 1e4};
    options.faces = 1 + static_cast<std::size_t>(std::pow(number(0, 1), 2) * double(input.triangles.size()));
    if (chance(0.25)) options.cost = DecimateCost::length;
    if (chance(0.3)) surface_options.feature_angle = number(0.2, 2);
    if (chance(0.2)) options.lock_boundary = true;
    if (chance(0.2)) options.lock_seams = true;
    if (chance(0.2)) options.max_normal_deviation = number(0.05, 2);
    if (chance(0.2)) options.max_aspect_ratio = number(1.2, 40);
    if (chance(0.2)) options.max_normal_turn = number(0, 3.1);
    for (double* w :
         {&options.uv_weight, &options.curve_weight, &options.seam_weight, &options.uv_curve_weight})
      if (chance(0.4)) *w = weights[below(weights.size())];
    what_ << ", to " << options.faces << " of " << input.triangles.size();
    what_ << (options.cost == DecimateCost::length ? " by length" : "") << ", feature angle "
          << surface_options.feature_angle << ", locks " << options.lock_boundary << options.lock_seams
          << ", normals " << options.max_normal_deviation << ", aspect " << options.max_aspect_ratio
          << ", turn " << options.max_normal_turn << ", weights " << options.uv_weight << ' '
          << options.curve_weight << ' ' << options.seam_weight << ' ' << options.uv_curve_weight;
  }

  std::mt19937 random_;
  std::ostringstream what_;
};

void expect_valid(const Trial& trial, TexturedSurface& surface, const TexturedTriangles& before) {
  ASSERT_EQ(validate(surface.tree()), std::vector<std::string>());
  std::vector<Index> source;
  const TexturedTriangles after = surface.triangles(source);
  for (const Vec3& p : after.positions) ASSERT_TRUE(std::isfinite(p.norm()));
  for (std::size_t set = 0; set < surface.textures().size(); ++set) {
    const TexturedTriangles x = only_uv_set(before, set), y = only_uv_set(after, set);
    ASSERT_EQ(facts(y), facts(x)) << "set " << set;
    ASSERT_EQ(newly_flipped(only_uv_set(trial.input, set), y, source), 0U) << "set " << set;
    for (const Vec2& p : y.texcoords) ASSERT_TRUE(std::isfinite(p.norm()));
  }
  for (const Vec3& c : after.colors)
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(c[i] >= 0 && c[i] <= 1);
}

TEST(DecimateStorm, AnySurfaceAndOptionsLeaveAValidSurface) {
  const unsigned first = given("MULTIMESH_DECIMATE_SEED", 0), runs = given("MULTIMESH_DECIMATE_RUNS", 500);
  std::size_t collapsed = 0, before = 0;
  for (unsigned seed = first; seed < first + runs; ++seed) {
    Trial trial(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + trial.what());
    TexturedSurface surface(trial.input, trial.surface_options);
    std::vector<Index> all;
    const TexturedTriangles at_start = surface.triangles(all);
    const DecimateResult r = decimate(surface, trial.options);
    ASSERT_NO_FATAL_FAILURE(expect_valid(trial, surface, at_start));
    ASSERT_EQ(r.faces_after, surface.live_triangles());
    ASSERT_EQ(r.stop == DecimateResult::Stop::faces, r.faces_after <= trial.options.faces);
    // Once more, without the locks.
    DecimateOptions again;
    again.faces = std::max<std::size_t>(1, r.faces_after / 2);
    (void)decimate(surface, again);
    ASSERT_NO_FATAL_FAILURE(expect_valid(trial, surface, at_start));
    collapsed += r.collapsed;
    before += r.faces_before;
  }
  EXPECT_GT(collapsed, before / 10) << "nearly everything was refused: the test says little";
}

}  // namespace
}  // namespace multimesh::test
