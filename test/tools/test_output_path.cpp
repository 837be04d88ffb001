// SPDX-License-Identifier: BSD-3-Clause
// Where files are read from and written to, and what happens when that cannot be done.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

class OutputPath : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    file("in.obj", grid_obj(8));
  }
  /// The run is refused with a message that names `file`, and leaves the directory as it was.
  void expect_refused(const Arguments& arguments, const std::string& name, const std::string& reason,
                      const std::function<void()>& prepare = {}) const {
    const auto before = names();
    const std::string in = content("in.obj");
    const Ended e = run(arguments, prepare);
    EXPECT_EQ(e.status, 1) << ::testing::PrintToString(arguments) << e.err;
    EXPECT_TRUE(contains(e.err, "multimesh: ") && contains(e.err, name) && contains(e.err, reason)) << e.err;
    EXPECT_FALSE(contains(e.err, "internal error")) << e.err;
    EXPECT_EQ(names(), before);
    EXPECT_EQ(content("in.obj"), in);
  }
  void expect_output_refused(const std::string& out, const std::string& reason) const {
    expect_refused({"decimate", "in.obj", "-o", out, "--ratio", "0.5"}, out, reason);
  }
};

/// In the child: an ordinary user, for whom permissions count.
void become_nobody() {
  if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(125);
}

TEST_F(OutputPath, InputThatIsNoFile) {
  fs::create_directory(directory / "d.obj");
  for (const std::string command : {"info", "decimate"}) {
    const Arguments more = command == "info" ? Arguments{} : Arguments{"-o", "out.obj", "--ratio", "0.5"};
    const auto with = [&](const std::string& in) {
      Arguments a{command, in};
      a.insert(a.end(), more.begin(), more.end());
      return a;
    };
    expect_refused(with("no.obj"), "no.obj", "does not exist");
    expect_refused(with("no/no.obj"), "no/no.obj", "does not exist");
    expect_refused(with("d.obj"), "d.obj", "directory");
    expect_refused(with("/dev/null"), "/dev/null", "");
    expect_refused(with(""), "", "");
  }
}

TEST_F(OutputPath, UnreadableInput) {
  fs::permissions(file("secret.obj", "v 0 0 0\n"), fs::perms::none);
  fs::permissions(directory, fs::perms::all);
  expect_refused({"info", "secret.obj"}, "secret.obj", "ermission denied", become_nobody);
  expect_refused({"decimate", "secret.obj", "-o", "out.obj", "--ratio", "0.5"}, "secret.obj",
                 "ermission denied", become_nobody);
}

TEST_F(OutputPath, DirectoryThatMayNotBeWritten) {
  fs::create_directory(directory / "locked");
  fs::permissions(directory / "locked",
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
  expect_refused({"decimate", "in.obj", "-o", "locked/out.obj", "--ratio", "0.5"}, "locked/out.obj",
                 "ermission denied", become_nobody);
}

TEST_F(OutputPath, OutputThatIsNoFile) {
  fs::create_directory(directory / "d.obj");
  expect_output_refused("d.obj", "directory");
  expect_output_refused("no/out.obj", "does not exist");
  expect_output_refused("in.obj/out.obj", "not a directory");
  expect_output_refused("/dev/null", "not a regular file");
}

TEST_F(OutputPath, ALinkToItselfIsRefused) {
  fs::create_symlink("loop.obj", directory / "loop.obj");
  expect_output_refused("loop.obj", "");
}

TEST_F(OutputPath, FormatsThatAreNotWrittenAreRefused) {
  for (const char* out : {"out.obj.gz", "out.vtk", "out.gltf"})
    EXPECT_NE(decimate("in.obj", out, {"--ratio", "0.5"}).status, 0) << out;
  EXPECT_EQ(names(), std::vector<std::string>{"in.obj"}) << "no OBJ under a foreign name";
}

TEST_F(OutputPath, TheReportMayNotReplaceAMesh) {
  expect_refused({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5", "--report", "in.obj"}, "in.obj",
                 "");
  expect_refused({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5", "--report", "out.obj"}, "out.obj",
                 "");
}

TEST_F(OutputPath, AReportThatCannotBeWrittenIsFoundBeforeTheWork) {
  expect_refused({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5", "--report", "no/r.json"},
                 "no/r.json", "does not exist");
}

TEST_F(OutputPath, OverTheInputGivesTheSameAsBesideIt) {
  ASSERT_EQ(decimate("in.obj", "out.obj", {"--ratio", "0.5"}).status, 0);
  ASSERT_EQ(decimate("in.obj", "in.obj", {"--ratio", "0.5"}).status, 0);
  EXPECT_EQ(content("in.obj"), content("out.obj"));
}

TEST_F(OutputPath, AnOlderFileIsReplacedThroughALinkWithItsPermissions) {
  fs::permissions(file("old.obj", "old"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("old.obj", directory / "link.obj");
  ASSERT_EQ(decimate("in.obj", "link.obj", {"--ratio", "0.5"}).status, 0);
  EXPECT_TRUE(fs::is_symlink(directory / "link.obj"));
  EXPECT_TRUE(contains(content("old.obj"), "\nf "));
  EXPECT_EQ(fs::status(directory / "old.obj").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputPath, NamesWithBlanksAndForeignLetters) {
  for (const std::string name : {"two words.obj", "Kuh-äöü-牛-✓.obj", "-.obj", "a'b\"c.obj"}) {
    ASSERT_EQ(run({"decimate", "in.obj", "-o", name, "--ratio", "0.5", "--report", name + ".json"}).status, 0)
        << name;
    EXPECT_EQ(json(name + ".json")["output"], name);
    EXPECT_EQ(info("./" + name)["file"], "./" + name);
  }
}

TEST_F(OutputPath, NamesThatAreNotUtf8DoNotBreakTheReports) {
  const std::string name = "K\xfch.obj";
  fs::copy_file(directory / "in.obj", directory / name);
  EXPECT_EQ(decimate(name, "out.obj", {"--ratio", "0.5", "--report", "r.json"}).status, 0);
  EXPECT_TRUE(json("r.json").contains("faces"));
  EXPECT_TRUE(info(name).contains("meshes"));
  file("latin.obj", "usemtl Gr\xfcn\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(info("latin.obj")["contents"]["materials"].size(), 1U);
}

// A full disk, as far as the program can see it: files may not grow beyond 4 kB.
TEST_F(OutputPath, FullDisk) {
  const rlimit small{4096, 4096};
  const auto with_signal = [&](void (*action)(int)) {
    return [=] {
      ::setrlimit(RLIMIT_FSIZE, &small);
      ::signal(SIGXFSZ, action);
    };
  };
  file("in.obj", grid_obj(40));
  const Arguments arguments{"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5"};
  expect_refused(arguments, "out.obj", "", with_signal(SIG_IGN));
  (void)run(arguments, with_signal(SIG_DFL));  // as `ulimit -f` in a shell
  EXPECT_EQ(names(), std::vector<std::string>{"in.obj"}) << "neither output nor temporary";
}

TEST_F(OutputPath, InfoThatCannotBePrintedFails) {
  const auto full = [] { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); };
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  EXPECT_EQ(run({"info", "in.obj"}, full).status, 1);
  EXPECT_EQ(run({"info", "in.obj", "--json"}, full).status, 1);
}

TEST_F(OutputPath, TwoRunsToOneFileLeaveOneOfTheTwoResults) {
  ASSERT_EQ(decimate(spot(), "a.obj", {"--ratio", "0.5"}).status, 0);
  ASSERT_EQ(decimate(spot(), "b.obj", {"--ratio", "0.4"}).status, 0);
  for (int i = 0; i < 3; ++i) {
    const pid_t a = start({"decimate", spot(), "-o", "c.obj", "--ratio", "0.5"});
    const pid_t b = start({"decimate", spot(), "-o", "c.obj", "--ratio", "0.4"});
    EXPECT_EQ(wait(a).status + wait(b).status, 0);
    EXPECT_TRUE(content("c.obj") == content("a.obj") || content("c.obj") == content("b.obj"));
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"a.obj", "b.obj", "c.obj", "in.obj", "spot.mtl"}));
}

}  // namespace
}  // namespace multimesh::tools::test
