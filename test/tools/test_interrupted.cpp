// SPDX-License-Identifier: BSD-3-Clause
// A run that is interrupted from outside leaves no partial output and no temporary file.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

using namespace std::chrono_literals;

class Interrupted : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    file("in.obj", grid_obj(300));  // 180 000 triangles
    file("out.obj", "older\n");
  }
  bool temporary_exists() const {
    for (const auto& name : names())
      if (name.ends_with(".tmp")) return true;
    return false;
  }
  /// Waits until the program has begun to write, or has ended.
  void await_temporary() const {
    for (int i = 0; i < 100000 && !temporary_exists() && content("out.obj") == "older\n"; ++i)
      std::this_thread::sleep_for(100us);
  }
};

TEST_F(Interrupted, WhileItWorks) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    const pid_t p = start({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.01", "--report", "r.json"});
    std::this_thread::sleep_for(150ms);
    ::kill(p, signal);
    const Ended e = wait(p);
    EXPECT_EQ(e.signal, signal) << "it ends as others do; exit status " << e.status;
    EXPECT_EQ(content("out.obj"), "older\n");
    EXPECT_EQ(names(), (std::vector<std::string>{"in.obj", "out.obj"}));
  }
}

TEST_F(Interrupted, WhileItWrites) {
  int caught = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    file("out.obj", "older\n");
    const pid_t p = start({"decimate", "in.obj", "-o", "out.obj", "--ratio", "1"});
    await_temporary();
    ::kill(p, signal);
    const Ended e = wait(p);
    EXPECT_FALSE(temporary_exists());
    if (e.signal == signal && content("out.obj") == "older\n") {
      ++caught;
    } else {
      EXPECT_EQ(info("out.obj")["contents"]["faces"], 180000) << "renamed: then it is complete";
    }
  }
  RecordProperty("caught_while_writing", caught);
}

TEST_F(Interrupted, KilledWhileItWritesThereIsNoPartialOutput) {
  const pid_t p = start({"decimate", "in.obj", "-o", "out.obj", "--ratio", "1"});
  await_temporary();
  ::kill(p, SIGKILL);
  (void)wait(p);
  if (content("out.obj") == "older\n") return;
  EXPECT_EQ(info("out.obj")["contents"]["faces"], 180000) << "renamed: then it is complete";
}

TEST_F(Interrupted, IgnoredSignalsStayIgnored) {
  file("in.obj", grid_obj(100));
  const pid_t p =
      start({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.1"}, [] { ::signal(SIGHUP, SIG_IGN); });
  std::this_thread::sleep_for(20ms);
  ::kill(p, SIGHUP);
  EXPECT_EQ(wait(p).status, 0) << "as under nohup";
}

}  // namespace
}  // namespace multimesh::tools::test
