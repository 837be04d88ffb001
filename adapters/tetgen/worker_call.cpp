// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/worker_call.hpp"

#include <csignal>
#include <cstring>

#include "adapters/tetgen/file_descriptor.hpp"
#include "adapters/tetgen/worker_error.hpp"
#include "adapters/tetgen/worker_process.hpp"
#include "adapters/tetgen/worker_protocol.hpp"

namespace multimesh::tetgen {

namespace {

using Reason = WorkerError::Reason;

std::string signal_name(int number) {
  switch (number) {
    case SIGSEGV:
      return "SIGSEGV";
    case SIGABRT:
      return "SIGABRT";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    case SIGKILL:
      return "SIGKILL";
    default:
      return "signal " + std::to_string(number);
  }
}

/// TetGen's codes for what it throws.
std::string meaning(int code) {
  switch (code) {
    case 1:
      return "it has no memory left";
    case 2:
      return "an error of its own";
    case 3:
      return "the surface intersects itself";
    case 4:
      return "two features of the surface are too close to each other";
    case 5:
      return "two facets are too close to each other";
    case 10:
      return "it does not accept the surface, which may be flat";
    default:
      return "code " + std::to_string(code);
  }
}

/// The first words that the worker printed, for the end of a message.
std::string quoted(const std::string& log) {
  std::string words;
  for (const char c : log.substr(0, 200)) words += c == '\n' || c == '\r' ? ' ' : c;
  words.erase(words.find_last_not_of(' ') + 1);
  return words.empty() ? "" : " (it printed: " + words + ")";
}

FileDescriptor write_request(RequestHeader header, const WorkerInput& input, const std::string& switches) {
  header.points = input.points.size(), header.triangles = input.corners.size() / 3;
  header.holes = input.holes.size();
  if (switches.size() >= sizeof header.switches)
    throw WorkerError(Reason::stopped, "too many switches for TetGen: " + switches);
  std::memcpy(header.switches, switches.c_str(), switches.size() + 1);
  FileDescriptor file = anonymous_file();
  std::uint64_t offset = 0;
  const auto write = [&](const void* data, std::size_t size) {
    const bool written = write_at(file.get(), data, size, offset);
    offset += size;
    return written;
  };
  if (!write(&header, sizeof header) || !write(input.points.data(), input.points.size_bytes()) ||
      !write(input.corners.data(), input.corners.size_bytes()) ||
      !write(input.holes.data(), input.holes.size_bytes()))
    throw WorkerError(Reason::memory, "no space left to hand the surface to the TetGen worker");
  return file;
}

/// The worker's own report goes first: it is there also when the system has kept the exit status.
[[noreturn]] void fail(const ReplyHeader* reply, const WorkerEnd& end) {
  using How = WorkerEnd::How;
  const std::string log = quoted(end.log);
  if (end.how == How::timed_out)
    throw WorkerError(
        Reason::time_out,
        "TetGen did not end within the time limit, which may be too short for this surface, or TetGen does "
        "not end on it at all" +
            log);
  const Outcome outcome = reply ? reply->outcome : Outcome::done;
  if (outcome == Outcome::out_of_memory || (outcome == Outcome::stopped && reply->detail == 1))
    throw WorkerError(Reason::memory, "TetGen ran out of memory" + log);
  if (outcome == Outcome::stopped)
    throw WorkerError(Reason::stopped, "TetGen gave up: " + meaning(reply->detail) + log);
  if (outcome == Outcome::not_positive)
    throw WorkerError(Reason::bad_result,
                      "TetGen made " + std::to_string(reply->detail) + " tetrahedra without volume");
  if (outcome == Outcome::signal || end.how == How::signal)
    throw WorkerError(
        Reason::signal,
        "TetGen ended by " + signal_name(outcome == Outcome::signal ? reply->detail : end.number) + log);
  std::string how = "the TetGen worker ended";
  if (end.how == How::exited) how += " with exit code " + std::to_string(end.number);
  throw WorkerError(Reason::bad_reply, how + " and gave no reply that is understood" + log);
}

/// Reads an array of a reply; false if the reply is too short for it.
template <class T>
bool read_array(int fd, std::uint64_t count, std::uint64_t& offset, std::vector<T>& to) {
  to.resize(count);
  const bool read = read_at(fd, to.data(), count * sizeof(T), offset);
  offset += count * sizeof(T);
  return read;
}

struct Reply {
  RawTetrahedra tetrahedra;
  std::vector<std::array<Index, 2>> pairs;
};

Reply run(const RequestHeader& header, const WorkerInput& input, const std::string& switches,
          const WorkerOptions& options) {
  const FileDescriptor request = write_request(header, input, switches), file = anonymous_file();
  const WorkerEnd end = run_worker(options.program, request, file, options.deadline);

  ReplyHeader h;
  if (!read_at(file.get(), &h, sizeof h, 0) || h.magic != reply_magic) fail(nullptr, end);
  if (h.outcome != Outcome::done || end.how == WorkerEnd::How::timed_out) fail(&h, end);

  // Checked one by one before anything is allocated: the counts may be anything.
  const std::uint64_t size = file_size(file.get());
  std::uint64_t expected = sizeof h;
  const auto add = [&](std::uint64_t count, std::uint64_t bytes) {
    if (count > size / bytes) return false;
    expected += count * bytes;
    return true;
  };
  static_assert(sizeof(RawTetrahedra::Face) == 16);
  if (!add(h.points, 24) || !add(h.tets, 16) || !add(h.faces, 16) || !add(h.pairs, 8) || expected != size)
    fail(nullptr, end);
  Reply reply;
  std::uint64_t offset = sizeof h;
  if (!read_array(file.get(), h.points, offset, reply.tetrahedra.points) ||
      !read_array(file.get(), h.tets, offset, reply.tetrahedra.tets) ||
      !read_array(file.get(), h.faces, offset, reply.tetrahedra.faces) ||
      !read_array(file.get(), h.pairs, offset, reply.pairs))
    fail(nullptr, end);
  return reply;
}

}  // namespace

RawTetrahedra call_worker(const WorkerInput& input, const std::string& switches,
                          const WorkerOptions& options) {
  RequestHeader header;
  header.memory_limit = options.memory_limit;
  return run(header, input, switches, options).tetrahedra;
}

std::vector<std::array<Index, 2>> find_intersections(const WorkerInput& input, const WorkerOptions& options) {
  RequestHeader header;
  header.task = Task::find_intersections;
  header.memory_limit = options.memory_limit;
  std::vector<std::array<Index, 2>> pairs = run(header, input, "pdQ", options).pairs;
  const std::size_t triangles = input.corners.size() / 3;
  std::erase_if(pairs, [&](const auto& p) { return p[0] >= triangles || p[1] >= triangles; });
  return pairs;
}

}  // namespace multimesh::tetgen
