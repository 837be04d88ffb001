// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::figures {

/// A drawing in points, y downwards.
class Svg {
 public:
  /// `title` and `description` are for readers who cannot see it.
  Svg(double width, double height, const std::string& title, const std::string& description);
  void polygon(const std::vector<Vec2>& points, const std::string& fill);
  void line(const Vec2& p, const Vec2& q, const std::string& color, double width);
  void dot(const Vec2& p, double radius, const std::string& color);
  void text(const Vec2& p, const std::string& words, double size = 11, const std::string& anchor = "middle");
  void write(const std::filesystem::path& file) const;

 private:
  std::ostringstream out_;
};

/// The colour of the i-th of several things; readable on white, and apart for colour-blind readers.
std::string color(std::size_t i);

/// Fits a box of coordinates into a rectangle of the drawing, y upwards to y downwards.
class Fit {
 public:
  Fit(const std::vector<Vec2>& points, Vec2 corner, Vec2 size);
  Vec2 operator()(const Vec2& p) const;

 private:
  Vec2 low_{0, 0}, offset_{0, 0};
  double scale_ = 1, height_ = 0;
};

}  // namespace multimesh::figures
