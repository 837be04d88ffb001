// SPDX-License-Identifier: BSD-3-Clause
// The report of a decimation: valid JSON, and true.
#include <cmath>
#include <sstream>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

std::size_t sum(const Json& counts) {
  std::size_t n = 0;
  for (const auto& [reason, count] : counts.items()) n += count.get<std::size_t>();
  return n;
}

class Report : public ProgramTest {
 protected:
  Json report_of(const std::string& in, const Arguments& target) {
    Arguments more = target;
    more.insert(more.end(), {"--report", "r.json"});
    const Ended e = decimate(in, "out.obj", more);
    EXPECT_EQ(e.status, 0) << e.err;
    said = e.err;
    return json("r.json");
  }
  std::string said;
};

TEST_F(Report, SaysWhatWasAskedAndWhatWasDone) {
  const Json r = report_of(spot(), {"--ratio", "0.1"});
  EXPECT_TRUE(r["program"].get<std::string>().starts_with("multimesh "));
  EXPECT_EQ(r["input"], spot());
  EXPECT_EQ(r["output"], "out.obj");
  EXPECT_EQ(r["options"]["cost"], "quadric");
  EXPECT_EQ(r["options"]["target_faces"], 586);
  EXPECT_EQ(r["faces"]["before"], 5856);
  EXPECT_LE(r["faces"]["after"], 586);
  EXPECT_EQ(r["target_reached"], true);
  EXPECT_EQ(r["stopped_by"], "target number of faces");
  EXPECT_GT(r["max_cost"], 0.0);
  EXPECT_LT(r["max_cost"], 1.0);
  EXPECT_GE(r["seconds"], 0.0);
  EXPECT_TRUE(r["warnings"].is_array());
  EXPECT_EQ(r["collapses"]["tried"],
            r["collapses"]["done"].get<std::size_t>() + sum(r["collapses"]["refused"]));
  EXPECT_FALSE(r.contains("edges_left_by_what_keeps_them"));
}

TEST_F(Report, BeforeAndAfterAreWhatInfoSaysOfTheFiles) {
  const Json r = report_of(spot(), {"--ratio", "0.1"});
  EXPECT_EQ(r["before"], info(spot())["meshes"]);
  EXPECT_EQ(r["after"], info("out.obj")["meshes"]);
  EXPECT_EQ(r["after"]["surface"]["faces"], r["faces"]["after"]);
  for (const auto* key : {"components", "euler_characteristic", "boundary_loops", "genus"}) {
    EXPECT_EQ(r["before"]["surface"][key], r["after"]["surface"][key]) << key;
    EXPECT_EQ(r["before"]["texture"][key], r["after"]["texture"][key]) << key;
  }
  for (const auto* key : {"curves", "ends", "junctions"})
    EXPECT_EQ(r["before"]["seams"][key], r["after"]["seams"][key]) << key;
}

TEST_F(Report, AnUnreachableTargetHasItsReasons) {
  const Json r = report_of(spot(), {"--faces", "1"});
  EXPECT_EQ(r["target_reached"], false);
  EXPECT_EQ(r["stopped_by"], "no edge left that may be collapsed");
  EXPECT_EQ(sum(r["edges_left_by_what_keeps_them"]), r["after"]["surface"]["edges"]);
  EXPECT_TRUE(contains(said, "warning: the target of 1 ")) << said;
  for (const auto& [reason, count] : r["edges_left_by_what_keeps_them"].items()) {
    EXPECT_GT(count, 0);
    EXPECT_TRUE(contains(said, reason)) << said;
  }
}

TEST_F(Report, MaximalErrorIsAStopReason) {
  const Json r = report_of(spot(), {"--max-error", "0.001"});
  EXPECT_EQ(r["stopped_by"], "bounds on the result");
  EXPECT_EQ(r["options"]["max_error"], 0.001);
  EXPECT_FALSE(r["options"].contains("target_faces"));
  EXPECT_GT(r["edges_left_by_what_keeps_them"]["maximal error"], 0);
  EXPECT_EQ(r["target_reached"], true) << "none was given";
  EXPECT_LT(r["faces"]["after"], r["faces"]["before"]);
}

TEST_F(Report, RatioOneChangesNothing) {
  const Json r = report_of(spot(), {"--ratio", "1"});
  EXPECT_EQ(r["before"], r["after"]);
  EXPECT_EQ(r["collapses"]["done"], 0);
  EXPECT_EQ(r["max_cost"], 0);
}

TEST_F(Report, CostLengthIsUsed) {
  const Json r = report_of(spot(), {"--ratio", "0.1", "--cost", "length"});
  EXPECT_EQ(r["options"]["cost"], "length");
  const std::string by_length = content("out.obj");
  (void)report_of(spot(), {"--ratio", "0.1"});
  EXPECT_NE(content("out.obj"), by_length);
}

TEST_F(Report, TwoRunsWriteTheSameBytes) {
  ASSERT_EQ(decimate(spot(), "a.obj", {"--ratio", "0.1"}).status, 0);
  ASSERT_EQ(decimate(spot(), "b.obj", {"--ratio", "0.1"}).status, 0);
  EXPECT_EQ(content("a.obj"), content("b.obj"));
}

TEST_F(Report, WhatWasLeftOutIsAWarningHereAndOnTheTerminal) {
  file("in.obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
       "l 1 2\nf 1/1/1 2/2/1 3/3/1\nf 1/1 3/3 4\n");
  const Json r = report_of("in.obj", {"--ratio", "1"});
  EXPECT_GE(r["warnings"].size(), 2U) << "lines, a face with texture coordinates on two corners";
  for (const auto& w : r["warnings"]) EXPECT_TRUE(contains(said, w.get<std::string>())) << w;
}

TEST_F(Report, WithoutATextureItIsNull) {
  file("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Json r = report_of("in.obj", {"--faces", "2"});
  EXPECT_TRUE(r["before"]["texture"].is_null());
  EXPECT_TRUE(r["before"]["seams"].is_null());
  EXPECT_EQ(r["faces"]["after"], 4) << "a tetrahedron has no edge to spare";
  EXPECT_EQ(r["target_reached"], false);
}

/// A wavy sheet in side x side charts of 4 x 4 squares each, in cells of the atlas that lie in an order of
/// their own. The sides of the charts are hollow: what is left with few triangles reaches beyond them.
std::string many_charts_obj(int side) {
  std::ostringstream out;
  const int n = 4 * side, cells = side * side;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      out << "v " << i << ' ' << j << ' ' << 2 * std::sin(0.3 * i) * std::cos(0.2 * j) << '\n';
  const auto hollow = [](double x, double y) { return 0.5 + 0.5 * x * (1 - 0.4 * (1 - y * y)); };
  for (int cell = 0; cell < cells; ++cell)
    for (int k = 0; k < 25; ++k) {
      const double x = k / 5 * 0.5 - 1, y = k % 5 * 0.5 - 1;
      out << "vt " << (cell / side + hollow(x, y)) / side << ' ' << (cell % side + hollow(y, x)) / side
          << '\n';
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int cell = (i / 4 * side + j / 4) * 7919 % cells;  // a prime: each once
      const auto corner = [&](int x, int y) {
        out << ' ' << (i + x) * (n + 1) + j + y + 1 << '/' << 25 * cell + 5 * (i % 4 + x) + j % 4 + y + 1;
      };
      out << 'f', corner(0, 0), corner(1, 0), corner(1, 1), out << "\nf", corner(0, 0), corner(1, 1),
          corner(0, 1);
      out << '\n';
    }
  return out.str();
}

TEST_F(Report, SaysWhereTheTextureWasLost) {
  file("in.obj", many_charts_obj(12));
  const Json r = report_of("in.obj", {"--ratio", "0.1"});
  ASSERT_TRUE(r.contains("texture_loss")) << said;
  const Json& loss = r["texture_loss"];
  EXPECT_TRUE(contains(said, "warning: the texture is damaged")) << said;
  EXPECT_TRUE(contains(said, "--max-texture-error")) << said;
  EXPECT_TRUE(contains(r["warnings"].dump(), "the texture is damaged"));
  EXPECT_TRUE(loss["deviation"] > loss["bounds"]["deviation"] ||
              loss["outside_own_chart"] > loss["bounds"]["outside_own_chart"]);
  ASSERT_TRUE(loss["last_faces_within_bounds"].is_number()) << loss;
  const auto faces = loss["last_faces_within_bounds"].get<std::size_t>();
  EXPECT_GT(faces, r["faces"]["after"].get<std::size_t>());
  EXPECT_TRUE(contains(said, std::to_string(faces))) << said;

  const Json then =
      report_of("in.obj", {"--faces", std::to_string(faces), "--measure"})["measured"]["texture"];
  EXPECT_LE(then["deviation"]["rms"], 1.05 * loss["bounds"]["deviation"].get<double>());
  EXPECT_LE(then["outside_own_chart"], 1.1 * loss["bounds"]["outside_own_chart"].get<double>());
  EXPECT_FALSE(contains(said, "the texture is damaged")) << said;
}

TEST_F(Report, SaysNothingOfATextureThatIsWell) {
  for (const char* ratio : {"1", "0.5", "0.1"}) {
    EXPECT_FALSE(report_of(spot(), {"--ratio", ratio}).contains("texture_loss")) << ratio;
    EXPECT_FALSE(contains(said, "damaged")) << said;
  }
  file("in.obj", many_charts_obj(12));
  EXPECT_FALSE(
      report_of("in.obj", {"--ratio", "0.1", "--max-texture-error", "0.001"}).contains("texture_loss"));
}

TEST_F(Report, ItsLargestTextureDeviationIsThatWithinTheCharts) {
  const Json r = report_of(spot(), {"--ratio", "0.1", "--report-html", "page.html", "--measure"});
  EXPECT_LT(r["measured"]["texture"]["deviation"]["max"], 0.05);
  EXPECT_LT(r["measured"]["texture"]["seam_crack"]["max"], 0.1);
}

}  // namespace
}  // namespace multimesh::tools::test
