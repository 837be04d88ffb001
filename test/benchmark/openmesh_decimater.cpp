// SPDX-License-Identifier: BSD-3-Clause
// openmesh_decimater IN.obj OUT.obj RATIO: a whole program around OpenMesh's own decimater, with quadrics and
// no normal turned over. Positions only. What a user of OpenMesh has today; figures.py measures it beside
// ours.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <charconv>
#include <exception>
#include <iostream>
#include <string_view>

#include "test/benchmark/plain_obj.hpp"

namespace multimesh::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = Vec3;
  using Normal = Vec3;
};
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

TriMesh mesh_of(const PlainObj& obj) {
  TriMesh mesh;
  const std::size_t v = obj.positions.size(), f = obj.faces.size();
  mesh.reserve(v, v + f, f);
  for (const auto& p : obj.positions) mesh.add_vertex(Vec3(p[0], p[1], p[2]));
  const auto vertex = [](std::uint32_t i) { return OpenMesh::VertexHandle(static_cast<int>(i)); };
  for (const auto& [a, b, c] : obj.faces) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

void decimate(TriMesh& mesh, std::size_t faces) {
  mesh.request_face_normals();
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<TriMesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle normal_flipping;
  decimater.add(quadric);
  decimater.add(normal_flipping);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  mesh.garbage_collection();
}

PlainObj obj_of(const TriMesh& mesh) {
  PlainObj obj;
  for (const auto v : mesh.vertices())
    obj.positions.push_back({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
  for (const auto f : mesh.faces()) {
    auto& corners = obj.faces.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) corners[k++] = static_cast<std::uint32_t>(v.idx());
  }
  return obj;
}

double ratio_of(std::string_view text) {
  double ratio = 0;
  std::from_chars(text.data(), text.data() + text.size(), ratio);
  return ratio;
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) try {
  using namespace multimesh::bench;
  const double ratio = argc == 4 ? ratio_of(argv[3]) : 0;
  if (ratio <= 0 || ratio > 1) {
    std::cerr << "Usage: openmesh_decimater IN.obj OUT.obj RATIO\n";
    return 2;
  }
  TriMesh mesh = mesh_of(read_plain_obj(argv[1]));
  decimate(mesh, static_cast<std::size_t>(ratio * static_cast<double>(mesh.n_faces())));
  write_plain_obj(argv[2], obj_of(mesh));
} catch (const std::exception& e) {
  std::cerr << "openmesh_decimater: " << e.what() << '\n';
  return 1;
}
