// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// Exchanges the first two vertices of facets until any two that share a side alone have opposite
/// orientations there. Of each component, the first facet is turned if `mirror` says so, and gives the
/// orientation. Curves are left as they are.
///
/// \return whether that is possible
bool orient(Complex& c, const std::function<bool()>& mirror = {});

}  // namespace multimesh::oracle
