// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace multimesh::tetgen {

// What the library and its worker exchange, through two files that both have open. Both are from the same
// build and on the same machine: plain structs, native byte order. A request is its header, points (3 doubles
// each), triangles (3 Index each) and a point in each hole. A reply is its header, points, tetrahedra (4
// Index), faces (3 Index and the triangle, or no_index), pairs of triangles that intersect (2 Index). The
// reply's header is written last, so that a worker that ends early leaves none, or the one written by its
// failure handlers.

inline constexpr std::uint64_t request_magic = 0x3152'5447'4d4d'0002;  // changes with the structs below
inline constexpr std::uint64_t reply_magic = 0x3153'5447'4d4d'0001;

/// The worker's file descriptors. Its log, standard output and error, is a pipe whose read end is with the
/// library; the write end is the worker's.
inline constexpr int request_file = 0, log_file = 1, reply_file = 3;

enum class Task : std::uint32_t { tetrahedralize, find_intersections };

struct RequestHeader {
  std::uint64_t magic = request_magic;
  Task task = Task::tetrahedralize;
  std::uint32_t unused = 0;
  std::uint64_t points = 0, triangles = 0, holes = 0;
  std::uint64_t memory_limit = 0;  ///< bytes; 0: none
  char switches[128] = {};         ///< TetGen's, ended by a zero
};

enum class Outcome : std::uint32_t {
  done,
  stopped,        ///< TetGen threw; detail is its code
  signal,         ///< detail is its number
  out_of_memory,  ///< the memory limit, or the machine's
  not_positive,   ///< tetrahedra without volume; detail of them
  bad_request
};

struct ReplyHeader {
  std::uint64_t magic = reply_magic;
  Outcome outcome = Outcome::done;
  std::int32_t detail = 0;
  std::uint64_t points = 0, tets = 0, faces = 0, pairs = 0;
};

}  // namespace multimesh::tetgen
