// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/worker_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "adapters/tetgen/worker_error.hpp"
#include "adapters/tetgen/worker_protocol.hpp"

extern char** environ;

namespace multimesh::tetgen {

namespace {

using Clock = std::chrono::steady_clock;

struct FileActions {
  posix_spawn_file_actions_t actions{};
  FileActions() { ::posix_spawn_file_actions_init(&actions); }
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  void give(int fd, int as) { ::posix_spawn_file_actions_adddup2(&actions, fd, as); }
};

struct Attributes {
  posix_spawnattr_t attributes{};
  Attributes() {
    ::posix_spawnattr_init(&attributes);
    sigset_t all, none;
    ::sigfillset(&all), ::sigemptyset(&none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
};

/// A process of ours. It is killed and waited for at the end, if it has not ended before.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() { kill(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Whether it has ended. The system may have waited for it (SIGCHLD ignored), or a handler of the caller.
  bool has_ended() { return reaped(WNOHANG); }
  void kill() noexcept {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    reaped(0);
  }
  WorkerEnd end() const {
    WorkerEnd end;
    if (!has_status_) return end;
    end.how = WIFSIGNALED(status_) ? WorkerEnd::How::signal : WorkerEnd::How::exited;
    end.number = WIFSIGNALED(status_) ? WTERMSIG(status_) : WEXITSTATUS(status_);
    return end;
  }

 private:
  bool reaped(int flags) noexcept {
    if (pid_ < 0) return true;
    pid_t done = 0;
    do done = ::waitpid(pid_, &status_, flags);
    while (done < 0 && errno == EINTR);
    if (done == 0) return false;
    has_status_ = done == pid_;
    pid_ = -1;
    return true;
  }

  pid_t pid_;
  int status_ = 0;
  bool has_status_ = false;
};

/// Keeps the beginning of what comes out of a pipe, and reads the rest, so that its writer never blocks.
class Log {
 public:
  explicit Log(FileDescriptor pipe) : pipe_(std::move(pipe)) {}
  bool is_open() const { return pipe_.get() >= 0; }

  /// Returns when the pipe is at its end, or after the time.
  void wait(std::chrono::milliseconds time) {
    pollfd poll{pipe_.get(), POLLIN, 0};
    if (::poll(&poll, is_open() ? 1 : 0, static_cast<int>(time.count())) > 0) drain();
  }
  /// A bounded number of reads: a program that prints without end must not keep us from looking at the clock.
  void drain() {
    char buffer[4096];
    for (int i = 0; i < 64 && is_open(); ++i) {
      const ssize_t size = ::read(pipe_.get(), buffer, sizeof buffer);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0 && errno == EAGAIN) return;
      if (size <= 0) return pipe_.close();
      text_.append(buffer, std::min(static_cast<std::size_t>(size), most - text_.size()));
    }
  }
  std::string take() { return std::move(text_); }

 private:
  static constexpr std::size_t most = 4096;
  FileDescriptor pipe_;
  std::string text_;
};

pid_t spawn(const std::filesystem::path& program, FileActions& files) {
  Attributes attributes;
  std::string name = program.string();
  char* arguments[] = {name.data(), nullptr};
  pid_t pid = -1;
  const int error =
      ::posix_spawn(&pid, name.c_str(), &files.actions, &attributes.attributes, arguments, environ);
  if (error != 0)
    throw WorkerError(WorkerError::Reason::missing,
                      "cannot start " + name + ": " + std::generic_category().message(error));
  return pid;
}

}  // namespace

WorkerEnd run_worker(const std::filesystem::path& program, const FileDescriptor& request,
                     const FileDescriptor& reply, Clock::time_point deadline) {
  auto [read, write] = pipe_ends();
  FileActions files;
  files.give(request.get(), request_file);
  files.give(write.get(), log_file);
  files.give(write.get(), STDERR_FILENO);
  files.give(reply.get(), reply_file);
  Child child(spawn(program, files));
  write.close();

  // The end of the log wakes us at once. That alone is not enough: a process forked by another thread at this
  // moment, or by the worker, may hold the pipe open.
  Log log(std::move(read));
  using std::chrono::milliseconds;
  bool in_time = true;
  while (!child.has_ended() && (in_time = Clock::now() < deadline)) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
    log.wait(std::clamp(left, milliseconds(0), milliseconds(log.is_open() ? 100 : 1)));
  }
  child.kill();
  log.drain();
  WorkerEnd end = child.end();
  if (!in_time) end.how = WorkerEnd::How::timed_out;
  end.log = log.take();
  return end;
}

}  // namespace multimesh::tetgen
