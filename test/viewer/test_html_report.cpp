// SPDX-License-Identifier: BSD-3-Clause
// The file as text; *.page.mjs tests how a browser shows it.
#include "multimesh/error.hpp"
#include "temporary_directory.hpp"
#include "tools/html_report.hpp"

namespace multimesh::tools::test {
namespace {

HtmlMesh triangle() {
  HtmlMesh mesh{.caption = "t.obj"};
  mesh.surface.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  mesh.surface.triangles = {{{{0, -1}, {1, -1}, {2, -1}}}};
  return mesh;
}

HtmlMesh many(std::size_t triangles) {
  HtmlMesh mesh = triangle();
  mesh.surface.triangles.resize(triangles, mesh.surface.triangles[0]);
  return mesh;
}

class Report : public InDirectory {
 protected:
  void SetUp() override {
    if (!can_write_html_report()) GTEST_SKIP() << "built without the viewer";
    InDirectory::SetUp();
  }
  std::string write(const HtmlReport& report) {
    write_html_report(directory / "r.html", report);
    return content("r.html");
  }
  static Json json(const std::string& html) {
    const std::string begin = "<script type=\"application/json\" id=\"report\">";
    const std::size_t at = html.find(begin) + begin.size();
    return Json::parse(html.substr(at, html.find("</script>", at) - at));
  }
  static std::string block(const std::string& html, const std::string& id) {
    const std::string begin = "<script type=\"text/plain\" id=\"" + id + "\">";
    const std::size_t at = html.find(begin);
    if (at == std::string::npos) return "none";
    return html.substr(at + begin.size(), html.find("</script>", at) - at - begin.size());
  }
};

TEST_F(Report, HoldsWhatItWasGiven) {
  const std::string html =
      write({.title = "a & b", .before = triangle(), .after = triangle(), .numbers = {{"seconds", 1.5}}});
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_NE(html.find("<title>a &amp; b</title>"), std::string::npos);
  EXPECT_EQ(json(html)["title"], "a & b");
  EXPECT_EQ(json(html)["numbers"]["seconds"], 1.5);
  EXPECT_EQ(json(html)["meshes"]["after"]["triangles"], 1);
  EXPECT_EQ(block(html, "after-position"), "AAAAAAEAAAACAAAA") << "0 1 2, little-endian";
  // Centred, and divided by the diagonal, 5: -0.3 and -0.4.
  EXPECT_TRUE(block(html, "before-positions").starts_with("mpmZvs3M"));
  EXPECT_EQ(block(html, "after-texcoord"), "");
}

TEST_F(Report, ThreeJsComesWithItsLicence) {
  const std::string html = write({.title = "t", .before = triangle(), .after = triangle()});
  EXPECT_NE(html.find("Permission is hereby granted, free of charge"), std::string::npos);
  EXPECT_NE(html.find("three.js authors"), std::string::npos);
}

TEST_F(Report, MarkupInNamesStaysText) {
  HtmlMesh mesh = triangle();
  mesh.caption = "</script><b>.obj";
  mesh.materials = {{.name = "</script><b>"}};
  const std::string hostile = "</script><b>";
  const std::string html = write({.title = "</title>" + hostile,
                                  .before = mesh,
                                  .after = mesh,
                                  .numbers = {{hostile, hostile}, {"warnings", {hostile}}}});
  EXPECT_EQ(html.find(hostile), std::string::npos);
  EXPECT_EQ(json(html)["numbers"][hostile], hostile);
}

TEST_F(Report, AboveTheLimitMeshesAreLeftOut) {
  const std::string one = write({.title = "t", .before = many(600'000), .after = many(400'001)});
  EXPECT_EQ(json(one)["meshes"]["before"]["included"], false);
  EXPECT_EQ(json(one)["meshes"]["before"]["triangles"], 600'000) << "is said all the same";
  EXPECT_EQ(json(one)["meshes"]["after"]["included"], true);
  EXPECT_EQ(json(one)["notes"].size(), 1U);
  EXPECT_EQ(block(one, "before-positions"), "none");
  EXPECT_NE(block(one, "after-positions"), "none");

  const Json none = json(write({.title = "t", .before = triangle(), .after = many(1'000'001)}));
  EXPECT_EQ(none["meshes"]["before"]["included"], false);
  EXPECT_EQ(none["meshes"]["after"]["included"], false);
  EXPECT_EQ(none["notes"].size(), 1U);
}

TEST_F(Report, WrongInputIsRefusedAndNothingIsWritten) {
  HtmlReport report{.title = "t", .before = triangle(), .after = triangle()};
  report.errors = {{"Distance", {0, 0}}};
  EXPECT_THROW(write(report), UsageError);
  report.errors = {{"Distance", {0, 0, -1}}};
  EXPECT_THROW(write(report), UsageError);
  report.errors.clear();
  report.after.material = {0};
  EXPECT_THROW(write(report), UsageError);
  report.after.material.clear();
  EXPECT_THROW(write_html_report(directory / "none/r.html", report), InputError);
  EXPECT_FALSE(std::filesystem::exists(directory / "r.html"));
}

TEST(ReportWithoutViewer, SaysHowToGetIt) {
  if (can_write_html_report()) GTEST_SKIP() << "built with the viewer";
  try {
    write_html_report("r.html", {.title = "t", .before = triangle(), .after = triangle()});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("MULTIMESH_WITH_VIEWER"), std::string::npos);
  }
}

}  // namespace
}  // namespace multimesh::tools::test
