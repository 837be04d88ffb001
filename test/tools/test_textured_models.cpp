// SPDX-License-Identifier: BSD-3-Clause
// The textured models of the shared data, decimated to 50% and 10%, or as far as topology allows.
#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

struct Model {
  fs::path path;
  std::string name;
};

[[maybe_unused]] void PrintTo(const Model& m, std::ostream* out) {
  *out << m.path;
}

std::vector<Model> models() {
  std::vector<Model> all;
  const fs::path root = shared("textured");
  if (root.empty()) return all;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path& p = entry.path();
    const bool packed = p.extension() == ".gz";
    if (packed && fs::exists(fs::path(p).replace_extension())) continue;  // unpacked beside it
    const fs::path file = packed ? p.stem() : p.filename();
    if (!entry.is_regular_file() || (file.extension() != ".obj" && file.extension() != ".ply")) continue;
    std::string name = p.parent_path().filename().string() + "_" + file.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    all.push_back({p, name});
  }
  std::sort(all.begin(), all.end(), [](const Model& x, const Model& y) { return x.path < y.path; });
  return all;
}

Json topology(const Json& meshes) {
  Json t;
  for (const auto& [name, mesh] : meshes.items())
    for (const auto* key :
         {"components", "euler_characteristic", "boundary_loops", "genus", "curves", "ends", "junctions"})
      if (mesh.is_object() && mesh.contains(key)) t[name][key] = mesh[key];
  return t;
}

class TexturedModels : public ProgramTest, public ::testing::WithParamInterface<Model> {
 protected:
  /// The model in a directory that may be written to; unpacked.
  std::string input() const {
    const fs::path& p = GetParam().path;
    if (p.extension() != ".gz") return p.string();
    const std::string name = p.stem().string();
    const std::string command = "gzip -dc '" + p.string() + "' > '" + (directory / name).string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return name;
  }
  void run_to(const std::string& in, const std::string& ratio) const {
    SCOPED_TRACE(ratio);
    const Ended e = decimate(in, "out/out.obj", {"--ratio", ratio, "--report", "r.json"});
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("r.json");
    EXPECT_EQ(topology(r["after"]), topology(r["before"]));
    if (r["target_reached"] == true) {
      EXPECT_LE(r["faces"]["after"], r["options"]["target_faces"]);
    } else {
      EXPECT_GT(r["edges_left_by_what_keeps_them"].size(), 0U);
      EXPECT_TRUE(contains(e.err, "cannot be reached")) << e.err;
    }
    const Json again = info("out/out.obj");
    EXPECT_EQ(again["contents"]["faces"], r["faces"]["after"]);
    EXPECT_EQ(topology(again["meshes"]), topology(r["after"])) << "what was written is what was reported";
    for (const auto& library : again["contents"]["material_libraries"])
      EXPECT_TRUE(exists("out/" + library.get<std::string>()) || contains(e.err, "was not found")) << library;
  }
};

TEST_P(TexturedModels, GoToFiftyAndTenPercent) {
  fs::create_directory(directory / "out");
  const std::string in = input();
  run_to(in, "0.5");
  run_to(in, "0.1");
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TexturedModels);
INSTANTIATE_TEST_SUITE_P(Shared, TexturedModels, ::testing::ValuesIn(models()),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace multimesh::tools::test
