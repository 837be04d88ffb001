// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The compact tetrahedral mesh and its values.
#include "multimesh/tet/tet_mesh.hpp"
