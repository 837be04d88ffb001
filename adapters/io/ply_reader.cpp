// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/ply_reader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>

#include "adapters/io/content_check.hpp"
#include "adapters/io/file_bytes.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/ply_body.hpp"
#include "adapters/io/ply_header.hpp"
#include "adapters/io/soup_check.hpp"
#include "adapters/io/texture_pages.hpp"

namespace multimesh::io {
namespace {

enum Role : std::uint8_t { x, y, z, red, green, blue, s, t, vertex_role_count, none };

Role vertex_role(const PlyProperty& property) {
  constexpr std::array<std::pair<std::string_view, Role>, 14> names = {{{"x", x},
                                                                        {"y", y},
                                                                        {"z", z},
                                                                        {"red", red},
                                                                        {"green", green},
                                                                        {"blue", blue},
                                                                        {"s", s},
                                                                        {"t", t},
                                                                        {"u", s},
                                                                        {"v", t},
                                                                        {"texture_u", s},
                                                                        {"texture_v", t},
                                                                        {"texture_s", s},
                                                                        {"texture_t", t}}};
  for (const auto& [name, role] : names)
    if (property.name == name && !property.is_list) return role;
  return none;
}

/// The value of one unit of a colour property.
double color_unit(PlyType type) {
  if (type == PlyType::uint8) return 1 / 255.0;
  if (type == PlyType::uint16) return 1 / 65535.0;
  return 1;
}

bool is_index_list(const PlyProperty& p) {
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}
bool is_texcoord_list(const PlyProperty& p) {
  return p.is_list && p.name == "texcoord";
}

/// A vertex with a texture coordinate; equal ones are one texture coordinate of the soup.
struct Wedge {
  std::int32_t v;
  std::uint64_t s, t;
  friend bool operator==(const Wedge&, const Wedge&) = default;
};
struct WedgeHash {
  std::size_t operator()(const Wedge& w) const {
    std::uint64_t h = static_cast<std::uint64_t>(w.v) * 0x9E3779B97F4A7C15U;
    h = (h ^ w.s) * 0xC2B2AE3D27D4EB4FU;
    h = (h ^ (h >> 31U) ^ w.t) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(h ^ (h >> 29U));
  }
};

/// The number of a face's texture image.
bool is_texture_number(const PlyProperty& p) {
  return !p.is_list && (p.name == "texnumber" || p.name == "texnum");
}

class PlyParser {
 public:
  PlyParser(std::string_view bytes, const std::string& file, std::vector<NonfinitePosition>& nonfinite)
      : file_(file),
        header_(read_ply_header(bytes, file)),
        body_(bytes, header_, file),
        nonfinite_(nonfinite),
        pages_(header_.textures) {}

  PolygonSoup parse() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        vertices(element);
      else if (element.name == "face")
        faces(element);
      else if (element.name == "tristrips")
        strips(element);
      else
        skip(element);
    }
    finish();
    return std::move(soup_);
  }

 private:
  void vertices(const PlyElement& element) {
    std::array<bool, none + 1> present{};
    for (const auto& p : element.properties) present[vertex_role(p)] = true;
    if (!present[x] || !present[y] || !present[z])
      fail_at(file_, element.line,
              "the vertices have no properties x, y and z; export the mesh with positions");
    has_color_ = present[red] && present[green] && present[blue];
    vertex_texcoords_ = present[s] && present[t];
    for (const auto& p : element.properties)
      if (vertex_role(p) == none) left_out("vertex " + p.name);
    for (std::size_t row = 0; row < element.count; ++row) {
      body_.begin_row(element, row);
      vertex(element);
      body_.end_row();
    }
  }

  void vertex(const PlyElement& element) {
    std::array<double, none + 1> n{};
    for (const auto& p : element.properties) {
      const Role role = vertex_role(p);
      if (role == none) {
        skip(p);
        continue;
      }
      n[role] = body_.value(p.type) * (role >= red && role <= blue ? color_unit(p.type) : 1);
    }
    if (!std::isfinite(n[x]) || !std::isfinite(n[y]) || !std::isfinite(n[z]))
      nonfinite_.push_back({static_cast<std::uint32_t>(soup_.positions.size()), body_.line()});
    soup_.positions.push_back({n[x], n[y], n[z]});
    if (has_color_) soup_.colors.push_back({n[red], n[green], n[blue]});
    if (vertex_texcoords_) soup_.texcoords.push_back({n[s], n[t]});
  }

  void faces(const PlyElement& element) {
    if (std::ranges::none_of(element.properties, is_index_list))
      fail_at(file_, element.line, "the faces have no list vertex_indices; export the mesh with faces");
    for (const auto& p : element.properties)
      if (!is_index_list(p) && !is_texcoord_list(p) && !is_texture_number(p)) left_out("face " + p.name);
    const bool numbered = std::ranges::any_of(element.properties, is_texture_number);
    if (!numbered && header_.textures.size() > 1)
      warn("the faces have no texnumber; the first of " + std::to_string(header_.textures.size()) +
           " texture images is taken for all");
    page_ = numbered || !header_.textures.empty() ? 0 : -1;
    for (std::size_t row = 0; row < element.count; ++row) {
      body_.begin_row(element, row);
      for (const auto& p : element.properties) {
        if (is_index_list(p))
          list(p, indices_);
        else if (is_texcoord_list(p))
          list(p, texcoords_);
        else if (is_texture_number(p))
          page_ = page(body_.value(p.type));
        else
          skip(p);
      }
      body_.end_row();
      face();
    }
  }

  /// Lists of vertices of which each three consecutive ones are a triangle, every second one with the
  /// opposite orientation; -1 ends a strip.
  void strips(const PlyElement& element) {
    for (const auto& p : element.properties)
      if (!is_index_list(p)) left_out("strip " + p.name);
    std::vector<double> strip;
    for (std::size_t row = 0; row < element.count; ++row) {
      body_.begin_row(element, row);
      for (const auto& p : element.properties) is_index_list(p) ? list(p, strip) : skip(p);
      body_.end_row();
      add_strips(strip);
    }
  }

  void add_strips(const std::vector<double>& vertices) {
    std::size_t size = 0;  // of the strip up to now
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      size = vertices[i] == -1 ? 0 : size + 1;
      if (size < 3) continue;
      indices_.assign(vertices.begin() + static_cast<std::ptrdiff_t>(i) - 2,
                      vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      if (size % 2 == 0) std::swap(indices_[0], indices_[1]);
      // A repeated vertex turns the strip round a corner, and makes no face.
      const bool turns =
          indices_[0] == indices_[1] || indices_[1] == indices_[2] || indices_[2] == indices_[0];
      if (!turns) face();
    }
  }

  void list(const PlyProperty& property, std::vector<double>& values) {
    values.clear();
    for (std::size_t n = body_.list_size(property.size_type); n > 0; --n)
      values.push_back(body_.value(property.type));
  }

  void face() {
    if (indices_.size() < 3)
      body_.fail("the face has " + std::to_string(indices_.size()) +
                 " corners; remove it or give it three or more");
    if (!texcoords_.empty() && texcoords_.size() != 2 * indices_.size())
      body_.fail("the face has " + std::to_string(indices_.size()) + " corners and " +
                 std::to_string(texcoords_.size()) + " texcoord numbers; give two per corner or none");
    if (soup_.corners.size() + indices_.size() > std::numeric_limits<std::uint32_t>::max())
      body_.fail("more than 4294967295 face corners; split the file");
    for (std::size_t i = 0; i < indices_.size(); ++i) soup_.corners.push_back(corner(i));
    soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.face_line.push_back(static_cast<std::uint32_t>(body_.line()));
    soup_.face_section.push_back(pages_.section(page_, soup_));
    texcoords_.clear();
  }

  std::int64_t page(double number) {
    if (number != std::floor(number) || std::abs(number) > std::numeric_limits<std::int32_t>::max())
      body_.fail("the texture number of the face is not a whole number; correct the face");
    return static_cast<std::int64_t>(number);
  }

  PolygonSoup::Corner corner(std::size_t i) {
    const double v = indices_[i];
    if (!(v >= 0 && v <= std::numeric_limits<std::int32_t>::max()) || v != std::floor(v))
      body_.fail("corner " + std::to_string(i) +
                 " of the face is not a vertex number (0, 1, ...); correct the face");
    PolygonSoup::Corner c{static_cast<std::int32_t>(v), -1, -1};
    if (!texcoords_.empty())
      c.vt = wedge_texcoord(c.v, {texcoords_[2 * i], texcoords_[2 * i + 1]});
    else if (vertex_texcoords_)
      c.vt = c.v;
    return c;
  }

  std::int32_t wedge_texcoord(std::int32_t v, const std::array<double, 2>& uv) {
    // Adding 0 makes -0 and 0 one.
    const Wedge key{v, std::bit_cast<std::uint64_t>(uv[0] + 0.0), std::bit_cast<std::uint64_t>(uv[1] + 0.0)};
    const auto [at, is_new] = wedges_.try_emplace(key, static_cast<std::int32_t>(soup_.texcoords.size()));
    if (is_new) soup_.texcoords.push_back(uv);
    return at->second;
  }

  void skip(const PlyElement& element) {
    left_out(element.name);
    for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      body_.begin_row(element, row);
      for (const auto& p : element.properties) skip(p);
      body_.end_row();
    }
  }

  void skip(const PlyProperty& property) {
    std::size_t n = property.is_list ? body_.list_size(property.size_type) : 1;
    for (; n > 0; --n) body_.value(property.type);
  }

  void left_out(const std::string& name) {
    ++soup_.notes.unknown;
    left_out_ += (left_out_.empty() ? "" : ", ") + name;
  }

  void finish() {
    if (soup_.face_count() == 0) fail_file(file_, "the file has no face; give a surface");
    if (!left_out_.empty()) warn("left out: " + left_out_);
    if (const std::size_t rest = body_.unread(); rest != 0)
      warn(std::to_string(rest) + " bytes after the last element are left out");
  }

  void warn(const std::string& message) { soup_.warnings.push_back(file_ + ": " + message); }

  PolygonSoup soup_;
  std::string file_;
  PlyHeader header_;
  PlyBody body_;
  std::vector<NonfinitePosition>& nonfinite_;
  TexturePages pages_;
  std::int64_t page_ = -1;
  bool has_color_ = false;
  bool vertex_texcoords_ = false;
  std::vector<double> indices_, texcoords_;
  std::unordered_map<Wedge, std::int32_t, WedgeHash> wedges_;
  std::string left_out_;
};

}  // namespace

PolygonSoup read_ply(const std::filesystem::path& path, const ReadOptions& options) {
  return parse_ply(FileBytes(path).view(), path, options);
}

PolygonSoup parse_ply(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  check_ply_content(bytes, file);
  std::vector<NonfinitePosition> nonfinite;
  PolygonSoup soup = PlyParser(bytes, file, nonfinite).parse();
  check_soup(soup, file, 0, options, nonfinite);
  return soup;
}

}  // namespace multimesh::io
