// SPDX-License-Identifier: BSD-3-Clause
// Our numbers against those of a program that shares no code with ours, decimate_eval of the shared folder.
// Skipped if that is missing.
#include <cmath>
#include <cstdio>

#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

struct Pair {
  std::string model, ratio;
};

void PrintTo(const Pair& p, std::ostream* out) {
  *out << p.model << " at " << p.ratio;
}

std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return out;
  for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
  ::pclose(pipe);
  return out;
}

class AgainstEvaluator : public ProgramTest, public ::testing::WithParamInterface<Pair> {
 protected:
  /// Spot, or a model of the shared data, unpacked; empty where it is missing.
  std::string model() const {
    if (GetParam().model == "spot") return spot();
    const fs::path packed = shared("bench") / (GetParam().model + ".obj.gz");
    if (!fs::exists(packed)) return {};
    const fs::path unpacked = directory / (GetParam().model + ".obj");
    const std::string command = "gzip -dc '" + packed.string() + "' > '" + unpacked.string() + "'";
    return std::system(command.c_str()) == 0 ? unpacked.string() : std::string();
  }
};

void expect_near(const Json& ours, const Json& theirs, double share, const char* what) {
  EXPECT_NEAR(ours.get<double>(), theirs.get<double>(), share * theirs.get<double>()) << what;
}

// Both take 60,000 random samples, each its own: a mean square has an error of about 1 / sqrt(60000) times
// the spread of the squares, well below 2 %. Both find the maximum at vertices, or nearly so. Where it is
// inside a face it depends on single samples, so 5 %. The patterns of colours differ.
TEST_P(AgainstEvaluator, Agrees) {
  const std::string evaluator = MULTIMESH_EVALUATOR;
  if (evaluator.empty()) GTEST_SKIP() << "no evaluator";
  const std::string original = model();
  if (original.empty()) GTEST_SKIP() << "no model";
  ASSERT_EQ(decimate(original, "small.obj", {"--ratio", GetParam().ratio}).status, 0);
  const Ended e = run({"compare", original, "small.obj", "--json"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json ours = Json::parse(e.out);
  const Json theirs = Json::parse(output_of("'" + evaluator + "' '" + original + "' '" +
                                            (directory / "small.obj").string() + "' --samples 60000"));

  const Json &d = ours["distance"], &x = theirs["distance"], &t = ours["texture"], &y = theirs["texture"];
  expect_near(d["rms"], x["rms_rel"], 0.02, "rms");
  expect_near(d["to_original"]["rms"], x["fwd_rms_rel"], 0.02, "rms to the original");
  expect_near(d["from_original"]["rms"], x["bwd_rms_rel"], 0.02, "rms from the original");
  expect_near(d["hausdorff"], x["hausdorff_rel"], 0.05, "Hausdorff");
  expect_near(t["deviation"]["rms"], y["texture_dev_rms"], 0.05, "texture deviation, rms");
  expect_near(t["deviation"]["p95"], y["texture_dev_p95"], 0.05, "texture deviation, 95 %");
  // Where charts abut in the atlas, like those of spot, the evaluator takes some places of one chart for
  // places of its neighbour, far away: it finds cracks that do not exist.
  EXPECT_LE(t["seam_crack"]["rms"].get<double>(), 1.1 * y["seam_crack_rms"].get<double>());
  if (GetParam().model != "spot")
    expect_near(t["seam_crack"]["rms"], y["seam_crack_rms"], 0.10, "seam crack, rms");
  EXPECT_NEAR(t["color_psnr_db"].get<double>(), y["baked_psnr_db"].get<double>(), 0.5);
  EXPECT_NEAR(t["outside"].get<double>(), y["atlas_outside_fraction"].get<double>(), 5e-4);

  const std::pair<const char*, const char*> sides[] = {{"original", "original"}, {"other", "decimated"}};
  for (const auto& [own, their] : sides) {
    const Json &a = ours[own], &b = theirs[their];
    EXPECT_EQ(a["triangles"], b["faces"]);
    EXPECT_EQ(a["flipped"], b["uv"]["flipped"]);
    EXPECT_EQ(a["zero_area"], b["uv"]["zero_area"]);
    EXPECT_EQ(a["meshes"]["texture"]["charts"], b["uv"]["charts"]);
    EXPECT_EQ(a["meshes"]["seams"]["edges"], b["uv"]["seam_edges"]);
    EXPECT_EQ(a["meshes"]["seams"]["junctions"], b["uv"]["seam_junctions"]);
    EXPECT_EQ(a["meshes"]["surface"]["genus"], b["position"]["genus"]);
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, AgainstEvaluator,
                         ::testing::Values(Pair{"spot", "0.5"}, Pair{"spot", "0.1"}, Pair{"spot", "0.02"},
                                           Pair{"blub", "0.1"}, Pair{"animal", "0.1"},
                                           Pair{"animal", "0.02"}),
                         [](const auto& p) {
                           return p.param.model + p.param.ratio.substr(p.param.ratio.find('.') + 1);
                         });

}  // namespace
}  // namespace multimesh::tools::test
