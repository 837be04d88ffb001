// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/pending_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

#include "adapters/io/atomic_file.hpp"

namespace multimesh::io {
namespace {

enum class State { free, filling, pending };

struct Slot {
  std::atomic<State> state = State::free;
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<State>::is_always_lock_free, "the signal handler may not lock");

std::array<Slot, 64> slots;

// The handler was installed with SA_RESETHAND: the second delivery takes the default action.
extern "C" void remove_pending_and_raise(int signal) {
  remove_pending();
  ::raise(signal);
}

}  // namespace

int remember_pending(const std::string& path) noexcept {
  if (path.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    State expected = State::free;
    if (!slots[i].state.compare_exchange_strong(expected, State::filling)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state = State::pending;
    return static_cast<int>(i);
  }
  return -1;
}

void forget_pending(int slot) noexcept {
  if (slot >= 0) slots[static_cast<std::size_t>(slot)].state = State::free;
}

void remove_pending() noexcept {
  for (const Slot& slot : slots)
    if (slot.state == State::pending) ::unlink(slot.path.data());
}

void install_signal_cleanup() {
  ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails then, with a message
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    if (::sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = remove_pending_and_raise;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace multimesh::io
