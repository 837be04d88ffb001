// SPDX-License-Identifier: BSD-3-Clause
#include "test/benchmark/plain_obj.hpp"

#include <charconv>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace multimesh::bench {
namespace {

struct Corner {
  std::uint32_t v = PlainObj::none, vt = PlainObj::none;
};

void skip_blanks(const char*& p, const char* end) {
  while (p != end && (*p == ' ' || *p == '\t' || *p == '\r')) ++p;
}

template <class Number>
bool read_number(const char*& p, const char* end, Number& value) {
  skip_blanks(p, end);
  const auto [next, error] = std::from_chars(p, end, value);
  if (error != std::errc{}) return false;
  p = next;
  return true;
}

template <std::size_t n>
std::array<double, n> read_point(const char* p, const char* end) {
  std::array<double, n> point{};
  for (double& x : point)
    if (!read_number(p, end, x)) throw std::runtime_error("a number is missing");
  return point;
}

bool read_corner(const char*& p, const char* end, Corner& corner) {
  corner = {};
  if (!read_number(p, end, corner.v)) return false;
  --corner.v;
  if (p != end && *p == '/') {
    ++p;
    if (p != end && *p != '/' && read_number(p, end, corner.vt)) --corner.vt;
  }
  while (p != end && *p != ' ' && *p != '\t' && *p != '\r') ++p;
  return true;
}

void read_face(const char* p, const char* end, PlainObj& obj) {
  Corner first, last, next;
  if (!read_corner(p, end, first) || !read_corner(p, end, last))
    throw std::runtime_error("a corner is missing");
  while (read_corner(p, end, next)) {
    obj.faces.push_back({first.v, last.v, next.v});
    obj.uv_faces.push_back({first.vt, last.vt, next.vt});
    last = next;
  }
}

void read_line(const char* p, const char* end, PlainObj& obj) {
  const std::string_view line(p, static_cast<std::size_t>(end - p));
  if (line.starts_with("v ")) obj.positions.push_back(read_point<3>(p + 2, end));
  if (line.starts_with("vt ")) obj.texcoords.push_back(read_point<2>(p + 3, end));
  if (line.starts_with("f ")) read_face(p + 2, end, obj);
}

void check_indices(const PlainObj& obj) {
  for (const auto& f : obj.faces)
    for (const std::uint32_t v : f)
      if (v >= obj.positions.size()) throw std::runtime_error("a face has no such vertex");
  for (const auto& f : obj.uv_faces)
    for (const std::uint32_t vt : f)
      if (vt >= obj.texcoords.size() && vt != PlainObj::none)
        throw std::runtime_error("a face has no such texture coordinates");
}

/// A file being written, a large piece at a time.
class Writer {
 public:
  explicit Writer(const std::string& path) : file_(std::fopen(path.c_str(), "wb"), &std::fclose) {
    if (!file_) throw std::runtime_error("cannot be written");
    text_.reserve(2 * piece);
  }
  Writer& operator<<(std::string_view s) {
    text_ += s;
    if (text_.size() > piece) flush();
    return *this;
  }
  template <class Number>
  Writer& number(Number x) {
    char digits[32];
    return *this << std::string_view(
               digits,
               static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, x).ptr - digits));
  }
  void flush() {
    if (std::fwrite(text_.data(), 1, text_.size(), file_.get()) != text_.size() ||
        std::fflush(file_.get()) != 0)
      throw std::runtime_error("cannot be written to the end");
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string text_;
};

template <std::size_t n>
void write_points(Writer& out, std::string_view keyword, const std::vector<std::array<double, n>>& points) {
  for (const auto& point : points) {
    out << keyword;
    for (const double x : point) (out << " ").number(x);
    out << "\n";
  }
}

}  // namespace

PlainObj read_plain_obj(const std::string& path) try {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be read");
  PlainObj obj;
  for (std::string line; std::getline(in, line);) read_line(line.data(), line.data() + line.size(), obj);
  check_indices(obj);
  return obj;
} catch (const std::runtime_error& e) {
  throw std::runtime_error(path + ": " + e.what());
}

void write_plain_obj(const std::string& path, const PlainObj& obj) try {
  Writer out(path);
  write_points(out, "v", obj.positions);
  write_points(out, "vt", obj.texcoords);
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    out << "f";
    for (std::size_t k = 0; k < 3; ++k) {
      (out << " ").number(obj.faces[f][k] + 1);
      if (f < obj.uv_faces.size() && obj.uv_faces[f][k] != PlainObj::none)
        (out << "/").number(obj.uv_faces[f][k] + 1);
    }
    out << "\n";
  }
  out.flush();
} catch (const std::runtime_error& e) {
  throw std::runtime_error(path + ": " + e.what());
}

}  // namespace multimesh::bench
