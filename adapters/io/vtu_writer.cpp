// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

#include "adapters/io/base64.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/second_order.hpp"
#include "adapters/io/simplex_format_writers.hpp"

namespace multimesh::io {
namespace {

constexpr std::array<std::uint8_t, 4> cell_types = {1, 3, 5, 10};
constexpr std::array<std::uint8_t, 4> second_order_types = {1, 21, 22, 24};

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  return "UInt8";
}

class VtuWriter {
 public:
  VtuWriter(OutputBuffer& out, bool binary) : out_(out), binary_(binary) {}

  void begin(std::size_t points, std::size_t cells) {
    out_.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"");
    out_.text(std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
    out_.text("\" header_type=\"UInt64\"");
    if (binary_) out_.text(" compressor=\"vtkZLibDataCompressor\"");
    out_.text(">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
    out_.number(points);
    out_.text("\" NumberOfCells=\"");
    out_.number(cells);
    out_.text("\">\n");
  }

  void end() { out_.text("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"); }
  void tag(std::string_view text) { out_.text(text); }

  /// `at(i)` is the i-th of `size` numbers of type T.
  template <class T, class At>
  void array(const char* name, int components, std::size_t size, const At& at) {
    out_.text("<DataArray type=\"");
    out_.text(type_name<T>());
    out_.text("\" Name=\"");
    out_.text(name);
    if (components != 1) {  // scalars do not need it: meshio makes a column of a component
      out_.text("\" NumberOfComponents=\"");
      out_.number(components);
    }
    out_.text(binary_ ? "\" format=\"binary\">\n" : "\" format=\"ascii\">\n");
    if (binary_)
      put_binary<T>(size, at);
    else
      put_text<T>(size, at);
    out_.text("\n</DataArray>\n");
  }

 private:
  template <class T, class At>
  void put_text(std::size_t size, const At& at) {
    for (std::size_t i = 0; i < size; ++i) {
      if (i != 0) out_.character(i % 12 == 0 ? '\n' : ' ');
      if constexpr (std::is_same_v<T, std::uint8_t>)
        out_.number(static_cast<int>(at(i)));
      else
        out_.number(static_cast<T>(at(i)));
    }
  }

  /// Blocks of one size, each compressed, after a header that has their sizes.
  template <class T, class At>
  void put_binary(std::size_t size, const At& at) {
    constexpr std::size_t per_block = (std::size_t{1} << 18U) / sizeof(T);
    const std::size_t blocks = (size + per_block - 1) / per_block, rest = size % per_block;
    std::string header, data, block;
    append<std::uint64_t>(header, blocks);
    append<std::uint64_t>(header, per_block * sizeof(T));
    append<std::uint64_t>(header, rest * sizeof(T));
    for (std::size_t begin = 0; begin < size; begin += per_block) {
      block.clear();
      for (std::size_t i = begin; i < std::min(size, begin + per_block); ++i)
        append<T>(block, static_cast<T>(at(i)));
      const std::string packed = deflate_zlib(block);
      append<std::uint64_t>(header, packed.size());
      data += packed;
    }
    out_.text(encode_base64(header));
    out_.text(encode_base64(data));
  }

  template <class T>
  static void append(std::string& bytes, T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(T));
    std::memcpy(bytes.data() + at, &value, sizeof(T));
  }

  OutputBuffer& out_;
  bool binary_;
};

/// The values of one kind of all cells, dimension by dimension.
struct CellArrays {
  std::vector<std::int64_t> connectivity, ends;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> tags;
};

CellArrays cell_arrays(const SimplexSoup& soup) {
  CellArrays cells;
  for (std::size_t k = 0; k < 4; ++k) {
    const SimplexSoup::Block& block = soup.simplices[k];
    if (block.size() == 0) continue;
    const std::size_t nodes = nodes_per_simplex(block);
    const std::size_t first = cells.connectivity.size();
    cells.connectivity.insert(cells.connectivity.end(), block.corners.begin(), block.corners.end());
    if (nodes == 10)  // Gmsh's order of the last two is the other one
      for (std::size_t i = first; i < cells.connectivity.size(); i += nodes)
        std::swap(cells.connectivity[i + 8], cells.connectivity[i + 9]);
    cells.tags.insert(cells.tags.end(), block.tags.begin(), block.tags.end());
    cells.types.insert(cells.types.end(), block.size(), (nodes > k + 1 ? second_order_types : cell_types)[k]);
    for (std::size_t i = 0; i < block.size(); ++i)
      cells.ends.push_back((cells.ends.empty() ? 0 : cells.ends.back()) + static_cast<std::int64_t>(nodes));
  }
  return cells;
}

}  // namespace

void put_vtu(OutputBuffer& out, const SimplexSoup& soup, bool binary, Lost& lost) {
  const CellArrays cells = cell_arrays(soup);
  const auto of = [](const auto& values) { return [&values](std::size_t i) { return values[i]; }; };
  VtuWriter writer(out, binary);
  writer.begin(soup.points.size(), cells.types.size());
  writer.tag("<Points>\n");
  writer.array<double>("Points", 3, 3 * soup.points.size(),
                       [&](std::size_t i) { return soup.points[i / 3][i % 3]; });
  writer.tag("</Points>\n<Cells>\n");
  writer.array<std::int64_t>("connectivity", 1, cells.connectivity.size(), of(cells.connectivity));
  writer.array<std::int64_t>("offsets", 1, cells.ends.size(), of(cells.ends));
  writer.array<std::uint8_t>("types", 1, cells.types.size(), of(cells.types));
  writer.tag("</Cells>\n<CellData>\n");
  writer.array<std::int32_t>("tag", 1, cells.tags.size(), of(cells.tags));
  writer.tag("</CellData>\n");
  writer.end();
  if (!soup.groups.empty()) lost.push_back("names of groups");
  if (!soup.point_tags.empty()) lost.push_back("tags of points");
  if (has_flags(soup)) lost.push_back("flags of simplices");
}

}  // namespace multimesh::io
