// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/vtu_reader.hpp"

#include <algorithm>
#include <pugixml.hpp>

#include "adapters/io/input_location.hpp"
#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/vtk_cells.hpp"
#include "adapters/io/vtu_array.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

/// The file without the bytes of AppendedData, which need not be XML, and those bytes.
struct SplitFile {
  std::string xml;
  std::string_view appended;
};

SplitFile split_appended(std::string_view bytes) {
  const std::size_t element = bytes.find("<AppendedData");
  const std::size_t begin =
      element == std::string_view::npos ? element : bytes.find('_', bytes.find('>', element));
  if (begin == std::string_view::npos) return {std::string(bytes), {}};
  std::string xml(bytes.substr(0, begin));
  return {xml + "</AppendedData></VTKFile>", bytes.substr(begin + 1)};
}

class VtuParser {
 public:
  VtuParser(std::string_view bytes, const std::string& file)
      : split_(split_appended(bytes)), file_(file), builder_(file, SimplexBuilder::Where::element, 0) {}

  SimplexSoup parse(const ReadOptions& options) {
    const pugi::xml_node root = load();
    const VtuArrays arrays(root, split_.xml, split_.appended, file_);
    for (const pugi::xml_node& piece : root.child(poly_ ? "PolyData" : "UnstructuredGrid").children("Piece"))
      read_piece(piece, arrays);
    return builder_.finish(options);
  }

 private:
  pugi::xml_node load() {
    const auto result = document_.load_buffer(split_.xml.data(), split_.xml.size());
    if (!result) {
      const auto at = static_cast<std::size_t>(result.offset);
      const auto line = 1 + std::ranges::count(std::string_view(split_.xml).substr(0, at), '\n');
      fail_at(file_, static_cast<std::size_t>(line),
              std::string("this is not valid XML: ") + result.description() + "; get the file whole");
    }
    const pugi::xml_node root = document_.child("VTKFile");
    const std::string type = root.attribute("type").value();
    if (!root) fail_file(file_, "the XML has no element VTKFile; this is not a file of VTK");
    poly_ = type == "PolyData";
    if ((type != "UnstructuredGrid" && !poly_) || !root.child(type.c_str()))
      fail_file(file_, "the file holds a " + (type.empty() ? "thing without a type" : type) +
                           " of VTK; only UnstructuredGrid and PolyData are read, convert it");
    return root;
  }

  void read_piece(const pugi::xml_node& piece, const VtuArrays& arrays) {
    const auto first_point = static_cast<std::uint32_t>(builder_.soup().points.size());
    read_points(piece, arrays);
    VtkCells cells = poly_ ? read_poly_cells(piece, arrays) : read_cells(piece, arrays);
    read_tags(piece, arrays, cells);
    for (const pugi::xml_node& array : piece.child("PointData").children("DataArray"))
      builder_.left_out(std::string("point array ") + array.attribute("Name").value());
    add_vtk_cells(builder_, cells, first_point, cell_count_);
    cell_count_ += cells.types.size();
  }

  void read_points(const pugi::xml_node& piece, const VtuArrays& arrays) {
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    const std::uint64_t expected = piece.attribute("NumberOfPoints").as_ullong();
    if (!array && expected == 0) return;
    if (!array) fail_file(file_, "a Piece has no array of Points; save the mesh again");
    const std::vector<double> numbers = arrays.reals(array);
    if (numbers.size() % 3 != 0 || numbers.size() / 3 != expected)
      arrays.fail(array, "it has " + std::to_string(numbers.size()) + " numbers, not the three of each of " +
                             std::to_string(expected) + " points; get the file whole");
    builder_.reserve_points(numbers.size() / 3);
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      builder_.add_point({numbers[i], numbers[i + 1], numbers[i + 2]}, i / 3);
  }

  VtkCells read_cells(const pugi::xml_node& piece, const VtuArrays& arrays) const {
    VtkCells cells;
    const std::uint64_t expected = piece.attribute("NumberOfCells").as_ullong();
    const pugi::xml_node parent = piece.child("Cells");
    if (expected == 0) return cells;
    const auto read = [&](const char* name) {
      const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
      if (!array) fail_file(file_, std::string("the Cells have no array ") + name + "; save the mesh again");
      auto values = arrays.integers(array);
      if (name != std::string_view("connectivity") && values.size() != expected)
        arrays.fail(array, "it has " + std::to_string(values.size()) + " numbers for " +
                               std::to_string(expected) + " cells; get the file whole");
      return values;
    };
    cells.connectivity = read("connectivity");
    cells.ends = read("offsets");
    cells.types = read("types");
    return cells;
  }

  VtkCells read_poly_cells(const pugi::xml_node& piece, const VtuArrays& arrays) const {
    VtkCells cells;
    for (const VtkPolyKind& kind : vtk_poly_kinds) {
      const std::string element(kind.element);
      const std::uint64_t expected = piece.attribute(("NumberOf" + element).c_str()).as_ullong();
      const pugi::xml_node parent = piece.child(element.c_str());
      if (expected == 0) continue;
      const auto read = [&](const char* name) {
        const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) fail_file(file_, "the " + element + " have no array " + name + "; save the mesh again");
        return arrays.integers(array);
      };
      const std::vector<std::int64_t> points = read("connectivity"), ends = read("offsets");
      if (ends.size() != expected)
        fail_file(file_, "there are " + std::to_string(ends.size()) + " offsets for " +
                             std::to_string(expected) + " " + element + "; get the file whole");
      const auto before = static_cast<std::int64_t>(cells.connectivity.size());
      for (const std::int64_t end : ends) {
        if (end < 0 || end > static_cast<std::int64_t>(points.size()))
          fail_file(file_, "an offset of the " + element + " is out of range; save the mesh again");
        cells.ends.push_back(before + end);
      }
      cells.connectivity.insert(cells.connectivity.end(), points.begin(), points.end());
      cells.types.resize(cells.ends.size(), kind.type);
    }
    return cells;
  }

  void read_tags(const pugi::xml_node& piece, const VtuArrays& arrays, VtkCells& cells) {
    VtkTagChoice choice;
    const pugi::xml_node data = piece.child("CellData");
    const auto is_scalar = [](const pugi::xml_node& a) {
      return a.attribute("NumberOfComponents").as_int(1) == 1;
    };
    for (const pugi::xml_node& array : data.children("DataArray"))
      if (VtuArrays::holds_integers(array) && is_scalar(array)) choice.offer(array.attribute("Name").value());
    for (const pugi::xml_node& array : data.children("DataArray")) {
      const std::string name = array.attribute("Name").value();
      if (!choice.has_choice() || name != choice.name() || !cells.tags.empty()) {
        builder_.left_out("cell array " + name);
        continue;
      }
      const auto values = arrays.integers(array);
      if (values.size() != cells.types.size())
        arrays.fail(array, "it has " + std::to_string(values.size()) + " numbers for " +
                               std::to_string(cells.types.size()) + " cells; get the file whole");
      for (const std::int64_t value : values) {
        if (value != static_cast<std::int32_t>(value))
          arrays.fail(array,
                      "the tag " + std::to_string(value) + " does not fit into 32 bits; renumber the tags");
        cells.tags.push_back(static_cast<std::int32_t>(value));
      }
    }
  }

  SplitFile split_;
  std::string file_;
  SimplexBuilder builder_;
  pugi::xml_document document_;
  std::uint64_t cell_count_ = 0;
  bool poly_ = false;
};

}  // namespace

SimplexSoup parse_vtu(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  return VtuParser(bytes, path.string()).parse(options);
}

}  // namespace multimesh::io
