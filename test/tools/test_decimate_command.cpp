// SPDX-License-Identifier: BSD-3-Clause
// multimesh decimate: levels of detail, several targets, limits, measurement, and the same bytes each time.
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

using Names = std::vector<std::string>;

class DecimateCommand : public ProgramTest {
 protected:
  Json report_of(const std::string& in, const Arguments& arguments) {
    Arguments more = arguments;
    more.insert(more.end(), {"--report", "r.json"});
    const Ended e = decimate(in, "out.obj", more);
    EXPECT_EQ(e.status, 0) << e.err;
    said = e.err;
    return e.status == 0 ? json("r.json") : Json();
  }
  void expect_usage(const Arguments& arguments, const std::string& message) const {
    const Ended e = decimate(spot(), "out.obj", arguments);
    EXPECT_EQ(e.status, 2) << ::testing::PrintToString(arguments) << e.err;
    EXPECT_TRUE(contains(e.err, message)) << ::testing::PrintToString(arguments) << e.err;
    EXPECT_TRUE(names().empty());
  }
  void expect_refused(const std::string& in, const std::string& out, const Arguments& arguments,
                      const std::string& message) const {
    const Names before = names();
    const Ended e = decimate(in, out, arguments);
    EXPECT_EQ(e.status, 1) << ::testing::PrintToString(arguments) << e.err;
    EXPECT_TRUE(contains(e.err, "multimesh: ") && contains(e.err, message)) << e.err;
    EXPECT_FALSE(contains(e.err, "internal error")) << e.err;
    EXPECT_EQ(names(), before) << ::testing::PrintToString(arguments);
  }
  /// Of OBJ files only: spot's material library is copied along.
  Names meshes() const {
    Names found = names();
    std::erase_if(found, [](const std::string& name) { return !name.ends_with(".obj"); });
    return found;
  }
  std::size_t faces_of(const std::string& name) const {
    return info(name)["meshes"]["surface"]["faces"].get<std::size_t>();
  }
  std::string said;
};

TEST_F(DecimateCommand, LevelsAreFilesOfTheirOwn) {
  const Json r = report_of(spot(), {"--levels", "0.5,0.25,0.1"});
  EXPECT_EQ(meshes(), (Names{"out.lod1.obj", "out.lod2.obj", "out.obj"}));
  EXPECT_EQ(r["options"]["target_faces"], 586);
  EXPECT_EQ(r["options"]["levels"], (std::vector<int>{2928, 1464}));
  ASSERT_EQ(r["levels"].size(), 2U);
  const Names files{"out.lod1.obj", "out.lod2.obj", "out.obj"}, ratios{"0.5", "0.25", "0.1"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json before = info(spot()), now = info(files[i]);
    EXPECT_LE(now["meshes"]["surface"]["faces"], 5856 * std::stod(ratios[i]) + 1);
    EXPECT_EQ(now["meshes"]["texture"]["components"], before["meshes"]["texture"]["components"]);
    EXPECT_EQ(now["meshes"]["seams"]["junctions"], before["meshes"]["seams"]["junctions"]);
    if (i < 2) {
      EXPECT_EQ(r["levels"][i]["output"], files[i]);
      EXPECT_EQ(r["levels"][i]["faces"], now["meshes"]["surface"]["faces"]);
    }
    ASSERT_EQ(decimate(spot(), "alone.obj", {"--ratio", ratios[i]}).status, 0);
    EXPECT_TRUE(content("alone.obj") == content(files[i])) << "a level is what a run of its own writes";
  }
}

TEST_F(DecimateCommand, LevelsMayBeNumbersOfFacesBesideATarget) {
  file("in.obj", grid_obj(20));
  ASSERT_EQ(decimate("in.obj", "a.obj", {"--levels", "0.5", "300", "--faces", "100"}).status, 0);
  EXPECT_EQ(names(), (Names{"a.lod1.obj", "a.lod2.obj", "a.obj", "in.obj"}));
  EXPECT_LE(faces_of("a.lod1.obj"), 400U);
  EXPECT_LE(faces_of("a.lod2.obj"), 300U);
  EXPECT_LE(faces_of("a.obj"), 100U);
  EXPECT_GE(faces_of("a.lod1.obj"), 399U);
}

TEST_F(DecimateCommand, LevelsGoWithABound) {
  ASSERT_EQ(decimate(spot(), "a.obj", {"--levels", "0.5,0.4", "--max-error", "0.01"}).status, 0);
  EXPECT_EQ(meshes(), (Names{"a.lod1.obj", "a.lod2.obj", "a.obj"}));
  EXPECT_LT(faces_of("a.obj"), faces_of("a.lod2.obj"));
}

TEST_F(DecimateCommand, ALevelThatIsNotReachedIsNotWritten) {
  file("in.obj", grid_obj(20));
  const Json r = report_of("in.obj", {"--levels", "100,3,2", "--faces", "1", "--lock-seams"});
  EXPECT_EQ(names(), (Names{"in.obj", "out.lod1.obj", "out.obj", "r.json"}));
  EXPECT_EQ(r["levels"].size(), 1U);
  EXPECT_EQ(r["target_reached"], false);
}

TEST_F(DecimateCommand, OneLevelIsATarget) {
  ASSERT_EQ(decimate(spot(), "a.obj", {"--levels", "0.25"}).status, 0);
  ASSERT_EQ(decimate(spot(), "b.obj", {"--ratio", "0.25"}).status, 0);
  EXPECT_EQ(meshes(), (Names{"a.obj", "b.obj"}));
  EXPECT_TRUE(content("a.obj") == content("b.obj"));
}

TEST_F(DecimateCommand, LevelsThatDoNotDescendAreRefused) {
  for (const Arguments& bad : std::vector<Arguments>{{"--levels", "0.1,0.5"},
                                                     {"--levels", "0.5,0.5"},
                                                     {"--levels", "0.5,0.1", "--ratio", "0.1"},
                                                     {"--levels", "0.5,0.1", "--faces", "4000"},
                                                     {"--levels", "0.00001,0.000001"}})
    expect_refused(spot(), "out.obj", bad, "--levels must descend");
}

TEST_F(DecimateCommand, LevelsDoNotReplaceTheInputOrAReport) {
  file("a.lod1.obj", grid_obj(20));
  const std::string before = content("a.lod1.obj");
  expect_refused("a.lod1.obj", "a.obj", {"--levels", "0.5,0.1"}, "a.lod1.obj");
  EXPECT_TRUE(content("a.lod1.obj") == before);
  file("in.obj", grid_obj(20));
  expect_refused("in.obj", "b.obj", {"--levels", "0.5,0.1", "--report", "b.lod1.obj"}, "b.lod1.obj");
}

TEST_F(DecimateCommand, ALevelThatCannotBeWrittenIsSaidBeforeAnyIs) {
  file("in.obj", grid_obj(20));
  fs::create_directory(directory / "a.lod2.obj");
  expect_refused("in.obj", "a.obj", {"--levels", "0.5,0.3,0.1"}, "a.lod2.obj");
}

TEST_F(DecimateCommand, OfSeveralTargetsTheFirstThatIsMetEndsTheRun) {
  Json r = report_of(spot(), {"--ratio", "0.5", "--max-error", "0.5"});
  EXPECT_EQ(r["stopped_by"], "target number of faces");
  EXPECT_EQ(r["options"]["max_error"], 0.5);
  EXPECT_EQ(r["options"]["target_faces"], 2928);
  r = report_of(spot(), {"--faces", "10", "--max-error", "0.001"});
  EXPECT_EQ(r["stopped_by"], "bounds on the result");
  EXPECT_EQ(r["target_reached"], false);
  EXPECT_TRUE(contains(said, "warning: the target of 10 ")) << said;
  r = report_of(spot(), {"--ratio", "0.001", "--max-texture-error", "0.002", "--max-error", "0.5"});
  EXPECT_EQ(r["stopped_by"], "bounds on the result");
  EXPECT_EQ(r["options"]["max_texture_error"], 0.002);
}

TEST_F(DecimateCommand, LimitsAreUsedAndReported) {
  file("in.obj", grid_obj(20));
  Json r = report_of("in.obj", {"--faces", "1"});
  const auto edges = r["after"]["seams"]["edges"].get<int>();
  EXPECT_LT(edges, 20);
  EXPECT_EQ(r["options"]["lock_seams"], false);
  EXPECT_EQ(r["options"]["lock_boundary"], false);
  r = report_of("in.obj", {"--faces", "1", "--lock-seams"});
  EXPECT_EQ(r["after"]["seams"]["edges"], 20);
  EXPECT_EQ(r["options"]["lock_seams"], true);
  const auto faces = r["after"]["surface"]["faces"].get<int>();
  r = report_of("in.obj", {"--faces", "1", "--lock-seams", "--lock-boundary"});
  EXPECT_GE(r["after"]["surface"]["faces"], 80) << "80 edges in the boundary, a face at each at least";
  EXPECT_GT(r["after"]["surface"]["faces"], faces);
  r = report_of(spot(), {"--ratio", "0.1", "--feature-angle", "50", "--normal-deviation", "60",
                         "--aspect-ratio", "30", "--uv-weight", "0.5", "--curve-weight", "2", "--seam-weight",
                         "0.2", "--uv-curve-weight", "1"});
  EXPECT_GT(r["after"]["features"]["edges"], 0);
  EXPECT_EQ(r["after"]["features"]["junctions"], r["before"]["features"]["junctions"]);
  const Json expected{{"feature_angle_degrees", 50}, {"normal_deviation_degrees", 60},
                      {"aspect_ratio", 30},          {"uv_weight", 0.5},
                      {"curve_weight", 2},           {"seam_weight", 0.2},
                      {"uv_curve_weight", 1}};
  for (const auto& [name, value] : expected.items()) EXPECT_EQ(r["options"][name], value) << name;
}

/// Where a material begins and ends in x, of the faces of an OBJ file.
struct Range {
  double low = 1e300, high = -1e300;
};
std::map<std::string, Range> materials(const std::string& obj) {
  std::istringstream in(obj);
  std::vector<double> x;
  std::map<std::string, Range> found;
  std::string material;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") words >> x.emplace_back();
    if (kind == "usemtl") words >> material;
    if (kind != "f") continue;
    for (std::string corner; words >> corner;) {
      const double at = x[static_cast<std::size_t>(std::stoi(corner)) - 1];
      Range& range = found[material];
      range.low = std::min(range.low, at), range.high = std::max(range.high, at);
    }
  }
  return found;
}

TEST_F(DecimateCommand, MaterialsArePreservedUnlessTheyAreNot) {
  file("in.obj", grid_obj(20, false));
  for (const Arguments& keep : std::vector<Arguments>{{}, {"--preserve-materials"}}) {
    Arguments arguments{"--faces", "30"};
    arguments.insert(arguments.end(), keep.begin(), keep.end());
    EXPECT_EQ(report_of("in.obj", arguments)["options"]["preserve_materials"], true);
    auto kept = materials(content("out.obj"));
    EXPECT_NEAR(kept["left"].high, 10, 1e-6);
    EXPECT_NEAR(kept["right"].low, 10, 1e-6);
  }
  EXPECT_EQ(
      report_of("in.obj", {"--faces", "30", "--no-preserve-materials"})["options"]["preserve_materials"],
      false);
  auto loose = materials(content("out.obj"));
  ASSERT_TRUE(loose.contains("left") && loose.contains("right")) << "each face still has its own";
  EXPECT_TRUE(std::abs(loose["left"].high - 10) > 1e-3 || std::abs(loose["right"].low - 10) > 1e-3);
}

TEST_F(DecimateCommand, MeasureIsWhatCompareSays) {
  const Json r = report_of(spot(), {"--ratio", "0.1", "--measure"});
  const Json& m = r["measured"];
  ASSERT_TRUE(m.is_object());
  for (const auto* field : {"rms", "hausdorff"}) EXPECT_GT(m["distance"][field], 0.0) << field;
  for (const auto* way : {"to_original", "from_original"})
    for (const auto* field : {"rms", "max"}) EXPECT_GT(m["distance"][way][field], 0.0) << way << field;
  for (const auto* field : {"rms", "mean", "p95", "max"}) EXPECT_GT(m["texture"]["deviation"][field], 0.0);
  for (const auto* field : {"rms", "max"}) EXPECT_TRUE(m["texture"]["seam_crack"][field].is_number());
  EXPECT_TRUE(m["texture"].contains("outside"));
  const Ended e = run({"compare", spot(), "out.obj", "--json"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json c = Json::parse(e.out);
  EXPECT_NEAR(m["distance"]["rms"], c["distance"]["rms"].get<double>(),
              0.02 * c["distance"]["rms"].get<double>());
  EXPECT_NEAR(m["texture"]["deviation"]["rms"], c["texture"]["deviation"]["rms"].get<double>(),
              0.02 * c["texture"]["deviation"]["rms"].get<double>());
  EXPECT_FALSE(report_of(spot(), {"--ratio", "0.1"}).contains("measured"));
}

TEST_F(DecimateCommand, MeasureOfASurfaceWithoutTextureHasNone) {
  std::ofstream(directory / "in.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const Json r = report_of("in.obj", {"--faces", "2", "--measure"});
  EXPECT_TRUE(r["measured"]["texture"].is_null());
  EXPECT_LT(r["measured"]["distance"]["rms"], 1e-9);
}

// The input is read again for it: it must be there.
TEST_F(DecimateCommand, MeasureNeedsAnInputThatIsNotReplaced) {
  fs::copy_file(spot(), directory / "a.obj");
  const std::string before = content("a.obj");
  for (const std::string& out : Names{"a.obj", "./a.obj"})
    expect_refused("a.obj", out, {"--ratio", "0.1", "--measure", "--report", "r.json"}, "a.obj");
  EXPECT_TRUE(content("a.obj") == before);
  EXPECT_EQ(decimate("a.obj", "a.obj", {"--ratio", "0.1", "--report", "r.json"}).status, 0)
      << "without it, the input may be replaced";
  EXPECT_LE(faces_of("a.obj"), 586U);
}

TEST_F(DecimateCommand, AnHtmlReportIsWritten) {
  const Ended e = decimate(spot(), "out.obj", {"--ratio", "0.1", "--report-html", "r.html"});
  if (e.status == 1 && contains(e.err, "without the viewer")) {
    EXPECT_TRUE(names().empty());
    GTEST_SKIP() << "built without the viewer";
  }
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(exists("out.obj") && exists("r.html"));
  const std::string page = content("r.html");
  EXPECT_TRUE(contains(page.substr(0, 200), "<!doctype html>") ||
              contains(page.substr(0, 200), "<!DOCTYPE html>"));
  EXPECT_TRUE(contains(page, "out.obj"));
  EXPECT_TRUE(contains(page.substr(page.size() - 100), "</html>"));
}

TEST_F(DecimateCommand, BadValuesAreWrongUsage) {
  const auto expect_bad = [&](const std::string& option, const Names& values, const Arguments& beside) {
    for (const std::string& value : values) {
      Arguments arguments = beside;
      arguments.insert(arguments.end(), {option, value});
      expect_usage(arguments, option);
    }
  };
  const Arguments target{"--ratio", "0.5"};
  expect_bad("--max-texture-error", {"0", "-1", "nan", "inf", "small", ""}, {});
  expect_bad("--levels", {"0", "0.5,0", "-1", "nan", "inf", "many", "0.5;0.1"}, {});
  for (const char* angle : {"--feature-angle", "--normal-deviation"})
    expect_bad(angle, {"0", "-10", "181", "nan", "inf", "right", ""}, target);
  expect_bad("--aspect-ratio", {"0", "1", "1.15", "-3", "nan", "inf", "good", ""}, target);
  for (const char* weight : {"--uv-weight", "--curve-weight", "--seam-weight", "--uv-curve-weight"})
    expect_bad(weight, {"-0.1", "nan", "inf", "heavy", ""}, target);
  for (const char* flag : {"--lock-boundary", "--lock-seams", "--measure", "--preserve-materials"})
    expect_usage({"--ratio", "0.5", std::string(flag) + "=maybe"}, flag);
}

TEST_F(DecimateCommand, TenRunsWriteTheSameBytes) {
  std::set<std::string> found;
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(decimate(spot(), "out.obj", {"--ratio", "0.1"}).status, 0);
    found.insert(content("out.obj"));
  }
  EXPECT_EQ(found.size(), 1U);
}

TEST_F(DecimateCommand, OnOneProcessorTheBytesAreTheSame) {
  const fs::path taskset = "/usr/bin/taskset";
  if (!fs::exists(taskset)) GTEST_SKIP() << "there is no taskset";
  ASSERT_EQ(decimate(spot(), "all.obj", {"--ratio", "0.1", "--measure", "--report", "all.json"}).status, 0);
  const Ended e =
      run({"decimate", spot(), "-o", "one.obj", "--ratio", "0.1", "--measure", "--report", "one.json"}, [&] {
        const std::string command =
            taskset.string() + " -c -p 0 " + std::to_string(::getpid()) + " > /dev/null";
        if (std::system(command.c_str()) != 0) ::_exit(125);
      });
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(content("one.obj") == content("all.obj"));
  EXPECT_EQ(json("one.json")["measured"], json("all.json")["measured"]);
}

// Faces that run against their neighbours, as three in ten of the grid's here: the result is that of the grid
// without them.
TEST_F(DecimateCommand, TrianglesAreTurnedToAgreeAndCounted) {
  const std::string straight = grid_obj(30);
  std::istringstream lines(straight);
  std::ostringstream turned;
  std::size_t faces = 0, n = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("f ") && ++faces % 10 < 3) {
      std::istringstream words(line);
      std::string f, a, b, c;
      words >> f >> a >> b >> c;
      line = "f " + a + ' ' + c + ' ' + b;
      ++n;
    }
    turned << line << '\n';
  }
  file("straight.obj", straight);
  file("turned.obj", turned.str());
  ASSERT_EQ(decimate("straight.obj", "a.obj", {"--ratio", "0.1"}).status, 0);
  const Ended e = decimate("turned.obj", "b.obj", {"--ratio", "0.1", "--report", "r.json"});
  ASSERT_EQ(e.status, 0);
  EXPECT_EQ(content("a.obj"), content("b.obj"));
  const std::string warning = std::to_string(n) + " triangles were turned round";
  EXPECT_TRUE(contains(e.err, "warning: " + warning)) << e.err;
  EXPECT_TRUE(contains(json("r.json")["warnings"].dump(), warning));
  EXPECT_EQ(info("b.obj")["manifold"]["edges_with_opposite_orientations"], 0);
}

}  // namespace
}  // namespace multimesh::tools::test
