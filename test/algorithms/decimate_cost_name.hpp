// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

#include "multimesh/algorithms/decimate.hpp"

namespace multimesh {

/// As a part of a test's name.
inline const char* name_of(DecimateCost cost) {
  return cost == DecimateCost::length ? "Length" : "Quadric";
}

/// Used by GoogleTest, which would otherwise print the bytes of a parameter.
inline void PrintTo(DecimateCost cost, std::ostream* out) {
  *out << name_of(cost);
}

}  // namespace multimesh
