// SPDX-License-Identifier: BSD-3-Clause

#include "adapters/io/base64.hpp"
#include "adapters/io/gunzip.hpp"
#include "adapters/io/vtk_reader.hpp"
#include "adapters/io/vtu_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values, bool big = false) {
  std::string bytes;
  for (T value : values) {
    std::string one(reinterpret_cast<const char*>(&value), sizeof(T));
    bytes += big ? std::string(one.rbegin(), one.rend()) : one;
  }
  return bytes;
}

const std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.5F};
const std::vector<std::int32_t> connectivity = {0, 1, 2, 3, 0, 2, 1};
const std::vector<std::int32_t> ends = {4, 7};
const std::vector<std::uint8_t> types = {10, 5};
const std::vector<std::int16_t> tags = {6, -7};

void expect_the_mesh(const SimplexSoup& soup) {
  ASSERT_EQ(soup.points.size(), 4U);
  EXPECT_EQ(soup.points[3], (std::array<double, 3>{0, 0, 1.5}));
  EXPECT_EQ(soup.simplices[3].corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(soup.simplices[2].corners, (std::vector<std::uint32_t>{0, 2, 1}));
  EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{6});
  EXPECT_EQ(soup.simplices[2].tags, std::vector<std::int32_t>{-7});
}

/// How the arrays of a VTU file are stored.
struct Storage {
  bool appended, base64, compressed, wide, big;
};

class VtuMaker {
 public:
  explicit VtuMaker(Storage storage) : s_(storage) {}

  std::string make() {
    std::string body = array("Float32", "Points", 3, bytes_of(points, s_.big));
    body = "<Points>" + body + "</Points><Cells>" +
           array("Int32", "connectivity", 1, bytes_of(connectivity, s_.big)) +
           array("Int32", "offsets", 1, bytes_of(ends, s_.big)) +
           array("UInt8", "types", 1, bytes_of(types)) + "</Cells><CellData>" +
           array("Int16", "matter", 1, bytes_of(tags, s_.big)) +
           array("Float32", "area", 1, bytes_of(std::vector<float>{1, 2}, s_.big)) + "</CellData>";
    std::string xml = "<?xml version='1.0'?>\n<VTKFile type='UnstructuredGrid' version='1.0' byte_order='" +
                      std::string(s_.big ? "Big" : "Little") + "Endian'";
    if (s_.wide) xml += " header_type='UInt64'";
    if (s_.compressed) xml += " compressor='vtkZLibDataCompressor'";
    xml += "><UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells='2'>" + body +
           "</Piece></UnstructuredGrid>";
    if (s_.appended)
      xml += std::string("<AppendedData encoding='") + (s_.base64 ? "base64" : "raw") + "'>\n _" + appended_ +
             "</AppendedData>";
    return xml + "</VTKFile>\n";
  }

 private:
  std::string number(std::uint64_t value) const {
    if (s_.wide) return bytes_of(std::vector<std::uint64_t>{value}, s_.big);
    return bytes_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)}, s_.big);
  }
  std::string encoded(const std::string& bytes) const { return s_.base64 ? encode_base64(bytes) : bytes; }

  /// Compressed in blocks of 8 bytes, the last one shorter or missing.
  std::string stored(const std::string& bytes) const {
    if (!s_.compressed) return encoded(number(bytes.size()) + bytes);
    std::string header, data;
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
      const std::string block = deflate_zlib(bytes.substr(i, 8));
      header += number(block.size());
      data += block;
    }
    return encoded(number((bytes.size() + 7) / 8) + number(8) + number(bytes.size() % 8) + header) +
           encoded(data);
  }

  std::string array(const std::string& type, const std::string& name, int components,
                    const std::string& bytes) {
    std::string xml = "<DataArray type='" + type + "' Name='" + name + "' NumberOfComponents='" +
                      std::to_string(components) + "' format='";
    if (!s_.appended) return xml + "binary'>\n " + stored(bytes) + "\n</DataArray>";
    xml += "appended' offset='" + std::to_string(appended_.size()) + "'/>";
    appended_ += stored(bytes);
    return xml;
  }

  Storage s_;
  std::string appended_;
};

std::vector<Storage> storages() {
  std::vector<Storage> all;
  for (int bits = 0; bits < 32; ++bits) {
    const Storage s{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
    if (s.appended || s.base64) all.push_back(s);
  }
  return all;
}

TEST(VtuReader, EveryStorageIsRead) {
  for (const Storage& s : storages()) {
    SCOPED_TRACE(::testing::Message() << s.appended << s.base64 << s.compressed << s.wide << s.big);
    const SimplexSoup soup = parse_vtu(VtuMaker(s).make(), "a.vtu");
    expect_the_mesh(soup);
    EXPECT_EQ(soup.warnings.back(), "a.vtu: left out: cell array area");
  }
}

TEST(VtuReader, TruncatedAnywhereIsRefused) {
  for (const Storage& s : storages()) {
    const std::string text = VtuMaker(s).make();
    // What follows the last array of AppendedData is never looked at.
    const std::size_t last = s.appended ? text.find("<AppendedData") : text.find("</VTKFile>");
    for (std::size_t size = 0; size < last; size += 7)
      EXPECT_NE(error_of([&] { parse_vtu(text.substr(0, size), "a.vtu"); }), "") << size;
  }
}

TEST(VtuReader, DamagedBytesNeverCrash) {
  for (const Storage& s : storages()) {
    const std::string text = VtuMaker(s).make();
    for (std::size_t i = 0; i < text.size(); i += 3) {
      std::string damaged = text;
      damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
      SimplexSoup soup;
      if (error_of([&] { soup = parse_vtu(damaged, "a.vtu", {1, 1}); }).empty()) expect_valid(soup);
    }
  }
}

const std::string small_vtu =
    "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='4' "
    "NumberOfCells='1'><Points>\n"
    "<DataArray type='Float64' format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>\n"
    "<DataArray type='Int32' Name='connectivity' format='ascii'>0 1 2 3</DataArray>\n"
    "<DataArray type='Int32' Name='offsets' format='ascii'>4</DataArray>\n"
    "<DataArray type='Int32' Name='types' format='ascii'>10</DataArray>\n"
    "</Cells></Piece></UnstructuredGrid></VTKFile>\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(VtuReader, ErrorsNameTheLineTheArrayOrTheCell) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {replaced(small_vtu, "0 1 2 3", "0 1 2 9"),
       "a.vtu: element 0: the element names point 9 but the file has 4"},
      {replaced(small_vtu, "0 1 2 3", "0 1 2 -3"), "a.vtu: element 0: point number -3 is out of range"},
      {replaced(small_vtu, "0 1 2 3", "0 1 x 3"), "a.vtu:3: 'x' is not a whole number"},
      {replaced(small_vtu, ">4<", ">5<"), "a.vtu: element 0: the cell ends at entry 5"},
      {replaced(small_vtu, ">4<", ">3<"), "the cell has 3 points, too few for a tetrahedron"},
      {replaced(small_vtu, ">10<", ">12<"), "the cell has 4 points, too few for a hexahedron"},
      {replaced(small_vtu, ">10<", ">77777<"), "cell type 77777 of VTK is not read"},
      {replaced(small_vtu, "Points='4'", "Points='400'"), "array 'Points': it has 12 numbers"},
      {replaced(small_vtu, "Cells='1'", "Cells='99999999999'"), "it has 1 numbers for 99999999999 cells"},
      {replaced(small_vtu, "0 0 1<", "0 0 nan<"), "a.vtu: point 3: the point is not finite"},
      {replaced(small_vtu, "</Cells>", "</Cell>"), "a.vtu:6: this is not valid XML"},
      {replaced(small_vtu, "type='Unst", "type='PolyData' was='Unst"), "the file holds a PolyData of VTK"}};
  for (const auto& [text, expected] : cases) {
    const std::string error = error_of([&, &t = text] { parse_vtu(t, "a.vtu"); });
    EXPECT_NE(error.find(expected), std::string::npos) << error;
  }
}

TEST(VtuReader, SeveralPiecesAndOtherCells) {
  const std::string piece = small_vtu.substr(
      small_vtu.find("<Piece"), small_vtu.find("</UnstructuredGrid>") - small_vtu.find("<Piece"));
  std::string other = replaced(piece, "Cells='1'", "Cells='4'");
  other = replaced(other, "0 1 2 3<", "0 1 2 3  0 1 2 3  0 1 2 3  0 1 2 3<");
  other = replaced(other, ">4<", ">4 8 12 16<");
  other = replaced(other, ">10<", ">4 6 9 2<");  // poly-line, strip, quad, poly-vertex
  const SimplexSoup soup =
      parse_vtu(replaced(small_vtu, "</UnstructuredGrid>", other + "</UnstructuredGrid>"), "a.vtu");
  EXPECT_EQ(soup.points.size(), 8U);
  EXPECT_EQ(soup.simplices[1].corners, (std::vector<std::uint32_t>{4, 5, 5, 6, 6, 7}));
  EXPECT_EQ(soup.simplices[0].corners, (std::vector<std::uint32_t>{4, 5, 6, 7}));
  ASSERT_EQ(soup.simplices[2].size(), 3U) << "one triangle of the quad is one of the strip";
  EXPECT_EQ(soup.notes.doubled, 1U);
  EXPECT_EQ(std::vector(soup.simplices[2].corners.begin(), soup.simplices[2].corners.begin() + 6),
            (std::vector<std::uint32_t>{4, 5, 6, 6, 5, 7}));
}

/// The mesh in the legacy format: both kinds of cells, text and binary.
std::string legacy(bool new_cells, bool binary) {
  std::string text = std::string("# vtk DataFile Version ") + (new_cells ? "5.1" : "2.0") + "\na title\n" +
                     (binary ? "BINARY" : "ASCII") + "\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n";
  const auto put = [&](const auto& values) {
    if (binary)
      text += bytes_of(values, true);
    else
      for (const auto value : values) text += std::to_string(value) + " ";
    text += "\n";
  };
  put(points);
  if (new_cells) {
    text += "CELLS 3 7\nOFFSETS vtktypeint64\n";
    put(std::vector<std::int64_t>{0, 4, 7});
    text += "CONNECTIVITY vtktypeint64\n";
    put(std::vector<std::int64_t>(connectivity.begin(), connectivity.end()));
  } else {
    text += "CELLS 2 9\n";
    put(std::vector<std::int32_t>{4, 0, 1, 2, 3, 3, 0, 2, 1});
  }
  text += "CELL_TYPES 2\n";
  put(std::vector<std::int32_t>{10, 5});
  text += "POINT_DATA 4\nSCALARS heat float 1\nLOOKUP_TABLE default\n";
  put(std::vector<float>{1, 2, 3, 4});
  text += "CELL_DATA 2\nSCALARS order int\nLOOKUP_TABLE default\n";
  put(std::vector<std::int32_t>{1, 2});
  text += "FIELD FieldData 1\nmaterial 1 2 short\n";
  put(tags);
  return text;
}

TEST(VtkReader, TextAndBinaryOfOldAndNewFiles) {
  for (const bool new_cells : {false, true})
    for (const bool binary : {false, true}) {
      SCOPED_TRACE(::testing::Message() << new_cells << binary);
      expect_the_mesh(parse_vtk(legacy(new_cells, binary), "a.vtk"));
    }
}

TEST(VtkReader, TruncatedOrDamagedFilesNeverCrash) {
  for (const bool new_cells : {false, true})
    for (const bool binary : {false, true}) {
      const std::string text = legacy(new_cells, binary);
      for (std::size_t i = 0; i < text.size(); ++i) {
        SimplexSoup soup;
        const bool is_cut = error_of([&] { soup = parse_vtk(text.substr(0, i), "a.vtk"); }).empty();
        EXPECT_TRUE(!is_cut || i > text.find("CELL_TYPES")) << i;
        if (is_cut) expect_valid(soup);
        std::string damaged = text;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x31);
        SimplexSoup other;
        if (error_of([&] { other = parse_vtk(damaged, "a.vtk", {1, 1}); }).empty()) expect_valid(other);
      }
    }
}

TEST(VtkReader, OtherDatasetsAndForgedCounts) {
  const auto refusal = [](const std::string& text) { return error_of([&] { parse_vtk(text, "a.vtk"); }); };
  const std::string text = legacy(false, false);
  EXPECT_NE(refusal(replaced(text, "UNSTRUCTURED_GRID", "STRUCTURED_GRID")).find("not 'structured_grid'"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(text, "POINTS 4", "POINTS 4000000000")).find("too short for 4000000000 points"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(text, "CELLS 2 9", "CELLS 2 8")).find("has more points than there are entries"),
            std::string::npos);
}

TEST(Base64, ComesBack) {
  for (const std::string text : {"", "a", "ab", "abc", "abcd", "\xFF\x00\x01"}) {
    std::string back;
    EXPECT_TRUE(decode_base64(encode_base64(text), back));
    EXPECT_EQ(back, text);
  }
  EXPECT_EQ(encode_base64("Man"), "TWFu");
  EXPECT_EQ(encode_base64("Ma"), "TWE=");
  EXPECT_EQ(encode_base64("M"), "TQ==");
  std::string two;
  EXPECT_TRUE(decode_base64("TQ==\n TWFu", two));
  EXPECT_EQ(two, "MMan");
  EXPECT_FALSE(decode_base64("T?Fu", two));
}

}  // namespace
}  // namespace multimesh::io::test
