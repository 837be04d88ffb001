// SPDX-License-Identifier: BSD-3-Clause
// multimesh-tetgen-worker: TetGen in a process of its own, for one surface. Started by the library only.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cstdio>

#include "adapters/tetgen/file_descriptor.hpp"
#include "adapters/tetgen/worker/failure.hpp"
#include "adapters/tetgen/worker/run_tetgen.hpp"

namespace {

using namespace multimesh::tetgen;

/// What the caller's program has open is none of our business, and would stay open as long as we run.
void close_other_files() {
#if defined(__linux__) && defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 34)
  ::close_range(reply_file + 1, ~0U, 0);
#endif
}

void end_with_caller() {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  // It may have ended before: then nobody reads the log.
  pollfd log{log_file, POLLOUT, 0};
  if (::poll(&log, 1, 0) > 0 && (log.revents & POLLERR) != 0) ::_exit(1);
}

void limit_memory(std::uint64_t bytes) {
  if (bytes == 0) return;
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? bytes : std::min<rlim_t>(bytes, limit.rlim_max);
  ::setrlimit(RLIMIT_AS, &limit);
}

/// The request, of which all has been checked but TetGen's own conditions.
worker::Request read_request() {
  worker::Request request;
  RequestHeader& h = request.header;
  if (!read_at(request_file, &h, sizeof h, 0) || h.magic != request_magic) worker::fail(Outcome::bad_request);
  h.switches[sizeof h.switches - 1] = 0;
  limit_memory(h.memory_limit);
  request.points.resize(h.points), request.triangles.resize(h.triangles);
  request.holes.resize(h.holes);
  const std::uint64_t points_end = sizeof h + h.points * 24, triangles_end = points_end + h.triangles * 12;
  if (!read_at(request_file, request.points.data(), h.points * 24, sizeof h) ||
      !read_at(request_file, request.triangles.data(), h.triangles * 12, points_end) ||
      !read_at(request_file, request.holes.data(), h.holes * 24, triangles_end))
    worker::fail(Outcome::bad_request);
  for (const auto& triangle : request.triangles)
    for (const multimesh::Index v : triangle)
      if (v >= h.points) worker::fail(Outcome::bad_request);
  return request;
}

}  // namespace

int main() {
  if (::fcntl(reply_file, F_GETFL) < 0) {
    std::fputs("multimesh-tetgen-worker is started by the multimesh library\n", stderr);
    return 2;
  }
  close_other_files();
  end_with_caller();
  worker::report_failures();
  worker::Request request = read_request();
  if (request.header.task == Task::find_intersections)
    worker::find_intersections(request);
  else
    worker::tetrahedralize(request);
  ::_exit(0);  // nothing is left to do
}
