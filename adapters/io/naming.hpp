// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "multimesh/error.hpp"

namespace multimesh::io {

/// Calls `work`. The name of the file is prepended to an InputError that it throws.
template <class Work>
auto naming(const std::filesystem::path& file, Work&& work) {
  try {
    return work();
  } catch (const InputError& e) {
    throw InputError(file.string() + ": " + e.what());
  }
}

}  // namespace multimesh::io
