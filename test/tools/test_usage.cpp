// SPDX-License-Identifier: BSD-3-Clause
// The command line itself: help, exit status 2, exactly one target.
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

class Usage : public ProgramTest {
 protected:
  void expect_usage(const Arguments& arguments, const std::string& message) const {
    const Ended e = run(arguments);
    EXPECT_EQ(e.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_TRUE(contains(e.err, message)) << ::testing::PrintToString(arguments) << "\n" << e.err;
    EXPECT_TRUE(contains(e.err, "--help")) << "where to read on";
    EXPECT_LT(e.err.size(), 300U) << e.err;
    EXPECT_EQ(e.out, "");
    EXPECT_TRUE(names().empty());
  }
  void expect_bad_target(const Arguments& target, const std::string& message) const {
    Arguments arguments{"decimate", spot(), "-o", "out.obj"};
    arguments.insert(arguments.end(), target.begin(), target.end());
    expect_usage(arguments, message);
  }
};

TEST_F(Usage, HelpOfTheProgramNamesItsCommandsAndExitStatus) {
  const Ended e = run({"--help"});
  EXPECT_EQ(e.status, 0);
  EXPECT_EQ(e.err, "");
  for (const char* part : {"decimate", "info", "Exit status", "0 done", "1 refused", "2 wrong usage"})
    EXPECT_TRUE(contains(e.out, part)) << part;
}

TEST_F(Usage, HelpOfDecimateTeaches) {
  const Ended e = run({"decimate", "--help"});
  EXPECT_EQ(e.status, 0);
  for (const char* part : {"--ratio", "--faces", "--max-error", "--cost", "--report", "--quiet",
                           "Example:", "(0, 1]", "bounding box", "quadric", "length", "seams"})
    EXPECT_TRUE(contains(e.out, part)) << part;
}

TEST_F(Usage, TheExampleOfTheHelpRuns) {
  const std::string help = run({"decimate", "--help"}).out;
  ASSERT_TRUE(contains(help, "multimesh decimate cow.obj -o small.obj --ratio 0.1 --report report.json"));
  fs::copy_file(spot(), directory / "cow.obj");
  EXPECT_EQ(
      run({"decimate", "cow.obj", "-o", "small.obj", "--ratio", "0.1", "--report", "report.json"}).status, 0);
  EXPECT_TRUE(exists("small.obj") && exists("report.json"));
}

TEST_F(Usage, HelpOfInfoSaysWhatTheNumbersAre) {
  const Ended e = run({"info", "--help"});
  EXPECT_EQ(e.status, 0);
  for (const char* part : {"--report", "surface", "texture", "seams", "cut"})
    EXPECT_TRUE(contains(e.out, part)) << part;
}

TEST_F(Usage, Version) {
  const Ended e = run({"--version"});
  EXPECT_EQ(e.status, 0);
  EXPECT_TRUE(contains(e.out, "multimesh 0."));
}

TEST_F(Usage, ACommandIsNeeded) {
  expect_usage({}, "subcommand");
  expect_usage({"enlarge"}, "subcommand");
  expect_usage({"info"}, "FILE");
  expect_usage({"decimate", "-o", "out.obj", "--ratio", "0.5"}, "IN");
  expect_usage({"decimate", spot(), "--ratio", "0.5"}, "--output");
}

TEST_F(Usage, UnknownOptionsAndTooManyFiles) {
  expect_usage({"info", spot(), "--xml"}, "--xml");
  expect_usage({"info", spot(), "other.obj"}, "other.obj");
  expect_bad_target({"--ratio", "0.5", "more.obj"}, "more.obj");
  expect_bad_target({"--ratio", "0.5", "--vertices", "5"}, "--vertices");
}

TEST_F(Usage, OneTargetAtLeast) {
  expect_bad_target({}, "At least 1");
  expect_bad_target({"--lock-seams"}, "At least 1");
  expect_bad_target({"--ratio", "0.5", "--faces", "10"}, "--ratio excludes --faces");
  expect_bad_target({"--ratio", "0.5", "--ratio", "0.1"}, "--ratio");
}

TEST_F(Usage, RatioIsAShare) {
  for (const char* bad : {"0", "-0.5", "1.0001", "50", "50%", "half", "nan", "inf", "1e-400", ""})
    expect_bad_target({"--ratio", bad}, "--ratio");
}

TEST_F(Usage, FacesIsAWholePositiveNumber) {
  for (const char* bad : {"0", "-5", "10.5", "1e3", "many", "nan", ""})
    expect_bad_target({"--faces", bad}, "--faces");
}

TEST_F(Usage, MaximalErrorIsAPositiveNumber) {
  for (const char* bad : {"0", "-1", "small", "nan", "inf", ""})
    expect_bad_target({"--max-error", bad}, "--max-error");
}

TEST_F(Usage, CostHasAName) {
  expect_bad_target({"--ratio", "0.5", "--cost", "cubic"}, "--cost");
  expect_bad_target({"--ratio", "0.5", "--cost", ""}, "--cost");
}

TEST_F(Usage, ExtremeTargetsThatAreLegal) {
  for (const Arguments& target :
       std::vector<Arguments>{{"--ratio", "1e-9"}, {"--faces", "1"}, {"--max-error", "1e300"}}) {
    Ended e = decimate(spot(), "out.obj", target);
    EXPECT_EQ(e.status, 0) << e.err;
  }
  for (const Arguments& target : std::vector<Arguments>{
           {"--ratio", "1"}, {"--faces", "18446744073709551615"}, {"--max-error", "1e-300"}}) {
    Ended e = decimate(spot(), "out.obj", target);
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.err, "5856 faces -> ")) << e.err;
  }
}

TEST_F(Usage, QuietPrintsNothingWhenAllIsWell) {
  const Ended e = decimate(spot(), "out.obj", {"--ratio", "0.5", "--quiet"});
  EXPECT_EQ(e.status, 0);
  EXPECT_EQ(e.err + e.out, "");
  EXPECT_NE(decimate("no.obj", "out.obj", {"--ratio", "0.5", "--quiet"}).err, "") << "errors are printed";
}

TEST_F(Usage, WithoutATerminalThereIsNoProgress) {
  const Ended e = decimate(spot(), "out.obj", {"--ratio", "0.1"});
  EXPECT_FALSE(contains(e.err, "\r"));
  EXPECT_EQ(e.out, "");
}

}  // namespace
}  // namespace multimesh::tools::test
