// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <memory>
#include <stdexcept>

#include "adapters/io/atomic_file.hpp"
#include "io_fixture.hpp"
#include "multimesh/io/obj_writer.hpp"

namespace multimesh::io::test {
namespace {

using Names = std::vector<std::string>;

class AtomicFileTest : public IoTest {
 protected:
  /// Runs f in a process of its own. \return its wait status.
  template <class F>
  static int status_of(F&& f) {
    const pid_t child = ::fork();
    if (child == 0) {
      f();
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }
};

TEST_F(AtomicFileTest, AppearsOnlyWithCommit) {
  AtomicFile out(directory / "a");
  out.write("hello");
  EXPECT_FALSE(fs::exists(directory / "a"));
  out.commit();
  EXPECT_EQ(content(directory / "a"), "hello");
  EXPECT_EQ(names_in(directory), Names{"a"});
}

TEST_F(AtomicFileTest, AnExceptionLeavesTheOldFileAndNothingElse) {
  file("a", "old");
  try {
    AtomicFile out(directory / "a");
    out.write("half of the n");
    throw std::runtime_error("midway");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(content(directory / "a"), "old");
  EXPECT_EQ(names_in(directory), Names{"a"});
}

TEST_F(AtomicFileTest, SignalsRemoveTheTemporaryAndStillEndTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = status_of([&] {
      install_signal_cleanup();
      AtomicFile out(directory / "a"), other(directory / "b");
      out.write("half");
      ::raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    EXPECT_EQ(names_in(directory), Names{});
  }
}

TEST_F(AtomicFileTest, AnIgnoredSignalStaysIgnored) {
  const int status = status_of([&] {
    ::signal(SIGHUP, SIG_IGN);
    install_signal_cleanup();
    AtomicFile out(directory / "a");
    ::raise(SIGHUP);
    out.commit();
  });
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(names_in(directory), Names{"a"});
}

TEST_F(AtomicFileTest, AFullDiskIsAnErrorAndLeavesNothing) {
  PolygonSoup soup;
  soup.positions.assign(100000, {0.1, 0.2, 0.3});
  const int status = status_of([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10000, 10000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = error_of([&] { write_obj(directory / "a.obj", soup); });
    ::_exit(error.find("a.obj: writing failed") != std::string::npos ? 7 : 8);
  });
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(names_in(directory), Names{});
}

TEST_F(AtomicFileTest, WrongTargetsAreRefusedBeforeAnythingIsWritten) {
  const auto refusal = [](const fs::path& path) { return error_of([&] { AtomicFile out(path); }); };
  EXPECT_NE(refusal(directory).find("is a directory"), std::string::npos);
  EXPECT_NE(refusal(directory / "").find("is a directory"), std::string::npos);
  EXPECT_NE(refusal(directory / "no" / "a.obj").find("does not exist"), std::string::npos);
  EXPECT_NE(refusal(file("f", "") / "a.obj").find("is not a directory"), std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("not a regular file"), std::string::npos);
  EXPECT_EQ(names_in(directory), Names{"f"});
}

TEST_F(AtomicFileTest, PermissionsAndLinksStay) {
  const fs::path real = file("real", "old");
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real", directory / "link");
  AtomicFile out(directory / "link");
  out.write("new");
  out.commit();
  EXPECT_TRUE(fs::is_symlink(directory / "link"));
  EXPECT_EQ(content(real), "new");
  EXPECT_EQ(fs::status(real).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFileTest, ManyPendingFilesAtOnce) {
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (int i = 0; i < 100; ++i) files.push_back(std::make_unique<AtomicFile>(directory / std::to_string(i)));
  files.clear();
  EXPECT_EQ(names_in(directory), Names{});
}

}  // namespace
}  // namespace multimesh::io::test
