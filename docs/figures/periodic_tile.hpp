// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace multimesh::figures {

/// Draws tile.svg: a periodic tile, remeshed and decimated across its sides, each repeated.
void periodic_tiles(const std::filesystem::path& directory);

}  // namespace multimesh::figures
