// SPDX-License-Identifier: BSD-3-Clause
// multimesh compare, run as a program.
#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

class Compare : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(decimate(spot(), "small.obj", {"--ratio", "0.1"}).status, 0);
  }
  Json compare(const std::string& a, const std::string& b, const Arguments& more = {}) const {
    Arguments arguments{"compare", a, b, "--json", "--samples", "5000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    EXPECT_EQ(e.status, 0) << e.err;
    return e.status == 0 ? Json::parse(e.out) : Json();
  }
};

TEST_F(Compare, SaysAllNumbersAsJson) {
  const Json j = compare(spot(), "small.obj");
  EXPECT_EQ(j["original_file"], spot());
  EXPECT_EQ(j["other_file"], "small.obj");
  EXPECT_EQ(j["samples"], 5000);
  EXPECT_GT(j["diagonal"], 0.0);
  const Json& d = j["distance"];
  EXPECT_GT(d["rms"], 0.0);
  EXPECT_LT(d["rms"], 0.02);
  EXPECT_EQ(d["hausdorff"],
            std::max(d["to_original"]["max"].get<double>(), d["from_original"]["max"].get<double>()));
  const Json& t = j["texture"];
  EXPECT_GT(t["deviation"]["max"], t["deviation"]["p95"]);
  EXPECT_GE(t["deviation"]["rms"], t["deviation"]["mean"]);
  EXPECT_GT(t["color_psnr_db"], 10.0);
  EXPECT_GT(t["seam_crack"]["max"], t["seam_crack"]["rms"]);
  EXPECT_LT(t["outside"], 0.1);
  EXPECT_EQ(j["original"]["meshes"], info(spot())["meshes"]);
  EXPECT_EQ(j["other"]["meshes"], info("small.obj")["meshes"]);
  EXPECT_EQ(j["other"]["flipped"], 0);
}

TEST_F(Compare, AFileWithItselfHasAnInfiniteRatioWhichIsNull) {
  const Json j = compare("small.obj", "small.obj");
  EXPECT_LT(j["distance"]["hausdorff"], 1e-12);
  EXPECT_TRUE(j["texture"]["color_psnr_db"].is_null());
  const Ended e = run({"compare", "small.obj", "small.obj"});
  EXPECT_TRUE(contains(e.out, "inf")) << e.out;
}

TEST_F(Compare, PrintsATable) {
  const Ended e = run({"compare", spot(), "small.obj", "--samples", "2000"});
  EXPECT_EQ(e.status, 0);
  EXPECT_EQ(e.err, "");
  for (const char* part : {"original", "other", "triangles", "5856", "charts", "distance", "rms",
                           "texture deviation", "seam crack", "PSNR", "flipped"})
    EXPECT_TRUE(contains(e.out, part)) << part;
}

TEST_F(Compare, ThreadsDoNotMatterSamplesDo) {
  Json one = compare(spot(), "small.obj", {"--threads", "1"});
  Json three = compare(spot(), "small.obj", {"--threads", "3"});
  for (Json* j : {&one, &three}) j->erase("options"), j->erase("seconds");
  EXPECT_EQ(three, one);
  const Ended e = run({"compare", spot(), "small.obj", "--json", "--samples", "100"});
  EXPECT_NE(Json::parse(e.out)["distance"]["rms"], one["distance"]["rms"]);
}

TEST_F(Compare, WithoutATextureItIsNull) {
  file("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  EXPECT_TRUE(compare("bare.obj", spot())["texture"].is_null());
  EXPECT_TRUE(contains(run({"compare", "bare.obj", spot()}).out, "the original has none"));
  EXPECT_TRUE(contains(run({"compare", spot(), "bare.obj"}).out, "the other surface has none"));
}

TEST_F(Compare, ExitStatus) {
  EXPECT_EQ(run({"compare", spot(), "absent.obj"}).status, 1);
  EXPECT_TRUE(contains(run({"compare", spot(), "absent.obj"}).err, "absent.obj"));
  EXPECT_EQ(run({"compare", spot()}).status, 2);
  EXPECT_EQ(run({"compare", spot(), "small.obj", "--samples", "0"}).status, 2);
  EXPECT_EQ(run({"compare", spot(), "small.obj", "--threads", "-1"}).status, 2);
  EXPECT_EQ(run({"compare", spot(), "small.obj", "more.obj"}).status, 2);
  EXPECT_EQ(run({"compare", "--help"}).status, 0);
}

}  // namespace
}  // namespace multimesh::tools::test
