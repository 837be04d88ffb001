// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/core.hpp"
#include "multimesh/tet.hpp"
