// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/worker_path.hpp"

#include <unistd.h>

#include <cstdlib>
#include <system_error>
#include <vector>

#include "adapters/tetgen/worker_error.hpp"

namespace multimesh::tetgen {

namespace {

constexpr const char* name = "multimesh-tetgen-worker";
constexpr const char* variable = "MULTIMESH_TETGEN_WORKER";

bool is_program(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::filesystem::path worker_path() {
  if (const char* named = std::getenv(variable); named && *named) {
    if (is_program(named)) return named;
    throw WorkerError(WorkerError::Reason::missing, std::string(variable) + " names no program: " + named);
  }
  std::vector<std::filesystem::path> candidates;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    candidates.push_back(self.parent_path() / name);
    candidates.push_back(self.parent_path().parent_path() / "libexec" / "multimesh" / name);
  }
  candidates.push_back(std::filesystem::path(MULTIMESH_TETGEN_INSTALLED) / name);
  candidates.push_back(std::filesystem::path(MULTIMESH_TETGEN_BUILT) / name);
  std::string tried;
  for (const std::filesystem::path& candidate : candidates) {
    if (is_program(candidate)) return candidate;
    tried += (tried.empty() ? "" : ", ") + candidate.parent_path().string();
  }
  throw WorkerError(WorkerError::Reason::missing, std::string("there is no program ") + name + " in " +
                                                      tried + "; name it by the environment variable " +
                                                      variable);
}

}  // namespace multimesh::tetgen
