// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "adapters/tetgen/file_descriptor.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "adapters/tetgen/worker_path.hpp"
#include "multimesh/error.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/closed_shapes.hpp"
#include "test/tetgen/worker_script.hpp"

namespace multimesh::test {

using tetgen::tetrahedralize;
using tetgen::TetrahedralizeOptions;
using tetgen::WorkerError;
using Reason = WorkerError::Reason;

namespace {

void fill(const ClosedSurface& surface, const TetrahedralizeOptions& options = {}) {
  EXPECT_FALSE(tetrahedralize(surface.points, surface.triangles, options).tets.corners.empty());
}

/// That it ends for this reason; the message.
std::string expect_failure(Reason reason, const ClosedSurface& surface,
                           const TetrahedralizeOptions& options) {
  try {
    tetrahedralize(surface.points, surface.triangles, options);
    ADD_FAILURE() << "did not fail";
  } catch (const WorkerError& error) {
    EXPECT_EQ(static_cast<int>(error.reason()), static_cast<int>(reason)) << error.what();
    return error.what();
  }
  return {};
}

std::string expect_failure_of_script(Reason reason, const std::string& lines) {
  const WorkerScript script(lines);
  return expect_failure(reason, cube(), {.time_limit = std::chrono::seconds(20), .worker = script.path()});
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::ptrdiff_t open_files() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return std::distance(begin(files), end(files));
}

/// No child of this process is left, running or not.
void expect_no_child() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

void ignore_number(int) {}

/// Sets what happens on SIGCHLD, for a scope.
class OnChild {
 public:
  explicit OnChild(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    ::sigaction(SIGCHLD, &action, &old_);
  }
  ~OnChild() { ::sigaction(SIGCHLD, &old_, nullptr); }
  OnChild(const OnChild&) = delete;
  OnChild& operator=(const OnChild&) = delete;

 private:
  struct sigaction old_ {};
};

}  // namespace

TEST(Worker, AMissingOneIsAnError) {
  EXPECT_TRUE(
      contains(expect_failure(Reason::missing, cube(), {.worker = "/nowhere/worker"}), "/nowhere/worker"));
  ::setenv("MULTIMESH_TETGEN_WORKER", "/nowhere/else", 1);
  EXPECT_TRUE(contains(expect_failure(Reason::missing, cube(), {}), "/nowhere/else"));
  ::setenv("MULTIMESH_TETGEN_WORKER", "/etc/passwd", 1);
  expect_failure(Reason::missing, cube(), {});
  ::unsetenv("MULTIMESH_TETGEN_WORKER");
  fill(cube());
}

TEST(Worker, TheVariableNamesIt) {
  const WorkerScript script("exit 7");
  ::setenv("MULTIMESH_TETGEN_WORKER", script.path().c_str(), 1);
  const std::string message = expect_failure(Reason::bad_reply, cube(), {});
  ::unsetenv("MULTIMESH_TETGEN_WORKER");
  EXPECT_TRUE(contains(message, "exit code 7")) << message;
}

TEST(Worker, EveryEndWithoutAReplyIsAnError) {
  EXPECT_TRUE(contains(expect_failure_of_script(Reason::signal, "kill -SEGV $$"), "SIGSEGV"));
  EXPECT_TRUE(contains(expect_failure_of_script(Reason::signal, "kill -ABRT $$"), "SIGABRT"));
  EXPECT_TRUE(contains(expect_failure_of_script(Reason::bad_reply, "exit 0"), "exit code 0"));
  EXPECT_TRUE(contains(expect_failure_of_script(Reason::bad_reply, "echo some words; exit 3"), "some words"));
  expect_failure_of_script(Reason::bad_reply,
                           "echo garbage that is longer than a header, 0123456789 0123456789 >&3");
  expect_failure_of_script(Reason::bad_reply, "cat <&0 >&3");
  expect_failure_of_script(Reason::bad_reply, "yes | head -c 5000000; exit 3");
  expect_failure_of_script(Reason::bad_reply, "yes | head -c 5000000 >&3");
  expect_no_child();
}

TEST(Worker, RepliesThatLieAreErrors) {
  // The magic word, then counts that do not fit the file: nothing is allocated for them.
  const std::string magic = "printf '\\001\\000MMGTS1\\000\\000\\000\\000\\000\\000\\000\\000";
  expect_failure_of_script(Reason::bad_reply, magic + "' >&3");
  std::string huge;
  for (int i = 0; i < 32; ++i) huge += "\\377";
  expect_failure_of_script(Reason::bad_reply, magic + huge + "' >&3");
  std::string empty;
  for (int i = 0; i < 32; ++i) empty += "\\000";
  expect_failure_of_script(Reason::bad_result, magic + empty + "' >&3");
}

TEST(Worker, IsKilledWhenItsTimeIsOver) {
  const auto start = std::chrono::steady_clock::now();
  const WorkerScript sleeper("sleep 100"), printer("yes"), child("sleep 3 & sleep 100");
  for (const WorkerScript* script : {&sleeper, &printer, &child})
    expect_failure(Reason::time_out, cube(),
                   {.time_limit = std::chrono::milliseconds(200), .worker = script->path()});
  expect_failure(Reason::time_out, torus(2, 0.5, 200, 100),
                 {.max_volume = 1e-7, .time_limit = std::chrono::milliseconds(100)});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  expect_no_child();
}

TEST(Worker, AMemoryLimitEndsInAnError) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer needs a large address space";
#endif
  const std::string message = expect_failure(Reason::memory, sphere(1, 2),
                                             {.max_volume = 1e-6, .memory_limit = std::uint64_t{30} << 20});
  EXPECT_TRUE(contains(message, "memory")) << message;
}

TEST(Worker, LeavesNoFileOpen) {
  fill(cube());  // whatever is opened once and for all
  const auto before = open_files();
  const WorkerScript crash("kill -SEGV $$"), sleeper("sleep 100");
  for (int i = 0; i < 3; ++i) {
    fill(cube());
    expect_failure(Reason::signal, cube(), {.worker = crash.path()});
    expect_failure(Reason::time_out, cube(),
                   {.time_limit = std::chrono::milliseconds(20), .worker = sleeper.path()});
    expect_failure(Reason::missing, cube(), {.worker = "/nowhere"});
    EXPECT_THROW(fill(joined(cube(), sphere(0.5, 1, {1, 0.5, 0.4}))), InputError);
  }
  EXPECT_EQ(open_files(), before);
  expect_no_child();
}

TEST(Worker, ItsFilesDoNotGoToOtherPrograms) {
  const tetgen::FileDescriptor file = tetgen::anonymous_file();
  const auto [read, write] = tetgen::pipe_ends();
  for (const int fd : {file.get(), read.get(), write.get()}) {
    EXPECT_GE(fd, 10);
    EXPECT_EQ(::fcntl(fd, F_GETFD), FD_CLOEXEC);
  }
}

TEST(Worker, WorksWhateverTheCallerDoesWithItsChildren) {
  const WorkerScript crash("kill -SEGV $$"), words("exit 3");
  const ClosedSurface bad = joined(cube(), sphere(0.5, 1, {1, 0.5, 0.4}));
  {
    const OnChild ignored(SIG_IGN);
    fill(cube());
    EXPECT_THROW(fill(bad), InputError);
    expect_failure(Reason::bad_reply, cube(), {.worker = crash.path()});  // the status is lost
    expect_failure(Reason::bad_reply, cube(), {.worker = words.path()});
    expect_failure(Reason::time_out, cube(),
                   {.time_limit = std::chrono::milliseconds(50), .worker = WorkerScript("sleep 9").path()});
  }
  {
    const OnChild handled(ignore_number);  // interrupts system calls
    fill(sphere(1, 3));
    expect_failure(Reason::signal, cube(), {.worker = crash.path()});
  }
  {
    const OnChild taken([](int) {
      while (::waitpid(-1, nullptr, WNOHANG) > 0) {
      }
    });
    fill(sphere(1, 3));
    EXPECT_THROW(fill(bad), InputError);
  }
}

TEST(Worker, WorksWhenStandardStreamsAreClosed) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(0), ::close(1), ::close(2);
    bool good = false;
    try {
      const ClosedSurface s = cube();
      good = !tetrahedralize(s.points, s.triangles).tets.corners.empty();
    } catch (...) {
    }
    ::_exit(good ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(Worker, SeveralThreadsRunTheirOwn) {
  std::vector<std::size_t> tets(6);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < tets.size(); ++i)
      threads.emplace_back([&, i] {
        const ClosedSurface s = i % 2 ? sphere(1, 3) : torus(2, 0.5, 30, 12);
        for (int again = 0; again < 3; ++again) tets[i] = tetrahedralize(s.points, s.triangles).tets.size();
      });
  }
  EXPECT_EQ(tets[0], tets[2]);
  EXPECT_EQ(tets[1], tets[5]);
  EXPECT_GT(tets[0], 0u);
  expect_no_child();
}

TEST(Worker, PrintsNothingWhateverHappens) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  fill(sphere(1, 3), {.max_volume = 0.01});
  EXPECT_THROW(fill(joined(cube(), sphere(0.5, 1, {1, 0.5, 0.4}))), InputError);
  const std::string out = testing::internal::GetCapturedStdout(),
                    err = testing::internal::GetCapturedStderr();
  EXPECT_EQ(out, "");
  EXPECT_EQ(err, "");
}

TEST(Worker, StartedByHandSaysSo) {
  const std::string command =
      tetgen::worker_path().string() + " 2>/dev/null </dev/null 3>&-";  // 3: where a worker replies
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
}

TEST(TetrahedralizeOptions, AreRefusedOutOfRange) {
  const ClosedSurface s = cube();
  const auto refused = [&](const TetrahedralizeOptions& o) {
    EXPECT_THROW(tetrahedralize(s.points, s.triangles, o), UsageError);
  };
  refused({.max_volume = -1});
  refused({.edge_length = std::numeric_limits<double>::infinity()});
  refused({.radius_edge_ratio = 0.5});
  refused({.min_dihedral = 80});
  refused({.time_limit = std::chrono::seconds(0)});
}

}  // namespace multimesh::test
