// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "multimesh/error.hpp"

namespace multimesh::io {

/// \throw InputError `FILE:LINE: message`, always.
[[noreturn]] inline void fail_at(std::string_view file, std::size_t line, std::string_view message) {
  throw InputError(std::string(file) + ":" + std::to_string(line) + ": " + std::string(message));
}

/// \throw InputError `FILE: message`, always.
[[noreturn]] inline void fail_file(std::string_view file, std::string_view message) {
  throw InputError(std::string(file) + ": " + std::string(message));
}

}  // namespace multimesh::io
