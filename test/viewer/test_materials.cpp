// SPDX-License-Identifier: BSD-3-Clause
// Materials and their images, from the files to the page's data.
#include "temporary_directory.hpp"
#include "tools/html_mesh.hpp"
#include "tools/html_textures.hpp"
#include "tools/image_data_uri.hpp"

namespace multimesh::tools::test {
namespace {

using namespace std::string_literals;

const std::string png = "\x89PNG\r\n\x1a\n rest";

class Materials : public InDirectory {
 protected:
  std::vector<files::Material> read(const std::string& mtl) {
    file("sub/m.mtl", mtl);
    return files::read_materials({"sub/m.mtl"}, directory / "in.obj", notes);
  }
  std::vector<std::string> notes;
};

TEST_F(Materials, ColourAndTexture) {
  file("sub/t.png", png);
  const auto m =
      read("Kd 1 1 1\nnewmtl  a b \nKd 0.25 0.5 2\n  map_Kd -s 1 1 1 t.png\r\nnewmtl grey\nkd 0.5\n");
  ASSERT_EQ(m.size(), 2U);
  EXPECT_EQ(m[0].name, "a b");
  EXPECT_EQ(m[0].color, (std::array<float, 3>{0.25F, 0.5F, 1}));
  EXPECT_EQ(m[0].texture, directory / "sub/t.png");
  EXPECT_EQ(m[1].color, (std::array<float, 3>{0.5F, 0.5F, 0.5F}));
  EXPECT_TRUE(m[1].texture.empty());
  EXPECT_TRUE(notes.empty());
}

TEST_F(Materials, TheFirstOfAName) {
  const auto m = read("newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n");
  ASSERT_EQ(m.size(), 1U);
  EXPECT_EQ(m[0].color[0], 1);
}

TEST_F(Materials, TexturesBesideTheObjAndWithBackslashes) {
  file("beside.png", png);
  file("sub/deep.png", png);
  const auto m =
      read("newmtl a\nmap_Kd beside.png\nnewmtl b\nmap_Kd sub\\deep.png\nnewmtl c\nmap_Kd no.png\n");
  EXPECT_EQ(m[0].texture, directory / "beside.png");
  EXPECT_EQ(m[1].texture, directory / "sub/deep.png");
  EXPECT_EQ(m[2].texture, directory / "sub/no.png") << "where it should have been";
}

TEST_F(Materials, AMissingLibraryIsNoted) {
  EXPECT_TRUE(files::read_materials({"none.mtl"}, directory / "in.obj", notes).empty());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("none.mtl"), std::string::npos);
}

TEST_F(Materials, PerTriangleInTheOrderOfTheMesh) {
  file("m.mtl", "newmtl red\nKd 1 0 0\n");
  file("in.obj",
       "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nusemtl red\nf 2 4 3\nusemtl none\nf 4 2 "
       "1\n");
  const files::SurfaceFile in = files::read_surface(directory / "in.obj");
  const HtmlMesh mesh = html_mesh(in);
  ASSERT_EQ(mesh.materials.size(), 3U);
  EXPECT_EQ(mesh.material, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.materials[1].color, (std::array<float, 3>{1, 0, 0}));
  EXPECT_EQ(mesh.materials[2].name, "none");
  EXPECT_EQ(mesh.notes.size(), 1U);

  TexturedTriangles part = in.input;
  part.triangles = {in.input.triangles[1], in.input.triangles[0]};
  EXPECT_EQ(html_mesh(part, {1, 0}, in).material, (std::vector<Index>{0, 1}));
  EXPECT_EQ(html_mesh(part, {1, 0}, in).materials[0].name, "red");
}

TEST_F(Materials, ImagesAreToldByTheirContent) {
  EXPECT_EQ(image_type(png), "image/png");
  EXPECT_EQ(image_type("\xff\xd8\xff\xe0"), "image/jpeg");
  EXPECT_EQ(image_type("RIFF1234WEBPVP8 "), "image/webp");
  EXPECT_EQ(image_type("RIFF1234WAVEfmt "), "");
  EXPECT_EQ(image_type("GIF89a"), "image/gif");
  EXPECT_EQ(image_type("BM"), "image/bmp");
  EXPECT_EQ(image_type("\0\0\2"s), "");
  EXPECT_EQ(image_type(""), "");
  const ImageDataUri uri = image_data_uri(file("named.tga", png));
  EXPECT_TRUE(uri.uri.starts_with("data:image/png;base64,iVBORw0KGg"));
}

TEST_F(Materials, ImagesThatCannotBeShown) {
  EXPECT_NE(image_data_uri(directory / "no.png").problem, "");
  EXPECT_NE(image_data_uri(directory / "sub").problem, "");
  EXPECT_NE(image_data_uri(file("t.tga", "\0\0\2"s)).problem, "");
  const auto large = file("large.png", png + std::string(100, ' '));
  EXPECT_NE(image_data_uri(large, 100).problem, "");
  EXPECT_EQ(image_data_uri(large, 200).problem, "");
}

TEST_F(Materials, EachImageOnceAndUpToALimit) {
  const auto a = file("a.png", png), b = file("b.png", png + std::string(100, ' '));
  HtmlTextures textures(100);
  EXPECT_EQ(textures.number(a), 0U);
  EXPECT_EQ(textures.number(b), 1U);
  EXPECT_EQ(textures.number(directory / "sub/../a.png"), 0U);
  ASSERT_EQ(textures.uris().size(), 2U);
  EXPECT_NE(textures.uris()[0], "");
  EXPECT_EQ(textures.uris()[1], "");
  ASSERT_EQ(textures.notes().size(), 1U);
  EXPECT_NE(textures.notes()[0].find("b.png"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::tools::test
