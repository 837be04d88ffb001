// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace multimesh::tetgen {

/// The program multimesh-tetgen-worker. The first of: the environment variable MULTIMESH_TETGEN_WORKER; the
/// folder of the running program, ../libexec/multimesh from there; the folder it was installed to; the folder
/// it was built in. If the variable is set, the others are not tried. \throw WorkerError (missing)
std::filesystem::path worker_path();

}  // namespace multimesh::tetgen
