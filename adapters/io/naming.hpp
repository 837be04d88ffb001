// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "multimesh/error.hpp"

namespace multimesh::io {

/// Calls `work`. An InputError that it throws gets the name of the file in front.
template <class Work>
auto naming(const std::filesystem::path& file, Work&& work) {
  try {
    return work();
  } catch (const InputError& e) {
    throw InputError(file.string() + ": " + e.what());
  }
}

}  // namespace multimesh::io
