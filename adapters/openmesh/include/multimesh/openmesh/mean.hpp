// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "multimesh/attribute.hpp"

namespace multimesh::openmesh {

/// OpenMesh vectors of integers, such as colours: their products with 0.5 would be truncated, not rounded.
template <class T>
concept IntegerVector = requires {
  typename T::value_type;
  T::size_;
}
&&std::is_integral_v<typename T::value_type>;

/// The point (1-t) a + t b, each component rounded to the nearest integer.
template <IntegerVector T>
typename VertexAttribute<T>::Rule rounded_mean(const std::vector<T>& values) {
  return [&values](Operation, const VertexChange& c) {
    T mean = values[c.a];
    const T& b = values[c.b];
    for (int i = 0; i < static_cast<int>(T::size_); ++i)
      mean[i] = static_cast<typename T::value_type>(std::lround((1 - c.t) * mean[i] + c.t * b[i]));
    return mean;
  };
}

/// The unit vector in the direction of (1-t) a + t b; that of the nearer end where they cancel.
template <class T>
typename VertexAttribute<T>::Rule mean_direction(const std::vector<T>& values) {
  return [&values](Operation, const VertexChange& c) {
    if (c.t <= 0 || c.t >= 1) return values[c.t <= 0 ? c.a : c.b];
    const T mean(values[c.a] * (1 - c.t) + values[c.b] * c.t);
    const auto length = mean.norm();
    return length > 0 ? T(mean / length) : values[c.t < 0.5 ? c.a : c.b];
  };
}

}  // namespace multimesh::openmesh
