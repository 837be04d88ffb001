// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Those of the library multimesh::algorithms; compare, remesh and improve are libraries of their own.
#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/subdivide.hpp"
#include "multimesh/algorithms/surface_report.hpp"
