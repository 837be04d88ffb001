// SPDX-License-Identifier: BSD-3-Clause
// A user's OpenMesh mesh with a texture, decimated by us and by OpenMesh's DecimaterT with quadrics, which
// keeps the texture through our module. Both results are judged by decimate_eval of the shared folder, which
// shares no code with either. Skipped if that is missing.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/openmesh/mod_multimesh.hpp"

namespace multimesh::test {
namespace {

using Json = nlohmann::json;

struct Traits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
};
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

UserMesh read(const std::string& path) {
  const io::PolygonSoup soup = io::read_mesh(path);
  UserMesh mesh;
  for (const auto& p : soup.positions) mesh.add_vertex({p[0], p[1], p[2]});
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    std::vector<OpenMesh::VertexHandle> v;
    for (const auto& c : soup.face(f)) v.emplace_back(c.v);
    for (const auto h : mesh.fh_range(mesh.add_face(v)))
      for (const auto& c : soup.face(f))
        if (c.v == mesh.to_vertex_handle(h).idx()) {
          const auto& uv = soup.texcoords[static_cast<std::size_t>(c.vt)];
          mesh.set_texcoord2D(h, {uv[0], uv[1]});
        }
  }
  return mesh;
}

void write(const UserMesh& mesh, const std::string& path) {
  std::ofstream out(path);
  out.precision(17);
  for (const auto v : mesh.vertices())
    out << "v " << mesh.point(v)[0] << ' ' << mesh.point(v)[1] << ' ' << mesh.point(v)[2] << '\n';
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f))
      out << "vt " << mesh.texcoord2D(h)[0] << ' ' << mesh.texcoord2D(h)[1] << '\n';
  std::size_t vt = 0;
  for (const auto f : mesh.faces()) {
    out << 'f';
    for (const auto h : mesh.fh_range(f)) out << ' ' << mesh.to_vertex_handle(h).idx() + 1 << '/' << ++vt;
    out << '\n';
  }
}

void by_our_costs(openmesh::Attached<UserMesh>& attached, std::size_t faces) {
  DecimateOptions options;
  options.faces = faces;
  (void)decimate(embedding(attached), NodeId::root, options);
}

void by_openmesh(openmesh::Attached<UserMesh>& attached, std::size_t faces) {
  attached.forbid_flips();
  OpenMesh::Decimater::DecimaterT<UserMesh> decimater(attached.mesh());
  openmesh::ModMultimeshT<UserMesh>::Handle module;
  OpenMesh::Decimater::ModQuadricT<UserMesh>::Handle quadric;
  decimater.add(module);
  decimater.module(module).drive(attached);
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
}

class AttachedAgainstEvaluator : public testing::TestWithParam<std::size_t> {
 protected:
  ~AttachedAgainstEvaluator() override {
    for (const std::string& path : written_) std::filesystem::remove(path);
  }
  Json judged(void (*decimate)(openmesh::Attached<UserMesh>&, std::size_t), const std::string& name) {
    const std::string original = std::string(MULTIMESH_EXAMPLE_DATA) + "/spot/spot.obj";
    UserMesh mesh = read(original);
    {
      openmesh::Attached attached(mesh);
      (void)attached.add_texture();
      decimate(attached, mesh.n_faces() / GetParam());
      attached.garbage_collection();
    }
    written_.push_back(testing::TempDir() + name + std::to_string(GetParam()) + ".obj");
    write(mesh, written_.back());
    const std::string command = std::string("'") + MULTIMESH_EVALUATOR + "' '" + original + "' '" +
                                written_.back() + "' --samples 60000";
    std::string out;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (!pipe) return {};
    for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
    return ::pclose(pipe) == 0 ? Json::parse(out) : Json();
  }

 private:
  std::vector<std::string> written_;
};

TEST_P(AttachedAgainstEvaluator, OursIsNearerThanThatOfOpenMesh) {
  if (std::string(MULTIMESH_EVALUATOR).empty()) GTEST_SKIP() << "no evaluator";
  const Json ours = judged(by_our_costs, "ours"), theirs = judged(by_openmesh, "theirs");
  ASSERT_FALSE(ours.is_null());
  ASSERT_FALSE(theirs.is_null());
  EXPECT_LE(ours["decimated"]["faces"], ours["original"]["faces"].get<std::size_t>() / GetParam());
  for (const Json* of : {&ours, &theirs}) {  // what the tree keeps, whoever decides
    EXPECT_EQ((*of)["decimated"]["uv"]["charts"], (*of)["original"]["uv"]["charts"]);
    EXPECT_EQ((*of)["decimated"]["uv"]["seam_junctions"], (*of)["original"]["uv"]["seam_junctions"]);
    EXPECT_LE((*of)["decimated"]["uv"]["flipped"], (*of)["original"]["uv"]["flipped"])
        << (of == &ours ? "ours" : "theirs");
    EXPECT_EQ((*of)["decimated"]["position"]["genus"], (*of)["original"]["position"]["genus"]);
  }
  const auto number = [](const Json& of, const char* group, const char* name) {
    return of[group][name].get<double>();
  };
  for (const auto& [group, name] :
       {std::pair("distance", "rms_rel"), std::pair("texture", "texture_dev_rms")}) {
    std::printf("%s: ours %g, OpenMesh's %g\n", name, number(ours, group, name), number(theirs, group, name));
    EXPECT_LT(number(ours, group, name), number(theirs, group, name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Spot, AttachedAgainstEvaluator, testing::Values(std::size_t{2}, std::size_t{10}),
                         [](const auto& i) { return "OneIn" + std::to_string(i.param); });

}  // namespace
}  // namespace multimesh::test
