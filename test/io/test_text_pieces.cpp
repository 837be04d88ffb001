// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "adapters/io/file_bytes.hpp"
#include "io_fixture.hpp"
#include "multimesh/io/obj_reader.hpp"

namespace multimesh::io::test {
namespace {

class TextPiecesTest : public IoTest {
 protected:
  std::vector<std::string> pieces(const std::string& text, std::size_t least) const {
    TextPieces in(file("a.txt", text), least);
    std::vector<std::string> all;
    for (std::string_view piece; !(piece = in.next()).empty();) all.emplace_back(piece);
    return all;
  }
};

using Pieces = std::vector<std::string>;

TEST_F(TextPiecesTest, EndWithLines) {
  EXPECT_EQ(pieces("one\ntwo\nthree\nfour\n", 4), (Pieces{"one\ntwo\n", "three\n", "four\n"}));
}

TEST_F(TextPiecesTest, AreAsLongAsALineNeeds) {
  EXPECT_EQ(pieces("a line of twenty-six letters\nb\n", 2), (Pieces{"a line of twenty-six letters\nb\n"}));
  EXPECT_EQ(pieces("a\rb\rc\rd\re\rf\rg\r", 2), (Pieces{"a\rb\rc\rd\re\rf\rg\r"}));
}

TEST_F(TextPiecesTest, DoNotEndInALineThatGoesOn) {
  EXPECT_EQ(pieces("ab\\\ncd\\\r\nef\nghijklmn\n", 2), (Pieces{"ab\\\ncd\\\r\nef\n", "ghijklmn\n"}));
}

TEST_F(TextPiecesTest, AreNoneOfAnEmptyFile) {
  EXPECT_EQ(pieces("", 4), Pieces{});
  EXPECT_EQ(pieces("x", 4), Pieces{"x"});
}

TEST_F(TextPiecesTest, AreTheFileInOrder) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 200, ' ');
    for (char& c : text) c = "abc \\\r\n"[random() % 7];
    const std::size_t least = 1 + random() % 40;
    std::string all;
    const Pieces found = pieces(text, least);
    for (std::size_t p = 0; p < found.size(); ++p) {
      all += found[p];
      if (p + 1 == found.size()) continue;
      EXPECT_GE(found[p].size(), least);
      EXPECT_EQ(found[p].back(), '\n');
      EXPECT_FALSE(found[p].ends_with("\\\n") || found[p].ends_with("\\\r\n"));
    }
    ASSERT_EQ(all, text) << "least " << least;
  }
}

TEST_F(TextPiecesTest, NameTheFileThatIsMissing) {
  EXPECT_NE(error_of([&] { TextPieces(directory / "none.obj"); }).find("none.obj"), std::string::npos);
}

/// Larger than several pieces, with lines of all kinds.
std::string large_obj(int vertices) {
  std::string text = "\xEF\xBB\xBF# large\r\nmtllib a.mtl\n";
  for (int i = 0; i < vertices; ++i) {
    const std::string n = std::to_string(i);
    text += "v " + n + " " + std::to_string(i * i % 1001) + (i % 7 == 0 ? " \\\n" : " ") +
            std::to_string(i % 13) + ".25\n";
    if (i % 3 == 0) text += "vt 0." + n + " 1e-" + std::to_string(i % 9) + "\r\n";
    if (i % 500 == 499)
      text += "usemtl m" + n + "\n# " + std::string(static_cast<std::size_t>(i), '-') + "\n";
    if (i > 2) text += "f -1/-1 -2/-1 " + std::to_string(i - 1) + "\n";
  }
  return text;
}

TEST_F(TextPiecesTest, GiveTheMeshOfTheWholeText) {
  const std::string text = large_obj(20000);
  ASSERT_GT(text.size(), std::size_t{1} << 20U);
  const PolygonSoup whole = parse_obj(text, "a.obj"), pieced = read_obj(file("a.obj", text));
  EXPECT_EQ(pieced.positions, whole.positions);
  EXPECT_EQ(pieced.texcoords, whole.texcoords);
  EXPECT_EQ(pieced.corners, whole.corners);
  EXPECT_EQ(pieced.face_begin, whole.face_begin);
  EXPECT_EQ(pieced.face_line, whole.face_line);
  EXPECT_EQ(pieced.face_section, whole.face_section);
  EXPECT_EQ(pieced.sections, whole.sections);
  EXPECT_EQ(pieced.notes, whole.notes);
}

TEST_F(TextPiecesTest, NumberTheLinesOfTheFile) {
  const std::string text = large_obj(20000);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  const std::string error = error_of([&] { read_obj(file("a.obj", text + "f 1 2\n")); });
  EXPECT_NE(error.find(":" + std::to_string(lines + 1) + ":"), std::string::npos) << error;
}

}  // namespace
}  // namespace multimesh::io::test
