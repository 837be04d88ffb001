// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/orient3d.hpp"
