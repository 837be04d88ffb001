// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tools/base64.hpp"

namespace multimesh::tools {

namespace {

/// Bytes of numbers, in the order that the page expects on any machine.
class Numbers {
 public:
  void add(std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) bytes_ += static_cast<char>(word >> shift & 0xffU);
  }
  void add(float x) { add(std::bit_cast<std::uint32_t>(x)); }
  void add(double x) { add(static_cast<float>(x)); }
  std::string text() const { return base64(bytes_); }

 private:
  std::string bytes_;
};

/// One block with the numbers that `fill` adds.
template <class Fill>
void write_filled(io::AtomicFile& file, const std::string& id, const Fill& fill) {
  Numbers numbers;
  fill(numbers);
  write_block(file, id, numbers.text());
}

bool has_texcoords(const TexturedTriangles& surface) {
  return std::ranges::any_of(surface.triangles, [](const auto& t) { return t[0].texcoord >= 0; });
}

}  // namespace

HtmlFrame common_frame(const TexturedTriangles& before, const TexturedTriangles& after) {
  constexpr double most = std::numeric_limits<double>::max();
  Vec3 low(most, most, most), high = -low;
  for (const TexturedTriangles* mesh : {&before, &after})
    for (const auto& triangle : mesh->triangles)
      for (const auto& corner : triangle) {
        const auto& p = mesh->positions[static_cast<std::size_t>(corner.position)];
        low = min(low, p), high = max(high, p);
      }
  if (low[0] > high[0]) return {};
  const double size = (high - low).norm();
  return {low / 2 + high / 2, size > 0 && std::isfinite(size) ? size : 1};
}

void write_block(io::AtomicFile& file, const std::string& id, std::string_view text) {
  file.write("<script type=\"text/plain\" id=\"" + id + "\">");
  file.write(text);
  file.write("</script>\n");
}

void write_numbers(io::AtomicFile& file, const std::string& id, const std::vector<double>& values) {
  write_filled(file, id, [&](Numbers& n) {
    for (const double x : values) n.add(x);
  });
}

void write_blocks(io::AtomicFile& file, const std::string& name, const HtmlMesh& mesh,
                  const HtmlFrame& frame) {
  const TexturedTriangles& surface = mesh.surface;
  const bool textured = has_texcoords(surface);
  write_filled(file, name + "-positions", [&](Numbers& n) {
    for (const auto& p : surface.positions)
      for (const double x : frame(p)) n.add(x);
  });
  write_filled(file, name + "-texcoords", [&](Numbers& n) {
    for (const auto& p : surface.texcoords)
      for (const double x : p) n.add(x);
  });
  write_filled(file, name + "-position", [&](Numbers& n) {
    for (const auto& t : surface.triangles)
      for (const auto& corner : t) n.add(static_cast<std::uint32_t>(corner.position));
  });
  write_filled(file, name + "-texcoord", [&](Numbers& n) {
    for (const auto& t : surface.triangles)
      for (const auto& corner : t)
        if (textured) n.add(static_cast<std::uint32_t>(corner.texcoord));  // none: 2^32 - 1
  });
  write_filled(file, name + "-material", [&](Numbers& n) {
    for (const Index m : mesh.material)
      if (mesh.materials.size() > 1) n.add(m);
  });
}

}  // namespace multimesh::tools
