// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Files as domains, and domains as files.
#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/materials.hpp"
#include "multimesh/files/polylines.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/files/tile_file.hpp"
