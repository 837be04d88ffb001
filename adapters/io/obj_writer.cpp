// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/obj_writer.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <memory>
#include <string_view>

#include "adapters/io/atomic_file.hpp"

namespace multimesh::io {
namespace {

/// Collects text and hands it to the file in large pieces.
class TextBuffer {
 public:
  explicit TextBuffer(AtomicFile& file) : file_(file) {}

  void text(std::string_view s) {
    if (s.empty()) return;
    if (s.size() > capacity - used_) flush();
    if (s.size() > capacity) return file_.write(s);
    std::memcpy(data_.get() + used_, s.data(), s.size());
    used_ += s.size();
  }

  /// \pre at least 64 bytes of room, see room().
  void character(char c) { data_[used_++] = c; }

  template <class Number>
  void number(Number value) {
    char* const at = data_.get() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(at, at + 32, value).ptr - at);
  }

  /// Makes room for one line of numbers (seven of 32 characters at most).
  void room() {
    if (capacity - used_ < 512) flush();
  }

  void flush() {
    file_.write({data_.get(), used_});
    used_ = 0;
  }

 private:
  static constexpr std::size_t capacity = std::size_t{1} << 20U;
  AtomicFile& file_;
  std::unique_ptr<char[]> data_ = std::make_unique_for_overwrite<char[]>(capacity);
  std::size_t used_ = 0;
};

template <std::size_t N>
void put(TextBuffer& out, const std::array<double, N>& numbers) {
  for (const double n : numbers) {
    out.character(' ');
    out.number(n);
  }
}

template <std::size_t N>
void put_lines(TextBuffer& out, std::string_view word, const std::vector<std::array<double, N>>& lines) {
  for (const auto& numbers : lines) {
    out.room();
    out.text(word);
    put(out, numbers);
    out.character('\n');
  }
}

void put_positions(TextBuffer& out, const PolygonSoup& soup) {
  if (soup.colors.empty()) return put_lines(out, "v", soup.positions);
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    out.room();
    out.character('v');
    put(out, soup.positions[i]);
    put(out, soup.colors[i]);
    out.character('\n');
  }
}

void put_corner(TextBuffer& out, const PolygonSoup::Corner& c, bool normals) {
  out.room();
  out.character(' ');
  out.number(c.v + 1);
  const bool has_normal = normals && c.vn >= 0;
  if (c.vt < 0 && !has_normal) return;
  out.character('/');
  if (c.vt >= 0) out.number(c.vt + 1);
  if (!has_normal) return;
  out.character('/');
  out.number(c.vn + 1);
}

void put_line(TextBuffer& out, std::string_view word, std::string_view rest) {
  out.text(word);
  out.text(rest);
  out.text("\n");
}

/// The statement when the value changed; `off` stands for an empty value, nothing when `off` is empty.
void put_change(TextBuffer& out, std::string_view word, const std::string& before, const std::string& now,
                std::string_view off = {}) {
  if (before == now) return;
  const std::string_view name = now.empty() ? off : std::string_view(now);
  out.text(word);
  if (!name.empty()) out.text(" ");
  out.text(name);
  out.text("\n");
}

void put_section(TextBuffer& out, const PolygonSoup::Section& before, const PolygonSoup::Section& now) {
  put_change(out, "o", before.object, now.object);
  put_change(out, "g", before.group, now.group);
  put_change(out, "usemtl", before.material, now.material);
  put_change(out, "s", before.smoothing, now.smoothing, "off");
}

void put_faces(TextBuffer& out, const PolygonSoup& soup, bool normals) {
  const PolygonSoup::Section none;
  const PolygonSoup::Section* current = &none;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    if (!soup.face_section.empty()) {
      const PolygonSoup::Section* next = &soup.sections[soup.face_section[f]];
      if (next != current) put_section(out, *current, *next);
      current = next;
    }
    out.text("f");
    for (const auto& corner : soup.face(f)) put_corner(out, corner, normals);
    out.text("\n");
  }
}

}  // namespace

void write_obj(const std::filesystem::path& path, const PolygonSoup& soup, const WriteOptions& options) {
  AtomicFile file(path);
  TextBuffer out(file);
  for (const std::string& line : options.header) put_line(out, "# ", line);
  for (const std::string& name : soup.material_libraries) put_line(out, "mtllib ", name);
  put_positions(out, soup);
  put_lines(out, "vt", soup.texcoords);
  if (options.normals) put_lines(out, "vn", soup.normals);
  put_faces(out, soup, options.normals);
  out.flush();
  file.commit();
}

}  // namespace multimesh::io
