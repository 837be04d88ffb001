// SPDX-License-Identifier: BSD-3-Clause
#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace multimesh::figures {

namespace {

/// A tenth of a point is enough, and keeps files small and the same on every machine.
std::string number(double x) {
  const double tenth = std::round(10 * x);
  std::ostringstream s;
  s << (tenth == 0 ? 0.0 : tenth / 10);
  return s.str();
}

}  // namespace

Svg::Svg(double width, double height, const std::string& title, const std::string& description) {
  out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << number(width) << ' ' << number(height)
       << "\" font-family=\"sans-serif\" role=\"img\">\n<title>" << title << "</title>\n<desc>" << description
       << "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
       << "<style>path{stroke:#666;stroke-width:.3;stroke-linecap:round}</style>\n";
}

void Svg::polygon(const std::vector<Vec2>& points, const std::string& fill) {
  out_ << "<path d=\"";
  for (std::size_t i = 0; i < points.size(); ++i)
    out_ << (i == 0 ? 'M' : 'L') << number(points[i][0]) << ' ' << number(points[i][1]);
  out_ << "Z\" fill=\"" << fill << "\"/>\n";
}

void Svg::line(const Vec2& p, const Vec2& q, const std::string& color, double width) {
  out_ << "<path d=\"M" << number(p[0]) << ' ' << number(p[1]) << 'L' << number(q[0]) << ' ' << number(q[1])
       << "\" style=\"stroke:" << color << ";stroke-width:" << number(width) << "\"/>\n";
}

void Svg::dot(const Vec2& p, double radius, const std::string& color) {
  out_ << "<circle cx=\"" << number(p[0]) << "\" cy=\"" << number(p[1]) << "\" r=\"" << number(radius)
       << "\" fill=\"" << color << "\"/>\n";
}

void Svg::text(const Vec2& p, const std::string& words, double size, const std::string& anchor) {
  out_ << "<text x=\"" << number(p[0]) << "\" y=\"" << number(p[1]) << "\" font-size=\"" << number(size)
       << "\" text-anchor=\"" << anchor << "\">" << words << "</text>\n";
}

void Svg::write(const std::filesystem::path& file) const {
  std::ofstream(file, std::ios::binary) << out_.str() << "</svg>\n";
}

std::string color(std::size_t i) {
  constexpr std::array colors{"#9ecae1", "#fdd0a2", "#c7e9c0", "#dadaeb", "#fcbba1", "#d9d9d9",
                              "#c6dbef", "#fee391", "#a1d99b", "#bcbddc", "#fc9272", "#bdbdbd"};
  return colors[i % colors.size()];
}

Fit::Fit(const std::vector<Vec2>& points, Vec2 corner, Vec2 size) {
  Vec2 high = points.front();
  low_ = high;
  for (const Vec2& p : points) low_ = min(low_, p), high = max(high, p);
  const Vec2 extent = high - low_;
  scale_ = std::min(size[0] / std::max(extent[0], 1e-12), size[1] / std::max(extent[1], 1e-12));
  height_ = extent[1];
  offset_ = corner + (size - extent * scale_) / 2;
}

Vec2 Fit::operator()(const Vec2& p) const {
  return offset_ + Vec2(p[0] - low_[0], height_ - (p[1] - low_[1])) * scale_;
}

}  // namespace multimesh::figures
