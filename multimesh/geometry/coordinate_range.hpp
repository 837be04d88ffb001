// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace multimesh {

/// Whether a model has a size that can be computed with. Areas, volumes and energies are products of up to
/// six lengths: in a model within these bounds they neither overflow nor vanish.
class CoordinateRange {
 public:
  static constexpr double largest_coordinate = 1e40, least_extent = 1e-40;

  /// Adds a point that the model uses, with its number for the message.
  void add(std::size_t number, const double* point) {
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], point[i]);
      high_[i] = std::max(high_[i], point[i]);
      const double size = std::isnan(point[i]) ? far : std::abs(point[i]);
      if (size <= largest_) continue;
      largest_ = size;
      number_ = number;
    }
  }

  /// One sentence, or empty: none. Points are counted from `first`.
  std::string problem(std::size_t first = 0) const {
    std::ostringstream out;
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, high_[i] - low_[i]);
    if (largest_ > largest_coordinate) {
      out << "point " << number_ + first << " (from " << first << ") has a coordinate of size " << largest_
          << ", above " << largest_coordinate << ", where products of lengths overflow; scale the model down";
    } else if (extent > 0 && extent < least_extent) {
      out << "the model measures " << extent << ", below " << least_extent
          << ", where products of lengths vanish; scale the model up";
    }
    return out.str();
  }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 3> low_{far, far, far}, high_{-far, -far, -far};
  double largest_ = 0;
  std::size_t number_ = 0;
};

}  // namespace multimesh
