// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "adapters/io/output_buffer.hpp"
#include "adapters/io/second_order.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Gmsh's type of the simplices of a block of this dimension, of first or second order.
inline std::int32_t msh_type(const SimplexSoup::Block& block, std::size_t dimension) {
  constexpr std::int32_t types[2][4] = {{15, 1, 2, 4}, {15, 8, 9, 11}};
  return types[nodes_per_simplex(block) > dimension + 1 ? 1 : 0][dimension];
}

/// Numbers of a Gmsh file, as text or binary. The counterpart of MshSource.
class MshSink {
 public:
  MshSink(OutputBuffer& out, bool binary) : out_(out), binary_(binary) {}

  bool binary() const { return binary_; }
  /// The same file, with numbers as text.
  MshSink as_text() const { return {out_, false}; }
  void text(std::string_view s) { out_.text(s); }
  void text_number(std::uint64_t value) { out_.number(value); }

  void integer(std::int32_t value) { put(value); }  ///< 4 bytes
  void size(std::uint64_t value) { put(value); }    ///< 8 bytes
  void real(double value) { put(value); }           ///< 8 bytes
  /// Text only.
  void end_line() {
    if (!binary_) out_.character('\n');
  }

  void header(std::string_view version) {
    out_.text("$MeshFormat\n");
    out_.text(version);
    out_.text(binary_ ? " 1 8\n" : " 0 8\n");
    if (binary_) {
      integer(1);  // shows the byte order
      out_.character('\n');
    }
    out_.text("$EndMeshFormat\n");
  }

  void end_section(std::string_view name) {
    if (binary_) out_.character('\n');
    out_.text("$End");
    out_.text(name);
    out_.character('\n');
  }

  /// Names are text in binary files, too.
  void physical_names(const SimplexSoup& soup) {
    if (soup.groups.empty()) return;
    out_.text("$PhysicalNames\n");
    out_.number(soup.groups.size());
    for (const SimplexSoup::Group& group : soup.groups) {
      out_.character('\n');
      out_.number(group.dimension);
      out_.character(' ');
      out_.number(group.tag);
      out_.text(" \"");
      for (const char c : group.name) out_.character(c >= 0 && c < ' ' ? '_' : c);  // quotes unchanged
      out_.text("\"");
    }
    out_.text("\n$EndPhysicalNames\n");
  }

 private:
  template <class T>
  void put(T value) {
    if (binary_) return out_.little_endian(value);
    out_.number(value);
    out_.character(' ');
  }

  OutputBuffer& out_;
  bool binary_;
};

}  // namespace multimesh::io
