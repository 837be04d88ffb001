// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/tet/tet_mesh.hpp"
#include "multimesh/build.hpp"
#include "multimesh/cut.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"
