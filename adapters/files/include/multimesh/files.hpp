// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts between files and domains.
#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/files/materials.hpp"
#include "multimesh/files/polylines.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/files/tile_file.hpp"
