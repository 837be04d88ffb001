// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// All that the core offers: trees of meshes, operations on them, values, embeddings, algorithms of your own.
#include "multimesh/build.hpp"
#include "multimesh/column.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/scheduler.hpp"
#include "multimesh/strata.hpp"
#include "multimesh/validate.hpp"
