// SPDX-License-Identifier: BSD-3-Clause
// Files that are wrong on purpose: exit status 1, a message naming the file and the place, nothing written.
#include <regex>
#include <set>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

class MalformedFiles : public ProgramTest {
 protected:
  void expect_refused(const fs::path& path) const {
    const auto before = names();
    for (const Arguments& arguments :
         {Arguments{"info", path},
          {"decimate", path, "-o", "out.obj", "--ratio", "0.5", "--report", "r.json"}}) {
      const Ended e = run(arguments);
      EXPECT_EQ(e.status, 1) << path << e.err;
      EXPECT_EQ(e.out, "") << path;
      EXPECT_TRUE(contains(e.err, path.filename().string() + ":")) << path << e.err;
      EXPECT_FALSE(contains(e.err, "internal error")) << path << e.err;
      EXPECT_EQ(names(), before) << path;
    }
  }
  /// Refused, and the message says at which line.
  void expect_line(const std::string& obj, int line) const {
    const fs::path path = file("bad.obj", obj);
    expect_refused(path);
    const Ended e = run({"info", "bad.obj"});
    EXPECT_TRUE(contains(e.err, "bad.obj:" + std::to_string(line) + ": ")) << obj << "\n" << e.err;
  }
};

TEST_F(MalformedFiles, OfTheSharedData) {
  const fs::path root = shared("malformed");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  // See test/io/: odd, but all there.
  const std::set<std::string> legal = {"bad-stl-tardis.stl",  "cube-minimal-degenerated.obj",
                                       "degenerate_edge.obj", "degenerated.obj",
                                       "eof_test.obj",        "nancolor.obj",
                                       "whitespace.off"};
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.path().extension() == ".gz" || legal.contains(entry.path().filename().string())) continue;
    expect_refused(entry.path());
    ++seen;
  }
  EXPECT_GT(seen, 20U);
  for (const std::string& name : legal)
    EXPECT_EQ(decimate(root / name, "out.obj", {"--ratio", "0.5"}).status, 0) << name;
}

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(MalformedFiles, IndicesOutOfRange) {
  for (const char* bad :
       {"4", "0", "-4", "2147483648", "4294967297", "99999999999999999999", "-99999999999999999999"})
    expect_line(triangle + std::string("f 1 2 ") + bad + "\n", 4);
}

TEST_F(MalformedFiles, NumbersThatAreNone) {
  expect_line("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", 2);
  expect_line("v 0 0 0\nv 1e999 0 0\nv 0 1 0\nf 1 2 3\n", 2);
  expect_line(triangle + std::string("vt zero 0\nf 1/1 2/1 3/1\n"), 4);
  expect_line("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1);
  expect_line(triangle + std::string("f 1 2 three\n"), 4);
}

TEST_F(MalformedFiles, FacesThatAreNone) {
  expect_line(triangle + std::string("f 1 2\n"), 4);
  expect_line(triangle + std::string("f 1 1 2\n"), 4);
  expect_line("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", 4);
  expect_refused(file("nofaces.obj", triangle));
  expect_refused(file("empty.obj", ""));
}

TEST_F(MalformedFiles, OtherThingsUnderTheNameOfAnObj) {
  expect_refused(file("page.obj", "<!DOCTYPE html><html><body>404</body></html>\n"));
  expect_refused(file("zeros.obj", std::string(10000, '\0')));
  expect_refused(file("packed.obj", std::string("\x1f\x8b\x08\0\0\0", 6)));
  expect_refused(file("mesh.fbx", triangle));
  expect_refused(file("noextension", triangle));
}

}  // namespace
}  // namespace multimesh::tools::test
