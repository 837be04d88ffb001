// SPDX-License-Identifier: BSD-3-Clause
// What the reports of all commands have in common.
#include <algorithm>
#include <sstream>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

/// A closed surface, with a vertex written twice.
constexpr const char* tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 5 4 3\n";

/// Two tetrahedra that do not share the points at which they meet.
constexpr const char* tetrahedra_mesh =
    "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 0\n1 0 0 0\n"
    "0 1 0 0\n0.25 0.25 -1 0\nTetrahedra 2\n1 2 3 4 1\n5 7 6 8 1\nEnd\n";

struct Case {
  std::string name;
  Arguments arguments;
  std::vector<std::string> inputs, outputs;
  bool has_warnings = true;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

std::vector<Case> cases() {
  std::vector<Case> list = {
      {"decimate", {"decimate", "s.obj", "-o", "o.obj", "--faces", "4"}, {"s.obj"}, {"o.obj"}},
      {"decimate_levels",
       {"decimate", "g.obj", "-o", "o.obj", "--levels", "0.8,0.5"},
       {"g.obj"},
       {"o.obj", "o.lod1.obj"},  // the last level is the output
       false},
      {"unreachable", {"decimate", "s.obj", "-o", "o.obj", "--faces", "1"}, {"s.obj"}, {"o.obj"}},
      {"remesh", {"remesh", "s.obj", "-o", "o.obj", "--length", "0.4"}, {"s.obj"}, {"o.obj"}},
      {"compare", {"compare", "s.obj", "s.obj", "--samples", "50"}, {"s.obj", "s.obj"}, {}},
      {"info", {"info", "s.obj"}, {"s.obj"}, {}},
      {"info_of_tetrahedra", {"info", "t.mesh"}, {"t.mesh"}, {}, false},
      {"validate", {"validate", "s.obj"}, {"s.obj"}, {}},
  };
#ifdef MULTIMESH_WITH_IMPROVE
  list.push_back(
      {"remesh_tetrahedra", {"remesh", "t.mesh", "-o", "o.mesh", "--length", "0.5"}, {"t.mesh"}, {"o.mesh"}});
  list.push_back({"improve", {"improve", "t.mesh", "-o", "o.mesh"}, {"t.mesh"}, {"o.mesh"}});
#endif
#ifdef MULTIMESH_WITH_TETGEN
  list.push_back({"tetrahedralize", {"tetrahedralize", "s.obj", "-o", "o.mesh"}, {"s.obj"}, {"o.mesh"}});
#endif
#if defined(MULTIMESH_WITH_TETGEN) && defined(MULTIMESH_WITH_EXACT)
  list.push_back({"insert", {"insert", "s.obj", "-o", "o.mesh"}, {"s.obj"}, {"o.mesh"}});
#endif
  return list;
}

class RunReport : public ProgramTest, public ::testing::WithParamInterface<Case> {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    file("s.obj", tetrahedron_obj);
    file("t.mesh", tetrahedra_mesh);
    file("g.obj", grid_obj(4));
  }
  Ended run_with(const Arguments& more) const {
    Arguments all = GetParam().arguments;
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

std::vector<std::string> warnings_of(const std::string& err) {
  std::vector<std::string> list;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("warning: ")) list.push_back(line.substr(9));
  return list;
}

/// Only the fields that are equal in any two runs.
Json without_time(Json j) {
  j.erase("seconds");
  if (j.contains("collapses")) j["collapses"].erase("seconds");
  return j;
}

TEST_P(RunReport, HasWhatAllReportsHave) {
  const Ended e = run_with({"--report", "r.json"});
  ASSERT_TRUE(exists("r.json")) << e.err;
  const Json r = json("r.json");
  EXPECT_EQ(r["command"], GetParam().arguments[0]);
  EXPECT_TRUE(r["version"].is_string());
  EXPECT_EQ(r["inputs"], GetParam().inputs);
  EXPECT_EQ(r["outputs"], GetParam().outputs);
  EXPECT_TRUE(r["options"].is_object());
  EXPECT_GE(r["seconds"], 0.0);
  EXPECT_EQ(r["warnings"].empty(), !GetParam().has_warnings) << r["warnings"];
  const auto listed = r["warnings"].get<std::vector<std::string>>();
  for (const std::string& w : warnings_of(e.err))
    EXPECT_NE(std::ranges::find(listed, w), listed.end()) << "not in the report: " << w;
  for (const std::string& output : GetParam().outputs) EXPECT_TRUE(exists(output)) << output;
}

TEST_P(RunReport, IsPrintedAndNothingElse) {
  const Ended written = run_with({"--report", "r.json"}), printed = run_with({"--report", "-"});
  EXPECT_EQ(printed.status, written.status);
  EXPECT_EQ(without_time(Json::parse(printed.out)), without_time(json("r.json")));
}

TEST_P(RunReport, DoesNotReplaceAFileOfTheRun) {
  for (const char* option : {"--report", "--report-html"}) {
    const Ended e = run_with({option, GetParam().inputs[0]});
    EXPECT_EQ(e.status, 1);
    EXPECT_NE(e.err, "");
    EXPECT_EQ(content("s.obj"), tetrahedron_obj);
    EXPECT_EQ(content("t.mesh"), tetrahedra_mesh);
    EXPECT_EQ(content("g.obj"), grid_obj(4));
  }
}

TEST_P(RunReport, IsAPage) {
  const Ended e = run_with({"--report-html", "r.html"});
  if (contains(e.err, "built without the viewer")) GTEST_SKIP() << e.err;
  ASSERT_TRUE(exists("r.html")) << e.err;
  const std::string html = content("r.html"), head = "id=\"report\">";
  const std::size_t begin = html.find(head) + head.size();
  const Json r = Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  EXPECT_EQ(r["numbers"]["command"], GetParam().arguments[0]);
  EXPECT_EQ(r["meshes"]["after"]["included"], true);
}

TEST_P(RunReport, HelpSaysHow) {
  const std::string help = run({GetParam().arguments[0], "--help"}).out;
  EXPECT_TRUE(contains(help, "--report FILE") && contains(help, "--report-html FILE")) << help;
  EXPECT_FALSE(contains(help, "--json")) << "the old spelling is accepted, not taught";
  const std::size_t targets = help.find("\nTargets:"), options = help.find("\nOptions:");
  EXPECT_TRUE(targets == std::string::npos || targets < options) << help;
  EXPECT_TRUE(contains(help, "MSH, MEDIT, MFEM, VTU, VTP, VTK, .node/.ele; also gzipped")) << help;
}

INSTANTIATE_TEST_SUITE_P(Of, RunReport, ::testing::ValuesIn(cases()),
                         [](const auto& c) { return c.param.name; });

class OldSpelling : public ProgramTest {};

TEST_F(OldSpelling, OfReportIsAccepted) {
  file("s.obj", tetrahedron_obj);
  EXPECT_EQ(Json::parse(run({"info", "s.obj", "--json"}).out)["command"], "info");
  EXPECT_EQ(Json::parse(run({"validate", "s.obj", "--json"}).out)["command"], "validate");
  EXPECT_EQ(Json::parse(run({"compare", "s.obj", "s.obj", "--samples", "9", "--json"}).out)["samples"], 9);
#ifdef MULTIMESH_WITH_IMPROVE
  file("t.mesh", tetrahedra_mesh);
  run({"improve", "t.mesh", "-o", "o.mesh", "--json", "r.json"});
  EXPECT_EQ(json("r.json")["command"], "improve");
#endif
}

class ReportedOptions : public ProgramTest {};

TEST_F(ReportedOptions, AreThoseOfTheCommandLine) {
  file("g.obj", grid_obj(4));
  const Arguments run_of{"decimate", "g.obj",        "-o",        "o.obj",    "--ratio",
                         "0.5",      "--lock-seams", "--no-weld", "--report", "r.json"};
  ASSERT_EQ(run(run_of).status, 0);
  const Json options = json("r.json")["options"];
  EXPECT_EQ(options["ratio"], 0.5);
  EXPECT_EQ(options["lock_seams"], true);
  EXPECT_EQ(options["no_weld"], true);
  EXPECT_EQ(options["cost"], "quadric");
  EXPECT_FALSE(options.contains("output") || options.contains("report")) << options;
}

}  // namespace
}  // namespace multimesh::tools::test
