// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mfem_reader.hpp"

#include <array>
#include <vector>

#include "adapters/io/cell_shape.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

using enum CellShape;
/// By MFEM's numbers of geometries.
constexpr std::array<CellType, 8> geometries = {{
    {vertex, 1, 1, "point"},
    {edge, 2, 2, "segment"},
    {triangle, 3, 3, "triangle"},
    {quad, 4, 4, "quadrilateral"},
    {tetrahedron, 4, 4, "tetrahedron"},
    {other_volume, 8, 8, "hexahedron"},
    {other_volume, 6, 6, "prism"},
    {other_volume, 5, 5, "pyramid"},
}};

class MfemParser {
 public:
  MfemParser(std::string_view bytes, const std::string& file)
      : words_(bytes, file, '#'), builder_(file, SimplexBuilder::Where::line, 0) {}

  SimplexSoup parse(const ReadOptions& options) {
    begin();
    for (std::string_view name; words_.next(name);) section(name);
    if (!has_vertices_) words_.fail_truncated("the section vertices");
    return builder_.finish(options);
  }

 private:
  void begin() {
    words_.word("the format");
    const std::string_view rest = trimmed(words_.rest_of_line());
    if (rest != "mesh v1.0" && rest != "mesh v1.2")
      words_.fail(
          "of MFEM's formats only 'MFEM mesh v1.0' is read; save the mesh without refinement tree, "
          "NURBS and the like, or as VTU");
  }

  void section(std::string_view name) {
    if (name == "dimension")
      words_.integer("the dimension");
    else if (name == "elements" || name == "boundary")
      elements();
    else if (name == "vertices")
      vertices();
    else if (name == "nodes")
      fail_nodes();
    else if (name == "mfem_mesh_end")
      return;
    else
      words_.fail("the section " + quoted_word(name) + " is not known; save the mesh as 'MFEM mesh v1.0'");
  }

  void elements() {
    for (std::size_t n = words_.count("elements", 6); n > 0; --n) {
      const std::int32_t attribute = words_.integer32("the attribute of an element");
      const std::int64_t geometry = words_.integer("the geometry of an element");
      if (geometry < 0 || geometry >= static_cast<std::int64_t>(geometries.size()))
        words_.fail("geometry " + std::to_string(geometry) + " is not known; correct or remove the element");
      const CellType& type = geometries[static_cast<std::size_t>(geometry)];
      std::vector<std::uint32_t> nodes(type.nodes);
      for (std::uint32_t& node : nodes) {
        const std::int64_t number = words_.integer("a vertex of an element");
        node = builder_.point_index(number, words_.line());
      }
      add_cell(builder_, type, nodes, attribute, words_.line());
    }
  }

  void vertices() {
    const std::size_t count = words_.count("vertices", 0);
    if (words_.peek() == "nodes") {
      words_.word("the section nodes");
      fail_nodes();
    }
    const std::int64_t dimension = words_.integer("the number of coordinates");
    if (dimension < 1 || dimension > 3) words_.fail("vertices must have 1 to 3 coordinates");
    words_.check_count(count, "vertices", 2 * static_cast<std::size_t>(dimension));
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> point{};
      for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c)
        point[c] = words_.number("a coordinate");
      builder_.add_point(point, words_.line());
    }
    has_vertices_ = true;
  }

  [[noreturn]] void fail_nodes() const {
    words_.fail(
        "the mesh is curved or periodic: its vertices have no coordinates, a section 'nodes' has; "
        "save it in MFEM without nodes (Mesh::SetCurvature, removing periodicity), or as VTU");
  }

  WordSource words_;
  SimplexBuilder builder_;
  bool has_vertices_ = false;
};

}  // namespace

SimplexSoup parse_mfem(std::string_view bytes, const std::filesystem::path& path,
                       const ReadOptions& options) {
  return MfemParser(bytes, path.string()).parse(options);
}

}  // namespace multimesh::io
