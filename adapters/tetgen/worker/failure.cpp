// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/worker/failure.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <new>

#include "adapters/tetgen/file_descriptor.hpp"

namespace multimesh::tetgen::worker {

namespace {

void on_signal(int number) {
  fail(Outcome::signal, number);  // calls pwrite and _exit only
}

[[noreturn]] void on_terminate() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (int code) {
    fail(Outcome::stopped, code);
  } catch (const std::bad_alloc&) {
    fail(Outcome::out_of_memory);
  } catch (...) {
  }
  fail(Outcome::bad_request);
}

}  // namespace

void fail(Outcome outcome, std::int64_t detail) noexcept {
  ReplyHeader reply;
  reply.outcome = outcome;
  reply.detail = static_cast<std::int32_t>(detail);
  const bool written = write_at(reply_file, &reply, sizeof reply, 0);
  ::_exit(written ? 1 : 2);
}

void report_failures() {
  std::set_terminate(on_terminate);
  // TetGen recurses; when it has used up the stack, the handler needs one of its own.
  static std::array<char, 1 << 16> handler_stack;
  stack_t stack{};
  stack.ss_sp = handler_stack.data(), stack.ss_size = handler_stack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::sigaction(number, &action, nullptr);
}

}  // namespace multimesh::tetgen::worker
