// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/vtk_reader.hpp"

#include <array>
#include <bit>
#include <type_traits>

#include "adapters/io/simplex_builder.hpp"
#include "adapters/io/text_cursor.hpp"
#include "adapters/io/vtk_cells.hpp"
#include "adapters/io/vtk_numbers.hpp"
#include "adapters/io/word_source.hpp"

namespace multimesh::io {
namespace {

struct NumberType {
  std::string_view name;  ///< as in legacy files
  std::string_view type;  ///< as in append_numbers
  std::size_t size;
};

constexpr std::array<NumberType, 15> number_types = {{{"double", "Float64", 8},
                                                      {"float", "Float32", 4},
                                                      {"int", "Int32", 4},
                                                      {"unsigned_int", "UInt32", 4},
                                                      {"vtktypeint64", "Int64", 8},
                                                      {"vtktypeuint64", "UInt64", 8},
                                                      {"long", "Int64", 8},
                                                      {"unsigned_long", "UInt64", 8},
                                                      {"vtktypeint32", "Int32", 4},
                                                      {"vtkidtype", "Int32", 4},
                                                      {"short", "Int16", 2},
                                                      {"unsigned_short", "UInt16", 2},
                                                      {"char", "Int8", 1},
                                                      {"signed_char", "Int8", 1},
                                                      {"unsigned_char", "UInt8", 1}}};

class VtkParser {
 public:
  VtkParser(std::string_view bytes, const std::string& file)
      : words_(bytes, file), builder_(file, SimplexBuilder::Where::element, 0) {}

  SimplexSoup parse(const ReadOptions& options) {
    begin();
    for (std::string_view word; !stopped_ && words_.next(word);) section(lower_case(word));
    if (cells_.types.size() != cells_.ends.size())
      words_.fail("the file has " + std::to_string(cells_.ends.size()) + " cells and " +
                  std::to_string(cells_.types.size()) + " cell types; get it whole");
    if (cells_.tags.size() != cells_.types.size()) cells_.tags.clear();
    add_vtk_cells(builder_, cells_, 0, 0);
    return builder_.finish(options);
  }

 private:
  void begin() {
    for (int i = 0; i < 2; ++i) {  // '# vtk DataFile …', and an arbitrary title
      words_.rest_of_line();
      words_.end_of_line();
    }
    const std::string encoding = lower_case(words_.word("ASCII or BINARY"));
    if (encoding != "ascii" && encoding != "binary")
      words_.fail("ASCII or BINARY has to come here; correct it");
    binary_ = encoding == "binary";
    const std::string keyword = lower_case(words_.word("DATASET"));
    const std::string type = lower_case(words_.word("the type of the dataset"));
    if (keyword != "dataset" || (type != "unstructured_grid" && type != "polydata"))
      words_.fail("only DATASET UNSTRUCTURED_GRID and POLYDATA are read, not " + quoted_word(type) +
                  "; convert it");
  }

  void section(const std::string& name) {
    if (name == "points") return points();
    if (name == "cells") return cells();
    for (const VtkPolyKind& kind : vtk_poly_kinds)
      if (name == kind.section) return poly_cells(kind.type);
    if (name == "cell_types") return types();
    if (name == "cell_data" || name == "point_data") return data(name == "cell_data");
    if (name == "field") return field();
    if (name == "scalars") return scalars();
    if (name == "lookup_table") return lookup_table();
    if (name == "vectors" || name == "normals") return skip_attribute(3);
    if (name == "tensors") return skip_attribute(9);
    if (name == "texture_coordinates") return texture_coordinates();
    if (name == "metadata") return metadata();
    if (data_size_ == 0)
      words_.fail("the section " + quoted_word(name) + " is not known; save the mesh again");
    builder_.left_out(name + " and what follows it");
    stopped_ = true;
  }

  void points() {
    const std::size_t count = words_.count("points", 6);
    const auto numbers = read<double>(words_.word("the type of points"), 3 * count);
    builder_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i)
      builder_.add_point({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}, i);
  }

  void poly_cells(std::int64_t type) {
    cells();
    cells_.types.resize(cells_.ends.size(), type);
  }

  /// Before version 5: each cell its size and its points. Since: OFFSETS and CONNECTIVITY.
  void cells() {
    const std::size_t count = words_.count("cells", 1);
    const std::size_t size = words_.count("entries of cells", 1);
    if (lower_case(words_.peek()) == "offsets") return new_cells(count, size);
    const auto numbers = read<std::int64_t>("int", size);
    std::size_t at = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const std::int64_t corners = at < size ? numbers[at++] : -1;
      if (corners < 0 || static_cast<std::uint64_t>(corners) > size - at)
        words_.fail("cell " + std::to_string(c) +
                    " has more points than there are entries; save the mesh again");
      const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at);
      cells_.connectivity.insert(cells_.connectivity.end(), begin, begin + corners);
      at += static_cast<std::size_t>(corners);
      cells_.ends.push_back(static_cast<std::int64_t>(cells_.connectivity.size()));
    }
  }

  void new_cells(std::size_t offsets, std::size_t size) {
    words_.word("OFFSETS");
    const auto ends = read<std::int64_t>(words_.word("the type of offsets"), offsets);
    if (lower_case(words_.word("CONNECTIVITY")) != "connectivity")
      words_.fail("CONNECTIVITY has to come here; save the mesh again");
    const auto points = read<std::int64_t>(words_.word("the type of the connectivity"), size);
    if (ends.empty() || ends.front() != 0) words_.fail("the offsets must begin with 0");
    const auto before = static_cast<std::int64_t>(cells_.connectivity.size());
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] < 0 || ends[i] > static_cast<std::int64_t>(size))
        words_.fail("cell " + std::to_string(i - 1) + " ends at entry " + std::to_string(ends[i]) +
                    " of the connectivity, which is out of range; save the mesh again");
      cells_.ends.push_back(before + ends[i]);
    }
    cells_.connectivity.insert(cells_.connectivity.end(), points.begin(), points.end());
  }

  void types() {
    const std::size_t count = words_.count("cell types", 1);
    cells_.types = read<std::int64_t>("int", count);
  }

  void data(bool of_cells) {
    const std::size_t count = words_.count("values", 1);
    if (of_cells && count != cells_.types.size())
      words_.fail("there are " + std::to_string(count) + " values for " +
                  std::to_string(cells_.types.size()) + " cells; save the mesh again");
    of_cells_ = of_cells;
    data_size_ = count;
  }

  void scalars() {
    const std::string name(words_.word("the name of scalars"));
    const std::string type = lower_case(words_.word("the type of scalars"));
    std::size_t components = 1;
    if (words_.peek() != "LOOKUP_TABLE") components = words_.count("components", 0);
    words_.word("LOOKUP_TABLE");
    words_.word("the name of the lookup table");
    values(name, type, components, data_size_);
  }

  void field() {
    words_.word("the name of a field");
    for (std::size_t n = words_.count("arrays", 6); n > 0; --n) {
      if (lower_case(words_.peek()) == "metadata") {
        words_.word("METADATA");
        metadata();
      }
      const std::string name(words_.word("the name of an array"));
      const std::size_t components = words_.count("components", 0);
      const std::size_t tuples = words_.count("values", 1);
      values(name, lower_case(words_.word("the type of an array")), components, tuples);
    }
  }

  /// An array that is left out, or the tags.
  void values(const std::string& name, const std::string& type, std::size_t components, std::size_t tuples) {
    if (components > 1000) words_.fail("more than 1000 components are not possible; save the mesh again");
    if (type == "string" || type == "bit" || type == "variant") {
      builder_.left_out("array " + name + " and what follows it");
      stopped_ = true;
      return;
    }
    const bool whole = type != "double" && type != "float";
    if (!of_cells_ || data_size_ == 0 || components != 1 || tuples != data_size_ || !whole) {
      read<double>(type, components * tuples);
      return builder_.left_out("array " + name);
    }
    const auto tags = read<std::int64_t>(type, tuples);
    const bool had_one = choice_.has_choice();
    if (!choice_.offer(name)) return builder_.left_out("array " + name);
    if (had_one) builder_.left_out("array of other whole numbers");
    cells_.tags.clear();
    for (const std::int64_t tag : tags) {
      if (tag != static_cast<std::int32_t>(tag))
        words_.fail("a tag does not fit into 32 bits; renumber the tags");
      cells_.tags.push_back(static_cast<std::int32_t>(tag));
    }
  }

  void skip_attribute(std::size_t components) {
    const std::string name(words_.word("the name of an array"));
    read<double>(lower_case(words_.word("the type of an array")), components * data_size_);
    builder_.left_out("array " + name);
  }

  void texture_coordinates() {
    const std::string name(words_.word("the name of an array"));
    const std::size_t components = words_.count("components", 0);
    if (components > 3) words_.fail("more than 3 texture coordinates are not possible; save the mesh again");
    read<double>(lower_case(words_.word("the type of an array")), components * data_size_);
    builder_.left_out("texture coordinates " + name);
  }

  void lookup_table() {
    const std::string name(words_.word("the name of a lookup table"));
    const std::size_t size = words_.count("colours", 4);
    if (binary_)
      read<double>("unsigned_char", 4 * size);
    else
      read<double>("float", 4 * size);
  }

  /// Up to an empty line.
  void metadata() {
    if (!words_.skip_past("\n\n") && !words_.skip_past("\r\n\r\n")) stopped_ = true;
  }

  template <class T>
  std::vector<T> read(std::string_view type_name, std::size_t count) {
    const std::string name = lower_case(type_name);
    const NumberType* type = nullptr;
    for (const NumberType& known : number_types)
      if (known.name == name) type = &known;
    if (type == nullptr)
      words_.fail("the number type " + quoted_word(name) + " is not read; save the mesh again");
    return binary_ ? read_binary<T>(*type, count) : read_text<T>(count);
  }

  template <class T>
  std::vector<T> read_text(std::size_t count) {
    words_.check_count(count, "numbers", 2);
    std::vector<T> values;
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (std::is_integral_v<T>)
        values.push_back(words_.integer("an array"));
      else
        values.push_back(words_.number("an array"));
    }
    return values;
  }

  /// The bytes begin on the next line, and are big-endian.
  template <class T>
  std::vector<T> read_binary(const NumberType& type, std::size_t count) {
    words_.rest_of_line();
    words_.end_of_line();
    if (count > words_.left() / type.size) words_.fail_truncated("the end of an array");
    std::vector<T> values;
    if (!append_numbers(type.type, words_.raw(count * type.size, "binary data"),
                        std::endian::native == std::endian::little, values))
      words_.fail("an array has numbers that are not whole; save the mesh again");
    return values;
  }

  WordSource words_;
  SimplexBuilder builder_;
  VtkCells cells_;
  VtkTagChoice choice_;
  bool binary_ = false;
  bool of_cells_ = false;
  bool stopped_ = false;
  std::size_t data_size_ = 0;
};

}  // namespace

SimplexSoup parse_vtk(std::string_view bytes, const std::filesystem::path& path, const ReadOptions& options) {
  return VtkParser(bytes, path.string()).parse(options);
}

}  // namespace multimesh::io
